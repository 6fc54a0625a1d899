// Bullet's hello world, its bodies rotated by Polhode. Build it with `polhode::bullet` linked.
#include <btBulletDynamicsCommon.h>
#include <polhode/bullet/rotation_plugin.h>

#include <cstdio>

int main() {
  // An ordinary Bullet world. Whatever an object uses is declared before it, so that it is destroyed after
  // it.
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;

  btStaticPlaneShape ground_shape(btVector3(0, 0, 1), 0);
  btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &ground_shape));

  btBoxShape plate_shape(btVector3(btScalar(0.5), btScalar(0.3), btScalar(0.1)));
  const btScalar mass(1);
  btVector3 inertia;
  plate_shape.calculateLocalInertia(mass, inertia);
  btRigidBody plate(btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &plate_shape, inertia));
  plate.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 5)));
  plate.setAngularVelocity(btVector3(btScalar(0.5), 8, 0));  // about the middle axis: it will flip over

  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-9.81)));
  world.addRigidBody(&ground);
  world.addRigidBody(&plate);

  // From here on Polhode rotates every dynamic body of this world, by its scheme without error; they fall,
  // collide and slide as before. plugin.rotation() chooses other schemes, for one body or for all. Declared
  // after the world, the plugin lets go of it first.
  const polhode::RotationPlugin plugin(world);

  for (int step = 0; step <= 180; ++step) {
    if (step % 15 == 0) {
      // The library's own record of the body, in double precision even where Bullet is in single.
      const polhode::BodyRotation rotation = plugin.rotation().rotation_of(plate);
      const polhode::Quaternion& q = rotation.state.q_WB;
      std::printf("t %.2f s  height %6.3f m  q (w, x, y, z) %6.3f %6.3f %6.3f %6.3f  |L| %.4f kg m^2/s\n",
                  step / 60.0, static_cast<double>(plate.getWorldTransform().getOrigin().z()), q.w(), q.x(),
                  q.y(), q.z(), rotation.state.L_W.norm());
    }
    world.stepSimulation(btScalar(1) / 60, 0);
  }
}
