// A contact callback may change a body during collision detection, and the following solve uses the changes.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/both_ways.h"
#include "support/constrained_scene.h"
#include "support/precision.h"
#include "support/same_body_bits.h"

namespace polhode::testing {
namespace {

constexpr btScalar kDt = btScalar(1.0 / 60);
constexpr int kBodies = 12;  // more than one batch

std::function<void(btRigidBody&)> on_contact;

bool call_on_contact(btManifoldPoint& /*point*/, const btCollisionObjectWrapper* a, int, int,
                     const btCollisionObjectWrapper* b, int, int) {
  for (const auto* wrapper : {a, b}) {
    btRigidBody* body = const_cast<btRigidBody*>(btRigidBody::upcast(wrapper->getCollisionObject()));
    if (body->getInvMass() != 0) on_contact(*body);
  }
  return false;
}

/// Spinning boxes on the floor, with contact callbacks enabled.
template <class AnyScene>
void add_spinning_boxes(AnyScene& scene) {
  set_gravity(scene);
  btRigidBody& floor = scene.add_floor();
  floor.setFriction(0);
  for (int i = 0; i < kBodies; ++i) {
    const btTransform pose(btQuaternion::getIdentity(), vector(3 * i, 0, 0.5));
    btRigidBody& box = scene.add_box(vector(0.3, 0.4, 0.5), 1, pose);
    box.setAngularVelocity(vector(0, 0, 1 + 0.1 * i));
    box.setFriction(0);
    box.setUserIndex(i);
    box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  }
}

template <class Way>
class ContactCallback : public ::testing::Test {
 protected:
  ContactCallback() { gContactAddedCallback = call_on_contact; }
  ~ContactCallback() override {
    gContactAddedCallback = nullptr;
    on_contact = nullptr;
  }

  // Steps until there are contacts and applies `change` to one body in that step.
  void step_with(const std::function<void(btRigidBody&)>& change) {
    add_spinning_boxes(scene_);
    add_spinning_boxes(untouched_);
    on_contact = [&](btRigidBody& body) {
      if (body.getUserIndex() == 9 && &body == scene_.bodies()[10].get()) change(body);
    };
    for (int i = 0; i < 5; ++i) {
      scene_.step(kDt);
      untouched_.step(kDt);
    }
  }

  btRigidBody& changed() { return *scene_.bodies()[10]; }
  btRigidBody& twin() { return *untouched_.bodies()[10]; }

  void expect_others_untouched() {
    for (std::size_t i = 0; i < scene_.bodies().size(); ++i) {
      if (i == 10) continue;
      EXPECT_TRUE(same_bits(*scene_.bodies()[i], *untouched_.bodies()[i])) << i;
    }
  }

  Way scene_;
  Way untouched_;
};
TYPED_TEST_SUITE(ContactCallback, BothWays, WayName);

// A torque about the vertical causes no reaction from the floor: omega = torque dt / inertia.
TYPED_TEST(ContactCallback, ThatAppliesATorqueIsFelt) {
  int count = 0;
  this->step_with([&](btRigidBody& body) {
    if (count++ == 0) body.applyTorque(btVector3(0, 0, 3));
  });
  ASSERT_GT(count, 0);
  const double inertia = 1 / this->twin().getInvInertiaDiagLocal().z();
  const double expected = omega_of(this->twin()).z() + 3 * static_cast<double>(kDt) / inertia;
  // measured 6.7e-6 in single, 4.9e-7 in double precision, from the contact; the change is 0.6 rad/s
  EXPECT_NEAR(omega_of(this->changed()).z(), expected, by_precision(2e-5, 2e-6));
  this->expect_others_untouched();
}

TYPED_TEST(ContactCallback, ThatChangesTheInertiaIsHeeded) {
  int count = 0;
  this->step_with([&](btRigidBody& body) {
    if (count++ > 0) return;
    btVector3 inertia_B = body.getLocalInertia();
    inertia_B.setZ(inertia_B.z() * 4);
    body.setMassProps(1, inertia_B);
    body.updateInertiaTensor();
    body.applyTorque(btVector3(0, 0, 3));
  });
  ASSERT_GT(count, 0);
  const double inertia = 1 / this->changed().getInvInertiaDiagLocal().z();
  const double expected = omega_of(this->twin()).z() + 3 * static_cast<double>(kDt) / inertia;
  // measured 3.4e-5 in single, 3.2e-4 in double precision, from the contact; the change is 0.15 rad/s
  EXPECT_NEAR(omega_of(this->changed()).z(), expected, by_precision(1e-4, 1e-3));
  this->expect_others_untouched();
}

TYPED_TEST(ContactCallback, ThatLocksAxesIsHeeded) {
  int count = 0;
  this->step_with([&](btRigidBody& body) {
    if (count++ > 0) return;
    body.setAngularFactor(btVector3(0, 0, 0));
    body.setAngularVelocity(btVector3(0, 0, 0));
  });
  ASSERT_GT(count, 0);
  EXPECT_TRUE(same(this->changed().getAngularVelocity(), btVector3(0, 0, 0)));
  this->expect_others_untouched();
}

TYPED_TEST(ContactCallback, ThatSetsTheVelocityIsHeeded) {
  int count = 0;
  this->step_with([&](btRigidBody& body) {
    if (count++ == 0) body.setAngularVelocity(btVector3(0, 0, -2));
  });
  ASSERT_GT(count, 0);
  EXPECT_NEAR(omega_of(this->changed()).z(), -2, 6e-5);  // measured 2.0e-5
  this->expect_others_untouched();
}

TYPED_TEST(ContactCallback, ThatMovesTheBodyIsHeeded) {
  const btQuaternion turned(btVector3(0, 0, 1), btScalar(0.7));
  int count = 0;
  this->step_with([&](btRigidBody& body) {
    if (count++ > 0) return;
    body.setAngularVelocity(btVector3(0, 0, 0));
    body.setCenterOfMassTransform(btTransform(turned, body.getWorldTransform().getOrigin()));
  });
  ASSERT_GT(count, 0);
  EXPECT_LT(angle_between(basis_of(this->changed()), to_double(btMatrix3x3(turned))), 1e-4);
  this->expect_others_untouched();
}

// A sleeping neighbour that the callback wakes takes part in the next step.
TYPED_TEST(ContactCallback, ThatWakesABodyWakesIt) {
  auto& scene = this->scene_;
  btRigidBody& sleeper = scene.add_free(btVector3(1, 2, 3), btVector3(0, 0, 0));
  sleeper.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 50)));
  sleeper.forceActivationState(ISLAND_SLEEPING);
  int count = 0;
  add_spinning_boxes(scene);
  on_contact = [&](btRigidBody&) {
    if (count++ > 0) return;
    sleeper.activate(true);
    sleeper.applyTorqueImpulse(btVector3(0, 0, 3));
  };
  scene.step(kDt, 3);
  ASSERT_GT(count, 0);
  EXPECT_TRUE(sleeper.isActive());
  EXPECT_NEAR(omega_of(sleeper).z(), 1, 1e-5);
}

/// A free body far from the boxes, to which a contact callback of the boxes applies `change`.
template <class Way>
class FreeBodyChangedByAContactCallback : public ContactCallback<Way> {
 protected:
  btRigidBody& body_after(const std::function<void(btRigidBody&)>& change) {
    Way& scene = this->scene_;
    btRigidBody& body = scene.add_free(btVector3(2, 2, 2), btVector3(0, 0, 3));
    body.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 50)));
    body.setGravity(btVector3(0, 0, 0));
    body.setFlags(body.getFlags() | BT_DISABLE_WORLD_GRAVITY);
    add_spinning_boxes(scene);
    on_contact = [](btRigidBody&) {};
    scene.step(kDt, 2);
    bool is_done = false;
    on_contact = [&](btRigidBody&) {
      if (!is_done) change(body);
      is_done = true;
    };
    scene.step(kDt);
    EXPECT_TRUE(is_done);
    return body;
  }
};
TYPED_TEST_SUITE(FreeBodyChangedByAContactCallback, BothWays, WayName);

TYPED_TEST(FreeBodyChangedByAContactCallback, IsKicked) {
  const btRigidBody& body =
      this->body_after([](btRigidBody& b) { b.setAngularVelocity(btVector3(1, -2, 0)); });
  // measured 0 in both precisions
  EXPECT_LT((omega_of(body) - Vector3(1, -2, 0)).norm(), by_precision(1e-6, 1e-14));
  EXPECT_EQ(this->scene_.rotation().rotation_of(body).steps, 3U);
}

TYPED_TEST(FreeBodyChangedByAContactCallback, IsTurned) {
  const btQuaternion turned(btVector3(1, 0, 0), btScalar(0.7));
  const btRigidBody& body = this->body_after([&](btRigidBody& b) {
    b.setAngularVelocity(btVector3(0, 0, 0));
    b.setCenterOfMassTransform(btTransform(turned, btVector3(0, 9, 50)));
  });
  // measured 4.2e-8 in single, 1.2e-16 in double precision
  EXPECT_LT(angle_between(basis_of(body), to_double(btMatrix3x3(turned))), by_precision(2e-7, 1e-15));
  EXPECT_TRUE(same(body.getWorldTransform().getOrigin(), btVector3(0, 9, 50)));
}

TYPED_TEST(FreeBodyChangedByAContactCallback, IsKeptFinite) {
  const btScalar nan = std::numeric_limits<btScalar>::quiet_NaN();
  const btRigidBody& body =
      this->body_after([&](btRigidBody& b) { b.setAngularVelocity(btVector3(nan, 0, 0)); });
  EXPECT_TRUE(omega_of(body).allFinite());
  EXPECT_EQ(this->scene_.rotation().incidents(), 1U);
}

TYPED_TEST(FreeBodyChangedByAContactCallback, FeelsATorque) {
  const btRigidBody& body = this->body_after([](btRigidBody& b) { b.applyTorque(btVector3(0, 0, 4)); });
  EXPECT_NEAR(omega_of(body).z(), 3 + 2 * static_cast<double>(kDt), by_precision(1e-6, 1e-14));
}

}  // namespace
}  // namespace polhode::testing
