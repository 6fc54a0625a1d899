#pragma once

#include "viewer/graphics/scene.h"
#include "viewer/interface/view_state.h"
#include "viewer/model/session.h"

namespace polhode::demos {

/// What is written in a contender's view: colour, name, how it fares, and the names of the arrows.
void draw_labels(const Session& session, const Scene& scene, const OrbitCamera& camera, bool is_teaching,
                 const Rectangle& viewport, std::size_t index);

/// The line above the views: time, speed and what is to be said.
void draw_status(const Session& session, const Rectangle& line);

}  // namespace polhode::demos
