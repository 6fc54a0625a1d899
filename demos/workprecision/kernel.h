#pragma once

#include <cstdint>
#include <memory>

#include "polhode/rotation_state.h"
#include "record/contender.h"

namespace polhode::demos {

/// A free body at its start.
struct FreeBody {
  Vector3 inertia_B{1.0, 2.0, 3.0};
  Quaternion q_WB = Quaternion::Identity();
  Vector3 omega_W{3.0, 2.0, 4.0};
};

/// Selects whether the body is kicked in every step, as by a contact. The kick is too small to alter the
/// motion, but the kernel cannot skip it.
enum class Kick { none, every_step };

/// One contender's step of one body, without world, solver and collisions.
class Kernel {
 public:
  Kernel() = default;
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  virtual ~Kernel() = default;

  /// Goes back to the start.
  virtual void restart() = 0;
  virtual void run(std::int64_t steps) = 0;
  virtual RotationState state() const = 0;

  /// Return the moments and the time step after Bullet's rounding.
  virtual Vector3 inertia_B() const = 0;
  virtual double dt_s() const = 0;
};

/// rad/s on each axis.
inline constexpr double kKick = 1e-13;

std::unique_ptr<Kernel> make_kernel(const Contender& contender, const FreeBody& body, double dt_s,
                                    Kick kick = Kick::none);

std::unique_ptr<Kernel> make_scheme_kernel(const SchemePointer& scheme, const FreeBody& body, double dt_s,
                                           Kick kick);

/// Makes a kernel that rotates a free body as btDiscreteDynamicsWorld does with this gyroscopic flag, bit for
/// bit.
std::unique_ptr<Kernel> make_bullet_kernel(BulletMode mode, const FreeBody& body, double dt_s, Kick kick);

/// Makes a kernel that rotates a free multibody without links as btMultiBodyDynamicsWorld does, bit for bit.
std::unique_ptr<Kernel> make_multibody_kernel(const FreeBody& body, double dt_s, Kick kick);

}  // namespace polhode::demos
