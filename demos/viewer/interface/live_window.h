#pragma once

#include "viewer/model/options.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Shows the session in a window until that is closed.
/// @throws std::runtime_error if there is no window to be had; Interrupted
void show_window(Session& session, const ViewerOptions& options);

}  // namespace polhode::demos
