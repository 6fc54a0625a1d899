// An application that mixes Bullet's precisions; its CMakeLists.txt says how.
#include <btBulletDynamicsCommon.h>
#include <polhode/bullet/rotation_world.h>

#include <cstdio>
#include <stdexcept>

int main() {
  try {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    polhode::RotationWorld<btDiscreteDynamicsWorld> world(&dispatcher, &broadphase, &solver, &configuration);
  } catch (const std::runtime_error& error) {
    std::printf("refused: %s\n", error.what());
    return 0;
  }
  std::puts("not refused");
  return 1;
}
