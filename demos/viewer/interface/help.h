#pragma once

namespace polhode::demos {

/// Draws the list of keys in the middle of a picture of this size.
void draw_help(float width, float height);

}  // namespace polhode::demos
