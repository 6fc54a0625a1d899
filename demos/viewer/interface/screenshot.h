#pragma once

#include "viewer/graphics/image.h"
#include "viewer/model/options.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// The session as it is shown, drawn without a display, or in a window that is not shown.
/// @throws std::runtime_error if there is no OpenGL.
Image take_screenshot(Session& session, const ViewerOptions& options);

}  // namespace polhode::demos
