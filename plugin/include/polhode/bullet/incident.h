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
  scheme_diverged,  ///< the scheme left the finite or went past the bounds of rotation_limits.h
  non_finite_body,  ///< a NaN or infinity was found in the body's pose, velocity or forces and was taken out
  /// The body's torque law threw, or returned what is not finite, or turned rotors of a scheme that takes none: the
  /// step went on without it.
  torque_law_failed,
};

/// "scheme diverged", "non-finite body" or "torque law failed".
std::string_view to_string(IncidentKind kind);

struct Incident {
  IncidentKind kind;
  btRigidBody* body;         ///< null if it is a multibody
  btMultiBody* multibody;    ///< null if it is a rigid body
  std::uint64_t body_steps;  ///< steps the body had taken with its scheme
};

/// Called at the end of a step, when its bodies are done; once for each body and kind. The handler may choose
/// another scheme for the body, release it or take it out of the world. An exception from the handler is
/// dropped.
using IncidentHandler = std::function<void(const Incident&)>;

}  // namespace POLHODE_PRECISION
}  // namespace polhode
