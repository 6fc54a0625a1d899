#pragma once

namespace polhode::demos {

/// The keys, in the middle of a picture of that size.
void draw_help(float width, float height);

}  // namespace polhode::demos
