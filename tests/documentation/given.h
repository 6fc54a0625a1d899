// What the C++ blocks of the documentation take for given.
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <iostream>
#include <map>
#include <memory>
#include <vector>

#include "polhode/bullet/conversions.h"
#include "polhode/bullet/rotation_plugin.h"
#include "polhode/bullet/rotation_world.h"
#include "polhode/bullet/snapshot.h"

struct Input {};

struct Given {
  btDispatcher& dispatcher;
  btBroadphaseInterface& broadphase;
  btConstraintSolver& solver;
  btCollisionConfiguration& configuration;
  btDiscreteDynamicsWorld& world;
  btRigidBody& body;
  btMultiBody& multibody;
  polhode::RotationPlugin& plugin;
  polhode::Snapshot& snapshot;
  std::map<int, polhode::Snapshot>& snapshots;
  std::vector<Input>& inputs;
  void (*apply)(const Input&);
};

// The names of its members, of three bodies and of numbers, each of which a block may declare anew.
#define GIVEN                                                                                            \
  [[maybe_unused]] auto& [dispatcher, broadphase, solver, configuration, world, body, multibody, plugin, \
                          snapshot, snapshots, inputs, apply] = given;                                   \
  [[maybe_unused]] btRigidBody &satellite = body, &drone = body;                                         \
  [[maybe_unused]] btScalar dt(1);                                                                       \
  [[maybe_unused]] int frame = 0, now = 0;
