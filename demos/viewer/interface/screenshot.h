#pragma once

#include "viewer/graphics/image.h"
#include "viewer/model/options.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Returns a picture of the session, drawn without a display, or in a hidden window.
/// @throws std::runtime_error if OpenGL is not available
Image take_screenshot(Session& session, const ViewerOptions& options);

}  // namespace polhode::demos
