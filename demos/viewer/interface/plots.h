#pragma once

#include "viewer/model/session.h"
#include "viewer/model/view_grid.h"

namespace polhode::demos {

/// Draws every quantity over time, a curve for each contender.
void draw_plots(const Session& session, const Rectangle& area);

}  // namespace polhode::demos
