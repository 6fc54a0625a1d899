#pragma once

namespace polhode::run_test {

/// A world that no plugin can be attached to. Returns what is left of its body's rotational energy.
double step_a_deformable_world();

/// Likewise: its island manager is of the program's own class.
double step_a_world_with_its_own_islands();

/// Likewise, but the manager comes after the first step.
double step_a_world_that_gets_its_own_islands();

/// Steps a world of each kind that a plugin can be attached to. Returns what the worst keeps of its body's energy.
double step_each_kind_of_world();

/// A world with a multibody without links, and a rigid body.
void step_a_multibody();

}  // namespace polhode::run_test
