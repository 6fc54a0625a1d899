// Bullet's hello world with bodies rotated by Polhode. Link it with `polhode::bullet`.
#include <btBulletDynamicsCommon.h>
#include <polhode/bullet/rotation_plugin.h>

#include <cstdio>

int main() {
  // An ordinary Bullet world. Objects are declared before their users, so that they are destroyed after them.
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

  // From here on Polhode rotates every dynamic body of this world with its default scheme, `exact`. The
  // bodies fall, collide and slide as before. To choose another scheme for one body:
  //   plugin.rotation().set_scheme(plate, "quaternion");
  polhode::RotationPlugin plugin(world);

  for (int step = 0; step <= 180; ++step) {
    if (step % 15 == 0) {
      // The library's state of the body, which is in double precision even with single-precision Bullet.
      const polhode::BodyRotation rotation = plugin.rotation().rotation_of(plate);
      const polhode::Quaternion& q = rotation.state.q_WB;
      std::printf("t %.2f s  height %6.3f m  q (w, x, y, z) %6.3f %6.3f %6.3f %6.3f  |L| %.4f kg m^2/s\n",
                  step / 60.0, static_cast<double>(plate.getWorldTransform().getOrigin().z()), q.w(), q.x(),
                  q.y(), q.z(), rotation.state.L_W.norm());
    }
    world.stepSimulation(btScalar(1) / 60, 0);
  }
}
