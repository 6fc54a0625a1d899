#include "bullet/body/external_changes.h"
#include "bullet/world/world_stepper.h"
#include "polhode/bullet/conversions.h"
#include "polhode/rotation_math.h"

// The part of WorldStepper that handles torque laws and rotors.
namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Keeps L_W if the change is by a motor, else omega_W. A body takes no momentum about an axis without inverse
// inertia.
void change_rotor(const btVector3& inverse_inertia_B, const Vector3& rotor_momentum_B, RotorChange change,
                  RotationState& state) {
  const Vector3 inverse_B = to_double(inverse_inertia_B);
  const Vector3 change_B = rotor_momentum_B - state.rotor_momentum_B;
  if (change == RotorChange::from_outside) {
    state.L_W += state.R_WB * change_B;
    state.rotor_momentum_B = rotor_momentum_B;
  } else if ((inverse_B.array() != 0.0).all()) {
    change_rotor_by_motor(moments_B(inverse_inertia_B), rotor_momentum_B, state);
  } else {
    state.rotor_momentum_B = rotor_momentum_B;
    set_omega(state, moments_B(inverse_inertia_B),
              state.omega_W - state.R_WB * inverse_B.cwiseProduct(change_B));
  }
}

RotationState state_of(const btRigidBody& body, const Drive& drive) {
  RotationState state;
  set_orientation(state, to_quaternion(body.getWorldTransform().getBasis()));
  state.rotor_momentum_B = drive.rotor_momentum_B;
  set_omega(state, moments_B(body.getInvInertiaDiagLocal()), to_double(body.getAngularVelocity()));
  return state;
}

}  // namespace

Drive& WorldStepper::make_drive(btRigidBody& body) {
  world();
  if (Drive* const drive = choices_.treatment_of(body).drive) return *drive;
  choices_.reserve(body);
  auto drive = std::make_unique<Drive>();
  Drive& made = *drive;
  change_drive(body, &made);
  choices_.set_drive(body, std::move(drive));
  return made;
}

void WorldStepper::drop_idle_drive(btRigidBody& body) {
  const Drive* const drive = choices_.treatment_of(body).drive;
  if (drive == nullptr || drive->law != nullptr || drive->has_rotors()) return;
  change_drive(body, nullptr);
  choices_.set_drive(body, nullptr);
}

void WorldStepper::change_drive(btRigidBody& body, Drive* drive) {
  if (!claim_.holds()) return;
  synchronize_all();
  const Treatment treatment = {choices_.treatment_of(body).scheme, drive};
  rigid_.registry.drive(body, treatment);
  of_multibodies_.registry.drive(body, treatment);
}

void WorldStepper::set_rotor_momentum(btRigidBody& body, const Vector3& rotor_momentum_B,
                                      RotorChange change) {
  Drive& drive = *choices_.treatment_of(body).drive;
  BodyRegistry::Lane place = find(body);
  if (place.batch == nullptr) place = of_multibodies_.registry.find(body, choices_);
  const bool has_state = place.batch != nullptr && !place.batch->diverged[place.lane];
  if (has_state) adopt_external_changes(*place.batch, place.lane);
  RotationState state = has_state ? place.batch->state(place.lane) : state_of(body, drive);
  change_rotor(body.getInvInertiaDiagLocal(), rotor_momentum_B, change, state);
  drive.rotor_momentum_B = rotor_momentum_B;
  if (has_state) place.batch->set_state(place.lane, state);
  if (change == RotorChange::from_outside) return;
  body.setAngularVelocity(to_bullet(state.omega_W));
  if (has_state) set_vector_in_lane(place.lane, body.getAngularVelocity(), place.batch->written_omega_W);
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
