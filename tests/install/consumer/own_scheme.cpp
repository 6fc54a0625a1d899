// A rotation scheme written by the application, used like a built-in one.
#include <polhode/bullet/rotation_world.h>
#include <polhode/rotation_math.h>

#include <cmath>
#include <memory>

#include "consumer.h"

namespace {

/// Turns a body about the world's z axis by a tenth of a radian per step, whatever the angular velocity.
class Turntable final : public polhode::RotationScheme {
 public:
  polhode::SchemeDescription description() const noexcept override {
    polhode::SchemeDescription description;
    description.name = "turntable";
    return description;
  }

  void step(const polhode::StepInput& /*input*/, polhode::RotationState& state) const noexcept override {
    const polhode::Quaternion turn = polhode::exponential({0.0, 0.0, 0.1});
    polhode::set_orientation(state, turn * state.q_WB);
  }
};

}  // namespace

void rotates_a_body_by_a_scheme_of_the_application() {
  WorldParts parts;
  parts.body.setAngularVelocity({0, 0, 0});
  polhode::RotationWorld<btDiscreteDynamicsWorld> world(&parts.dispatcher, &parts.broadphase, &parts.solver,
                                                        &parts.configuration);
  world.addRigidBody(&parts.body);
  world.rotation().set_scheme(parts.body, std::make_shared<Turntable>());
  for (int step = 0; step < 20; ++step) world.stepSimulation(btScalar(1) / 60, 0);

  const polhode::BodyRotation rotation = world.rotation().rotation_of(parts.body);
  REQUIRE(rotation.scheme == "turntable");
  REQUIRE(rotation.steps == 20);
  REQUIRE(std::abs(2 * std::atan2(rotation.state.q_WB.z(), rotation.state.q_WB.w()) - 2.0) < 1e-14);
  REQUIRE(std::abs(parts.body.getWorldTransform().getBasis()[0][0] - btScalar(std::cos(2.0))) <
          btScalar(1e-6));
  world.removeRigidBody(&parts.body);
}
