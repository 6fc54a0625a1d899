#pragma once

#include "viewer/model/options.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Shows the session in a window until the window is closed.
/// @throws std::runtime_error if no window can be opened; Interrupted
void show_window(Session& session, const ViewerOptions& options);

}  // namespace polhode::demos
