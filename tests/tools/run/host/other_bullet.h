#pragma once

/// The class of this name in another Bullet than the one that the adapters are linked to.
class btDiscreteDynamicsWorld {  // NOLINT: the name is Bullet's
 public:
  virtual ~btDiscreteDynamicsWorld();
  virtual int stepSimulation(float dt, int most_substeps, float fixed_dt);  // NOLINT: Bullet's name
};
