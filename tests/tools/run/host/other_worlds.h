#pragma once

namespace polhode::run_test {

/// Steps a world to which no plugin can be attached. Returns the ratio of final to initial rotational energy.
double step_a_deformable_world();

/// Does the same for a world with an island manager class of the program's own.
double step_a_world_with_its_own_islands();

/// Does the same, but replaces the island manager after the first step.
double step_a_world_that_gets_its_own_islands();

/// Steps a world of each kind to which a plugin can be attached. Returns the worst energy ratio.
double step_each_kind_of_world();

/// Steps a world with a rigid body and a multibody without links.
void step_a_multibody();

}  // namespace polhode::run_test
