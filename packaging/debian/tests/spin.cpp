// Plain Bullet, for polhode-run: a box that spins freely.
#include <btBulletDynamicsCommon.h>

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));
  btBoxShape box(btVector3(1, 2, 3));
  btVector3 inertia;
  box.calculateLocalInertia(1, inertia);
  btRigidBody body(1, nullptr, &box, inertia);
  body.setAngularVelocity(btVector3(1, 5, 1));
  world.addRigidBody(&body);
  for (int step = 0; step < 60; ++step) world.stepSimulation(btScalar(1) / 60, 0);
  world.removeRigidBody(&body);
}
