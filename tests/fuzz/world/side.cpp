#include "fuzz/world/side.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <sanitizer/asan_interface.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "polhode/bullet/rotation_world.h"

namespace polhode::fuzz {

namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);
Side* side_in_step = nullptr;  // Bullet's contact callback has no argument to find it by

bool is_finite(const btVector3& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool is_finite(const btMatrix3x3& m) {
  return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]);
}

bool is_finite(const btRigidBody& body) {
  return is_finite(body.getWorldTransform().getBasis()) && is_finite(body.getWorldTransform().getOrigin()) &&
         is_finite(body.getLinearVelocity()) && is_finite(body.getAngularVelocity()) &&
         is_finite(body.getInvInertiaTensorWorld());
}

// A mass or moment whose inverse is a number: no library can turn a body without one. 0 is allowed where it
// means that the body does not turn about the axis.
btScalar inertia(btScalar x, bool zero_is_allowed) {
  const btScalar size = std::abs(x);
  if (size == 0 && zero_is_allowed) return 0;
  return std::isfinite(size) && std::isnormal(1 / size) ? size : btScalar(1);
}

btVector3 moments(const btVector3& v) {
  return {inertia(v.x(), true), inertia(v.y(), true), inertia(v.z(), true)};
}

btQuaternion orientation(const btVector3& v, btScalar x) {
  const btQuaternion q(v.x(), v.y(), v.z(), x);
  const btScalar length2 = q.length2();
  const bool is_usable = std::isfinite(length2) && length2 > btScalar(1e-6);
  return is_usable ? q.normalized() : btQuaternion::getIdentity();
}

const SchemePointer& scheme(std::size_t variant) {
  return built_in_schemes()[variant % built_in_schemes().size()];
}

class ShownPose final : public btMotionState {
 public:
  ShownPose(Side& side, const btTransform& start) : side_(side), pose_(start) {}
  void getWorldTransform(btTransform& pose) const override { pose = pose_; }
  void setWorldTransform(const btTransform& pose) override {
    pose_ = pose;
    side_.in_step(Place::motion_state);
  }

 private:
  Side& side_;
  btTransform pose_;
};

class ScriptedAction final : public btActionInterface {
 public:
  explicit ScriptedAction(Side& side) : side_(side) {}
  void updateAction(btCollisionWorld* /*world*/, btScalar /*dt*/) override { side_.in_step(Place::action); }
  void debugDraw(btIDebugDraw* /*drawer*/) override {}

 private:
  Side& side_;
};

void before_tick(btDynamicsWorld* world, btScalar /*dt*/) {
  static_cast<Side*>(world->getWorldUserInfo())->in_step(Place::before);
}

void after_tick(btDynamicsWorld* world, btScalar /*dt*/) {
  static_cast<Side*>(world->getWorldUserInfo())->in_step(Place::after);
}

bool contact_processed(btManifoldPoint& /*point*/, void* a, void* b) {
  const auto body = [](void* object) { return btRigidBody::upcast(static_cast<btCollisionObject*>(object)); };
  if (side_in_step != nullptr) side_in_step->in_step(Place::contact, body(a), body(b));
  return true;
}

btDefaultCollisionConstructionInfo small_pools() {
  constexpr int kPool = 64;
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = kPool;
  info.m_defaultMaxCollisionAlgorithmPoolSize = kPool;
  return info;
}

}  // namespace

void fail(const std::string& what) {
  std::fprintf(stderr, "world fuzzer: %s\n", what.c_str());
  std::abort();
}

std::string numbers(const btRigidBody& body) {
  std::string numbers;
  const auto append = [&numbers](const btVector3& v) {
    for (int i = 0; i < 3; ++i) numbers += ' ' + std::to_string(v[i]);
    numbers += ';';
  };
  for (int row = 0; row < 3; ++row) append(body.getWorldTransform().getBasis()[row]);
  append(body.getWorldTransform().getOrigin());
  append(body.getLinearVelocity());
  append(body.getAngularVelocity());
  for (int row = 0; row < 3; ++row) append(body.getInvInertiaTensorWorld()[row]);
  return numbers + " activation " + std::to_string(body.getActivationState());
}

void Slot::make(const btRigidBody::btRigidBodyConstructionInfo& info, bool in_place) {
  if (in_place) {
    ASAN_UNPOISON_MEMORY_REGION(memory_.data(), memory_.size());
    body_ = new (memory_.data()) btRigidBody(info);
  } else {
    heap_ = std::make_unique<btRigidBody>(info);
    body_ = heap_.get();
  }
  flags = body_->getFlags();
}

void Slot::destroy() {
  if (body_ == nullptr) return;
  if (heap_ == nullptr) {
    body_->~btRigidBody();
    ASAN_POISON_MEMORY_REGION(memory_.data(), memory_.size());
  }
  heap_.reset();
  body_ = nullptr;
  motion_state.reset();
}

struct Side::World {
  explicit World(Side& side) : action(side) {}

  btDefaultCollisionConfiguration configuration{small_pools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  ScriptedAction action;
  std::unique_ptr<btDiscreteDynamicsWorld> world;
  RotationControl* rotation = nullptr;
  std::unique_ptr<RotationPlugin> plugin;
  std::uint64_t incidents = 0;
  std::uint64_t reports = 0;
};

Side::Side(Way way, const Limits& limits) : way_(way), limits_(limits) {
  shapes_.push_back(std::make_unique<btBoxShape>(btVector3(btScalar(0.3), btScalar(0.4), btScalar(0.5))));
  shapes_.push_back(std::make_unique<btSphereShape>(btScalar(0.5)));
  shapes_.push_back(std::make_unique<btCapsuleShape>(btScalar(0.3), 1));
  shapes_.push_back(std::make_unique<btCylinderShape>(btVector3(btScalar(0.3), 1, btScalar(0.3))));
  shapes_.push_back(std::make_unique<btBoxShape>(btVector3(20, 20, 1)));
  make_world(0);
}

Side::~Side() {
  for (Joint& joint : joints_) unjoin(joint);
  for (Slot& slot : slots_) remove(slot);
  for (std::unique_ptr<World>& world : worlds_) {
    if (world == nullptr) continue;
    world->world->removeAction(&world->action);
    world->plugin.reset();
  }
}

void Side::make_world(std::size_t index) {
  worlds_[index] = std::make_unique<World>(*this);
  World& made = *worlds_[index];
  if (way_ == Way::rotation_world) {
    auto world = std::make_unique<RotationWorld<btDiscreteDynamicsWorld>>(&made.dispatcher, &made.broadphase,
                                                                          &made.solver, &made.configuration);
    made.rotation = &world->rotation();
    made.world = std::move(world);
  } else {
    made.world = std::make_unique<btDiscreteDynamicsWorld>(&made.dispatcher, &made.broadphase, &made.solver,
                                                           &made.configuration);
  }
  if (way_ == Way::plugin) {
    made.plugin = std::make_unique<RotationPlugin>(*made.world);
    made.rotation = &made.plugin->rotation();
  }
  made.world->setInternalTickCallback(before_tick, this, true);
  made.world->setInternalTickCallback(after_tick, this, false);
  made.world->addAction(&made.action);
  choices_[index].fill(Choice::unset);
  has_default_[index] = true;
  if (made.rotation == nullptr) return;
  if (!limits_.managed) {
    made.rotation->clear_default_scheme();
    has_default_[index] = false;
  }
  made.rotation->set_incident_handler([this, &made, index](const Incident& incident) {
    ++made.reports;
    if (incident.kind == IncidentKind::non_finite_body) has_seen_non_finite_ = true;
    for (const Slot& slot : slots_) {
      if (slot.body() == incident.body && slot.world == static_cast<int>(index)) return;
    }
    fail("an incident names a body that is not in the world");
  });
}

const RotationControl* Side::rotation(std::size_t world) const {
  return worlds_[world] == nullptr ? nullptr : worlds_[world]->rotation;
}

std::vector<std::pair<int, int>> Side::pairs(std::size_t world) const {
  std::vector<std::pair<int, int>> pairs;
  if (worlds_[world] == nullptr) return pairs;
  const auto slot_of = [](const btBroadphaseProxy* proxy) {
    return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
  };
  const btBroadphasePairArray& found = worlds_[world]->world->getPairCache()->getOverlappingPairArray();
  for (int i = 0; i < found.size(); ++i)
    pairs.emplace_back(slot_of(found[i].m_pProxy0), slot_of(found[i].m_pProxy1));
  return pairs;
}

void Side::apply(const Operation& operation) {
  const std::size_t index = operation.world;
  if (worlds_[index] == nullptr) make_world(index);
  World& world = *worlds_[index];
  Slot& slot = slots_[operation.slot];
  switch (operation.kind) {
    case Kind::add:
      if (slot.body() == nullptr) add(operation, slot);
      return;
    case Kind::remove:
      remove(slot);
      return;
    case Kind::put_back:
      if (slot.body() != nullptr && slot.world == Slot::kLimbo) put(slot, index);
      return;
    case Kind::erase:
      remove(slot);
      slot.destroy();
      for (auto& choices : choices_) choices[operation.slot] = Choice::unset;
      return;
    case Kind::choose_scheme:
    case Kind::release:
    case Kind::use_default_scheme:
      if (slot.body() != nullptr) choose(operation, index);
      return;
    case Kind::default_scheme:
      if (world.rotation != nullptr) world.rotation->set_default_scheme(scheme(operation.variant));
      has_default_[index] = true;
      return;
    case Kind::clear_default_scheme:
      if (world.rotation != nullptr) world.rotation->clear_default_scheme();
      has_default_[index] = false;
      return;
    case Kind::detach:
      if (world.plugin != nullptr) world.plugin->detach();
      return;
    case Kind::attach:
      if (world.plugin != nullptr) world.plugin->attach();
      return;
    case Kind::renew_second_world:
      renew_second_world(operation);
      return;
    case Kind::join:
      join(operation);
      return;
    case Kind::unjoin:
      unjoin(joints_[operation.slot % kJoints]);
      return;
    case Kind::motor: {
      const Joint& joint = joints_[operation.slot % kJoints];
      if (joint.constraint == nullptr) return;
      joint.constraint->setEnabled(operation.variant % 4 != 0);
      if (joint.constraint->getConstraintType() == HINGE_CONSTRAINT_TYPE)
        static_cast<btHingeConstraint&>(*joint.constraint)
            .enableAngularMotor(operation.variant % 2 == 0, operation.x, std::abs(operation.y));
      return;
    }
    case Kind::gravity:
      world.world->setGravity(operation.a);
      return;
    case Kind::settings: {
      btContactSolverInfo& info = world.world->getSolverInfo();
      info.m_splitImpulse = operation.variant % 2;
      info.m_numIterations = 1 + static_cast<int>(operation.variant % 12);
      world.world->setForceUpdateAllAabbs(operation.variant % 3 != 0);
      world.world->setLatencyMotionStateInterpolation(operation.variant % 5 != 0);
      world.world->setSynchronizeAllMotionStates(operation.variant % 7 == 0);
      world.world->setApplySpeculativeContactRestitution(operation.variant % 11 == 0);
      world.world->getSimulationIslandManager()->setSplitIslands(operation.variant % 13 != 0);
      return;
    }
    default:
      if (slot.body() != nullptr) apply_to_body(operation, slot);
  }
}

void Side::apply_to_body(const Operation& operation, Slot& slot) {
  btRigidBody& body = *slot.body();
  const btVector3& a = operation.a;
  const std::size_t variant = operation.variant;
  switch (operation.kind) {
    case Kind::velocity:
      if (variant % 4 != 1) body.setAngularVelocity(a);
      if (variant % 4 != 0) body.setLinearVelocity(operation.b);
      if (variant % 4 == 3) body.setInterpolationAngularVelocity(a);
      break;
    case Kind::kick:
      if (variant % 8 == 0) body.applyTorqueImpulse(a);
      if (variant % 8 == 1) body.applyTorque(a);
      if (variant % 8 == 2) body.applyForce(a, operation.b);
      if (variant % 8 == 3) body.applyImpulse(a, operation.b);
      if (variant % 8 == 4) body.applyCentralForce(a);
      if (variant % 8 == 5) body.setGravity(a);
      if (variant % 8 == 6) body.applyTorqueTurnImpulse(a);
      if (variant % 8 == 6) body.applyPushImpulse(operation.b, a);
      if (variant % 8 == 7) body.clearForces();
      break;
    case Kind::damping:
      body.setDamping(operation.x, operation.y);
      break;
    case Kind::factors:
      if (variant % 2 == 0) body.setAngularFactor(a);
      if (variant % 4 == 1) body.setLinearFactor(a);
      if (variant % 4 == 3) {
        const auto bit = [variant](int shift) { return static_cast<btScalar>((variant >> shift) % 2); };
        body.setAngularFactor(btVector3(bit(2), bit(3), bit(4)));
      }
      break;
    case Kind::flags:
      slot.flags = static_cast<int>(variant % 16);
      body.setFlags(slot.flags);
      break;
    case Kind::mass: {
      // Mass 0 makes a body static, which Bullet wants to know when it is added.
      if (body.isStaticObject()) break;
      body.setMassProps(inertia(operation.x, false), moments(a));
      if (variant % 2 == 0) body.updateInertiaTensor();
      break;
    }
    case Kind::teleport: {
      const btTransform pose(orientation(operation.b, operation.x), a);
      if (variant % 8 == 0) body.setCenterOfMassTransform(pose);
      if (variant % 8 == 1) body.setWorldTransform(pose);
      if (variant % 8 == 2) body.getWorldTransform().setRotation(pose.getRotation());
      if (variant % 8 == 3) body.translate(a);
      if (variant % 8 == 4) body.setInterpolationWorldTransform(pose);
      if (variant % 8 == 5) body.getWorldTransform().getBasis()[variant / 8 % 3] = a;
      if (variant % 8 == 6) body.proceedToTransform(pose);
      if (variant % 8 == 7) body.getWorldTransform().getBasis() = pose.getBasis().scaled(a);
      break;
    }
    case Kind::activation:
      if (variant % 8 < 5) body.forceActivationState(1 + static_cast<int>(variant % 8));
      if (variant % 8 == 5) body.activate(true);
      if (variant % 8 == 6) body.setDeactivationTime(operation.x);
      if (variant % 8 == 7) body.setSleepingThresholds(operation.x, operation.y);
      break;
    case Kind::kinematic:
      // As the manual says: not while the body is in a world.
      if (slot.world != Slot::kLimbo || body.isStaticObject()) break;
      body.setCollisionFlags(body.getCollisionFlags() ^ btCollisionObject::CF_KINEMATIC_OBJECT);
      break;
    case Kind::continuous_collision:
      body.setCcdMotionThreshold(variant % 2 == 0 ? btScalar(0.1) : btScalar(0));
      body.setCcdSweptSphereRadius(btScalar(0.2));
      break;
    case Kind::material:
      if (variant % 4 == 0) body.setFriction(operation.x);
      if (variant % 4 == 1) body.setRestitution(operation.x);
      if (variant % 4 == 2) body.setRollingFriction(operation.x);
      if (variant % 4 == 3)
        body.setCollisionFlags(body.getCollisionFlags() ^ btCollisionObject::CF_NO_CONTACT_RESPONSE);
      break;
    default:
      break;
  }
}

void Side::add(const Operation& operation, Slot& slot) {
  const std::size_t variant = operation.variant;
  btCollisionShape& shape = *shapes_[variant % shapes_.size()];
  const bool is_static = variant % 8 == 4;
  const btScalar mass = is_static ? btScalar(0) : inertia(operation.y, false);
  btVector3 inertia_B = moments(operation.b);
  if (variant % 4 != 0) shape.calculateLocalInertia(mass, inertia_B);
  if (is_static) inertia_B.setZero();
  const btTransform pose(orientation(btVector3(operation.x, 1, operation.x), 2), operation.a);
  if (variant % 4 != 3) slot.motion_state = std::make_unique<ShownPose>(*this, pose);
  btRigidBody::btRigidBodyConstructionInfo info(mass, slot.motion_state.get(), &shape, inertia_B);
  info.m_startWorldTransform = pose;
  slot.make(info, variant % 2 == 0);
  slot.body()->setUserIndex(static_cast<int>(operation.slot));
  put(slot, operation.world);
}

void Side::put(Slot& slot, std::size_t world) {
  worlds_[world]->world->addRigidBody(slot.body());
  slot.world = static_cast<int>(world);
}

// Joints go first: Bullet's islands read the tags that bodies had, out of bounds for one that is gone.
void Side::remove(Slot& slot) {
  if (slot.body() == nullptr || slot.world == Slot::kLimbo) return;
  for (Joint& joint : joints_) {
    if (joint.a == slot.body() || joint.b == slot.body()) unjoin(joint);
  }
  worlds_[static_cast<std::size_t>(slot.world)]->world->removeRigidBody(slot.body());
  slot.world = Slot::kLimbo;
}

void Side::join(const Operation& operation) {
  Joint& joint = joints_[operation.slot % kJoints];
  unjoin(joint);
  Slot& first = slots_[operation.slot];
  if (first.body() == nullptr || first.world == Slot::kLimbo) return;
  const bool to_world = operation.other == kSlots;
  Slot& second = slots_[to_world ? operation.slot : operation.other];
  if (!to_world && (second.body() == nullptr || second.world != first.world || &first == &second)) return;
  btRigidBody& a = *first.body();
  btRigidBody& b = *second.body();
  // Bullet's joints between two bodies without mass divide by zero.
  if (a.getInvMass() == 0 && b.getInvMass() == 0) return;
  const btTransform frame_a(btQuaternion(btVector3(1, 1, 0).normalized(), operation.x), operation.a);
  const btTransform frame_b(btQuaternion::getIdentity(), operation.b);
  if (!is_finite(frame_a.getBasis())) return;
  const btVector3 axis = frame_a.getBasis().getColumn(2);
  switch (operation.variant % 4) {
    case 0:
      if (to_world)
        joint.constraint = std::make_unique<btHingeConstraint>(a, operation.a, axis);
      else
        joint.constraint = std::make_unique<btHingeConstraint>(a, b, operation.a, operation.b, axis, axis);
      break;
    case 1:
      if (to_world)
        joint.constraint = std::make_unique<btPoint2PointConstraint>(a, operation.a);
      else
        joint.constraint = std::make_unique<btPoint2PointConstraint>(a, b, operation.a, operation.b);
      break;
    case 2:
      if (to_world) return;
      joint.constraint = std::make_unique<btFixedConstraint>(a, b, frame_a, frame_b);
      break;
    default:
      if (to_world)
        joint.constraint = std::make_unique<btGeneric6DofSpring2Constraint>(a, frame_a);
      else
        joint.constraint = std::make_unique<btGeneric6DofSpring2Constraint>(a, b, frame_a, frame_b);
  }
  joint.world = static_cast<std::size_t>(first.world);
  joint.a = &a;
  joint.b = to_world ? nullptr : &b;
  worlds_[joint.world]->world->addConstraint(joint.constraint.get(), operation.variant % 8 < 4);
}

void Side::unjoin(Joint& joint) {
  if (joint.constraint == nullptr) return;
  worlds_[joint.world]->world->removeConstraint(joint.constraint.get());
  joint = Joint();
}

void Side::choose(const Operation& operation, std::size_t index) {
  World& world = *worlds_[index];
  btRigidBody& body = *slots_[operation.slot].body();
  Choice& choice = choices_[index][operation.slot];
  if (operation.kind == Kind::choose_scheme) {
    try {
      if (world.rotation != nullptr) world.rotation->set_scheme(body, scheme(operation.variant));
    } catch (const std::invalid_argument&) {
      if (!body.isStaticObject()) throw;
      return;
    }
    choice = Choice::scheme;
  } else if (operation.kind == Kind::release) {
    if (world.rotation != nullptr) world.rotation->release(body);
    choice = Choice::released;
  } else {
    if (world.rotation != nullptr) world.rotation->use_default_scheme(body);
    choice = Choice::unset;
  }
}

void Side::renew_second_world(const Operation& operation) {
  if (is_in_step_ || worlds_[1] == nullptr) return;
  World& world = *worlds_[1];
  for (Joint& joint : joints_) {
    if (joint.world == 1) unjoin(joint);
  }
  const bool with_bodies = operation.variant % 2 == 0;
  for (Slot& slot : slots_) {
    if (slot.world != 1) continue;
    if (!with_bodies) remove(slot);
    slot.world = Slot::kLimbo;
  }
  world.world->removeAction(&world.action);
  if (world.plugin != nullptr && operation.variant % 4 < 2) {
    orphan_ = std::move(world.plugin);
    world.world.reset();
    const btRigidBody* const any = slots_[operation.slot].body();
    if (orphan_->attached() || orphan_->rotation().managed_bodies() != 0 ||
        (any != nullptr && orphan_->rotation().manages(*any)))
      fail("a plugin manages bodies of a world that is gone");
    orphan_->detach();
    bool has_thrown = false;
    try {
      orphan_->attach();
    } catch (const std::logic_error&) {
      has_thrown = true;
    }
    if (!has_thrown) fail("a plugin attached to a world that is gone");
  }
  worlds_[1].reset();
  choices_[1].fill(Choice::unset);
}

bool Side::is_rotated(const World& world) const {
  return world.rotation != nullptr && (world.plugin == nullptr || world.plugin->attached());
}

void Side::forget_choices_of_absent(std::size_t world) {
  if (!is_rotated(*worlds_[world])) return;
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (slots_[i].world != static_cast<int>(world)) choices_[world][i] = Choice::unset;
  }
}

void Side::in_step(Place place, btRigidBody* a, btRigidBody* b) {
  if (!is_in_step_) return;
  if (place == Place::after) has_taken_step_ = true;
  // By index: an operation may come back to here through a motion state.
  for (std::size_t i = 0; i < script_.size(); ++i) {
    if (script_[i].place != place || script_[i].kind == Kind::step) continue;
    Operation operation = script_[i];
    if (place == Place::contact) {
      const btRigidBody* body = operation.slot % 2 == 0 ? a : b;
      if (body == nullptr || body->isStaticOrKinematicObject()) continue;
      operation.slot = static_cast<std::size_t>(body->getUserIndex());
    }
    script_[i].kind = Kind::step;  // once a step
    apply(operation);
    Slot& slot = slots_[operation.slot];
    if (slot.body() != nullptr && place != Place::before && place != Place::contact &&
        !is_finite(*slot.body()))
      slot.left_non_finite = true;
  }
  if (place == Place::before) forget_choices_of_absent(stepped_);
}

void Side::step(const Operation& operation, const std::vector<Operation>& script) {
  if (worlds_[operation.world] == nullptr) make_world(operation.world);
  for (Slot& slot : slots_) slot.left_non_finite = false;
  script_ = script;
  stepped_ = operation.world;
  is_in_step_ = true;
  has_taken_step_ = false;
  side_in_step = this;
  gContactProcessedCallback = limits_.contact_callbacks ? contact_processed : nullptr;
  btDiscreteDynamicsWorld& world = *worlds_[operation.world]->world;
  const std::size_t variant = operation.variant;
  if (variant < 32) {
    world.stepSimulation(kDt, 0, kDt);
  } else if (variant < 40) {
    world.stepSimulation(kDt / 4, 0, kDt / 4);
  } else if (variant < 48) {
    world.stepSimulation(kDt * static_cast<btScalar>(variant - 40) / 2, 4, kDt);
  } else if (variant < 56) {
    world.stepSimulation(operation.x, 0, operation.x);
  } else {
    const bool is_step = std::isfinite(operation.y) && operation.y > btScalar(1e-6);
    world.stepSimulation(operation.x, static_cast<int>(variant % 4), is_step ? operation.y : kDt);
  }
  gContactProcessedCallback = nullptr;
  side_in_step = nullptr;
  is_in_step_ = false;
}

bool Side::is_expected_to_be_managed(std::size_t world, std::size_t slot) const {
  const Slot& candidate = slots_[slot];
  if (candidate.body() == nullptr || candidate.world != static_cast<int>(world)) return false;
  if (!is_rotated(*worlds_[world]) || candidate.body()->isStaticOrKinematicObject()) return false;
  const Choice choice = choices_[world][slot];
  return choice == Choice::scheme || (choice == Choice::unset && has_default_[world]);
}

void Side::check(std::size_t world) {
  World& checked = *worlds_[world];
  for (std::size_t i = 0; i < kSlots; ++i) {
    const Slot& slot = slots_[i];
    if (slot.body() == nullptr) continue;
    if (!is_finite(*slot.body())) has_seen_non_finite_ = true;
    if (slot.body()->getFlags() != slot.flags) fail("the flags of a body are not the application's");
  }
  if (checked.rotation == nullptr) return;
  std::size_t managed = 0;
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (slots_[i].body() == nullptr) continue;
    const bool is_managed = checked.rotation->manages(*slots_[i].body());
    if (is_managed != is_expected_to_be_managed(world, i))
      fail("manages() is wrong for the body in slot " + std::to_string(i) + ": " +
           (is_managed ? "true" : "false"));
    if (!is_managed) continue;
    ++managed;
    check_body(world, i);
  }
  if (checked.rotation->managed_bodies() != managed)
    fail("managed_bodies() is not the number of managed bodies");
  const std::uint64_t incidents = checked.rotation->incidents();
  if (incidents < checked.incidents) fail("incidents() has fallen");
  if (incidents < checked.reports) fail("more incidents were reported than counted");
  checked.incidents = incidents;
}

void Side::check_body(std::size_t world, std::size_t index) {
  const Slot& slot = slots_[index];
  if (!has_taken_step_) return;  // dt may be 0, or shorter than a substep
  const std::string name = "the managed body in slot " + std::to_string(index);
  if (!is_finite(*slot.body()) && !slot.left_non_finite)
    fail(name + " of the way " + std::to_string(static_cast<int>(way_)) +
         " is not finite:" + numbers(*slot.body()));
  if (slot.left_non_finite) return;
  const BodyRotation rotation = worlds_[world]->rotation->rotation_of(*slot.body());
  if (!rotation.state.all_finite()) fail("rotation_of " + name + " is not finite");
  constexpr double kRounding = 1e-5;
  if (std::abs(rotation.state.q_WB.norm() - 1) > kRounding)
    fail("q_WB of " + name + " is not of unit length");
  if (rotation.unresolved_steps > rotation.steps) fail(name + " has more unresolved steps than steps");
  if (find_scheme(rotation.scheme)->description().name != rotation.scheme)
    fail(name + " has an unknown scheme");
}

}  // namespace polhode::fuzz
