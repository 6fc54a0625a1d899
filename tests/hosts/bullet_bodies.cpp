#include "bullet_bodies.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace {

std::vector<btRigidBody*>& bodies() {
  static std::vector<btRigidBody*> list;
  return list;
}

}  // namespace

const std::vector<btRigidBody*>& added_bullet_bodies() {
  return bodies();
}

// The dynamic linker prefers the program's definition, even in the virtual table in Bullet's library. The
// plugin loads that library with local visibility, so Bullet's own definition is looked up by name.
void btDiscreteDynamicsWorld::addRigidBody(btRigidBody* body) {
  using AddRigidBody = void (*)(btDiscreteDynamicsWorld*, btRigidBody*);
  static const auto bullets = [] {
    void* library = dlopen("libBulletDynamics.so.3.24", RTLD_LAZY | RTLD_NOLOAD);
    void* found = library == nullptr
                      ? nullptr
                      : dlsym(library, "_ZN23btDiscreteDynamicsWorld12addRigidBodyEP11btRigidBody");
    return reinterpret_cast<AddRigidBody>(found);
  }();
  if (bullets == nullptr) {
    std::fputs("spinning_boxes: Bullet's addRigidBody was not found\n", stderr);
    std::exit(2);
  }
  bodies().push_back(body);
  bullets(this, body);
}
