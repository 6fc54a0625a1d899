#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <cstring>

#include "polhode/bullet/rotation_control.h"

namespace polhode::testing {

/// A hash of every bit added (FNV-1a on 64-bit words).
class Digest {
 public:
  std::uint64_t value() const { return value_; }

  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3u;
    value_ ^= value_ >> 32;
  }

  void add(double number) {
    std::uint64_t word = 0;
    std::memcpy(&word, &number, sizeof(word));
    add(word);
  }

  void add(const btRigidBody& body) {
    for (int row = 0; row < 3; ++row) add(body.getWorldTransform().getBasis()[row]);
    add(body.getWorldTransform().getOrigin());
    add(body.getLinearVelocity());
    add(body.getAngularVelocity());
    add(static_cast<std::uint64_t>(body.getActivationState()));
  }

  void add(const BodyRotation& rotation) {
    for (const double number : rotation.state.q_WB.coeffs()) add(number);
    for (const double number : rotation.state.R_WB.reshaped()) add(number);
    for (const double number : rotation.state.omega_W) add(number);
    for (const double number : rotation.state.L_W) add(number);
    add(rotation.energy_J);
    add(rotation.steps);
    add(static_cast<std::uint64_t>(rotation.diverged));
  }

 private:
  // Skips the fourth component, which Bullet leaves undefined. Converting float to double is exact.
  void add(const btVector3& vector) {
    for (int axis = 0; axis < 3; ++axis) add(static_cast<double>(vector.m_floats[axis]));
  }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace polhode::testing
