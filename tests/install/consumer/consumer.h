#pragma once

#include <btBulletDynamicsCommon.h>

/// Ends the program and prints the condition if the condition is false.
#define REQUIRE(condition) require((condition), #condition, __FILE__, __LINE__)
void require(bool condition, const char* text, const char* file, int line);

/// The parts of a Bullet world, for a body without joints and contacts.
struct WorldParts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSphereShape sphere{btScalar(0.5)};
  btRigidBody body{{btScalar(1), nullptr, &sphere, {1, 2, 3}}};

  WorldParts() {
    body.setAngularVelocity({3, 2, 4});
    body.setActivationState(DISABLE_DEACTIVATION);
  }
};

void rotates_a_world_whose_callbacks_and_user_pointer_are_taken();
void rotates_a_body_by_a_scheme_of_the_application();
