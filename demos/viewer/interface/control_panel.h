#pragma once

#include "viewer/interface/view_state.h"
#include "viewer/model/session.h"
#include "viewer/model/view_grid.h"

namespace polhode::demos {

/// Draws the controls of scenario, contenders, changes, playback and export.
void draw_control_panel(Session& session, ViewState& view, const Rectangle& area);

}  // namespace polhode::demos
