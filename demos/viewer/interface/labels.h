#pragma once

#include "viewer/graphics/scene.h"
#include "viewer/interface/view_state.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// Writes a contender's labels into its view: colour, name, state, and the names of the arrows.
void draw_labels(const Session& session, const Scene& scene, const OrbitCamera& camera, bool is_teaching,
                 const Rectangle& viewport, std::size_t index);

/// Returns the height of the status above the views: time, speed and the session's notice, which gets its own
/// line if it is long.
float status_height(const Session& session, float width);
void draw_status(const Session& session, const Rectangle& area);

}  // namespace polhode::demos
