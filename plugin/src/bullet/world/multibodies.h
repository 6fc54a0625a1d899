#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <memory>
#include <unordered_map>
#include <vector>

#include "bullet/body/multibody_proxy.h"
#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// The multibodies of a world that turn as one body, each with a proxy. The proxy and its settings are kept
/// until the multibody is absent from the world during a step. The application may delete multibodies between
/// two calls of synchronize, so none is accessed before the list is synchronized.
class Multibodies {
 public:
  /// Stays empty if the world class does not support multibodies.
  explicit Multibodies(btDynamicsWorld& world);

  /// Updates the proxies to match the world's list. Skips multibodies if no memory is available for them.
  void synchronize() noexcept;
  /// Returns true if multibodies were skipped because memory ran out.
  bool lacks_memory() const { return lacks_memory_; }
  /// Deletes the proxies of multibodies that are not in the world's list, unless memory ran out.
  void forget_absent() noexcept;
  /// Returns the proxy of a multibody, whether or not it is in the world. Creates the proxy if needed.
  /// @throws std::bad_alloc
  MultibodyProxy& proxy_of(btMultiBody& multibody);
  /// Returns null if the multibody has no proxy.
  const btRigidBody* known_proxy_of(const btMultiBody& multibody) const;
  void world_is_gone() noexcept;

  /// The bodies of the proxies, in the order of the world's list.
  const std::vector<btRigidBody*>& bodies() const { return bodies_; }
  std::size_t size() const { return bodies_.size(); }
  MultibodyProxy& operator[](std::size_t index) const { return MultibodyProxy::of(*bodies_[index]); }
  /// Returns the index in bodies(), or -1.
  int index_of(const btMultiBody& multibody) const;
  /// Returns true if the multibody is in the world and turns as one body, both now and at the last
  /// synchronize().
  bool has(const btMultiBody& multibody) const;

  /// Returns null if the world class does not support multibodies.
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
  std::vector<Listed> listed_;  // the world's list at the last synchronize()
  std::vector<btRigidBody*> bodies_;
  bool lacks_memory_ = false;
  bool may_have_absent_ = false;  ///< known_ may hold absent multibodies
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
