#pragma once

/// OpenGL 3.3, linked from the dispatching library that EGL and GLFW use too.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>
