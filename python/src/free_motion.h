#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "record/sample.h"
#include "scheme_base/driven_step.h"

namespace polhode::python {

/// One body without Bullet.
struct FreeMotion {
  const RotationScheme& scheme;
  Vector3 inertia_B;
  RotationState start;
  Vector3 position_W;  ///< m
  double dt;           ///< s
  std::int64_t steps;
  Drive drive;
};

/// The first step whose end is not within the limits (rotation_limits.h), if there is one.
using Divergence = std::optional<std::int64_t>;

/// Steps the body to the end or to the divergence. `observe` sees the start and each sample after it.
/// @throws std::runtime_error if the law returns a torque that is not finite or that the scheme cannot take
Divergence run_free_motion(FreeMotion motion, const std::function<void(const demos::Sample&)>& observe);

}  // namespace polhode::python
