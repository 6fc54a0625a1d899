#pragma once

#include <gtest/gtest.h>

#include <string>

#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "support/scene.h"

/// The two ways to use the library, for test suites that run with both: TYPED_TEST_SUITE(Suite, BothWays,
/// WayName).
namespace polhode::testing {

/// A scene in a RotationWorld.
class InRotationWorld : public Scene<RotationWorld<btDiscreteDynamicsWorld>> {
 public:
  static constexpr const char* kName = "InRotationWorld";

  RotationControl& rotation() { return world().rotation(); }
  /// Hands the body back to Bullet.
  void let_go(btRigidBody& body) { world().removeRigidBody(&body); }
  void take_back(btRigidBody& body) { world().addRigidBody(&body); }
};

/// A scene in a plain world with a RotationPlugin attached.
class UnderRotationPlugin : public Scene<btDiscreteDynamicsWorld> {
 public:
  static constexpr const char* kName = "UnderRotationPlugin";

  RotationControl& rotation() { return plugin_.rotation(); }
  RotationPlugin& plugin() { return plugin_; }
  void let_go(btRigidBody& /*body*/) { plugin_.detach(); }
  void take_back(btRigidBody& /*body*/) { plugin_.attach(); }

 private:
  RotationPlugin plugin_{world()};
};

using BothWays = ::testing::Types<InRotationWorld, UnderRotationPlugin>;

struct WayName {
  template <class Way>
  static std::string GetName(int /*index*/) {
    return Way::kName;
  }
};

}  // namespace polhode::testing
