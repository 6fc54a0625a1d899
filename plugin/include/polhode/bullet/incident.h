#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <functional>
#include <string_view>

#include "polhode/bullet/precision.h"

class btMultiBody;

namespace polhode {
inline namespace POLHODE_PRECISION {

enum class IncidentKind : std::uint8_t {
  scheme_diverged,  ///< the scheme's result is not finite or exceeds the limits of rotation_limits.h
  non_finite_body,  ///< the body's pose, velocity or forces held a NaN or infinity, which was replaced
  /// The body's torque law threw, returned a value that is not finite, or returned a torque on rotors that
  /// the scheme does not take. The step was taken without the law.
  torque_law_failed,
};

/// Returns "scheme diverged", "non-finite body" or "torque law failed".
std::string_view to_string(IncidentKind kind);

struct Incident {
  IncidentKind kind;
  btRigidBody* body;         ///< null for a multibody
  btMultiBody* multibody;    ///< null for a rigid body
  std::uint64_t body_steps;  ///< number of steps that the body has taken with its scheme
};

/// Called at the end of a step, after all bodies have moved, once for each body and kind of incident. The
/// handler may set another scheme for the body, release the body, or remove it from the world. Exceptions
/// from the handler are discarded.
using IncidentHandler = std::function<void(const Incident&)>;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
