#pragma once

/// OpenGL 3.3, its functions linked from the dispatching library that also EGL and GLFW go through.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>
