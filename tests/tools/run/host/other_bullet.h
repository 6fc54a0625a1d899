#pragma once

/// A class of that name of another Bullet than the adapters are linked to.
class btDiscreteDynamicsWorld {  // NOLINT: the name is Bullet's
 public:
  virtual ~btDiscreteDynamicsWorld();
  virtual int stepSimulation(float dt, int most_substeps, float fixed_dt);  // NOLINT: likewise
};
