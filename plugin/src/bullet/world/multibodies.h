#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <memory>
#include <unordered_map>
#include <vector>

#include "bullet/body/multibody_proxy.h"
#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The multibodies of a world that turn as one body, each with its proxy. A proxy stays, and with it what was chosen
/// for it, until its multibody is absent from the world during a step. Multibodies are the application's and may
/// be dead between two calls of synchronize: until then none is looked at.
class Multibodies {
 public:
  /// Has none in a world that holds no multibodies.
  explicit Multibodies(btDynamicsWorld& world);

  /// Follows the world's list. Those for which there is no memory are left out.
  void synchronize() noexcept;
  /// Returns whether there are such multibodies.
  bool lacks_memory() const { return lacks_memory_; }
  /// Drops the proxies of multibodies that are not in the list, unless memory is lacking.
  void forget_absent() noexcept;
  /// The proxy of a multibody in the world or not, made if there is none.
  /// @throws std::bad_alloc
  MultibodyProxy& proxy_of(btMultiBody& multibody);
  /// Null if it has none.
  const btRigidBody* known_proxy_of(const btMultiBody& multibody) const;
  void world_is_gone() noexcept;

  /// The bodies of the proxies, in the order of the world's list.
  const std::vector<btRigidBody*>& bodies() const { return bodies_; }
  std::size_t size() const { return bodies_.size(); }
  MultibodyProxy& operator[](std::size_t index) const { return MultibodyProxy::of(*bodies_[index]); }
  /// -1 if it is not among them.
  int index_of(const btMultiBody& multibody) const;
  /// Returns whether the multibody is in the world now and turns as one body, and was so when the list was last followed.
  bool has(const btMultiBody& multibody) const;

  /// Null if the world holds no multibodies.
  btMultiBodyDynamicsWorld* world() const { return world_; }

 private:
  bool is_as_listed() const;
  void add(btMultiBody& multibody, int place);

  struct Listed {
    const btMultiBody* multibody;
    bool is_one_body;
  };
  struct Known {
    std::unique_ptr<MultibodyProxy> proxy;
    int index = -1;  ///< in bodies_
    int place = -1;  ///< in the world's list
  };

  btMultiBodyDynamicsWorld* world_;
  std::unordered_map<const btMultiBody*, Known> known_;
  std::vector<Listed> listed_;  // the world's list, as last followed
  std::vector<btRigidBody*> bodies_;
  bool lacks_memory_ = false;
  bool may_have_absent_ = false;  ///< among known_
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
