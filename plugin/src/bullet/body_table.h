#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bullet/managed_body.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// What is known of each body, in the order in which the world walks them.
class BodyTable {
 public:
  using Bodies = btAlignedObjectArray<btRigidBody*>;

  std::size_t size() const { return size_; }
  static std::size_t size_of(const Bodies& bodies) { return static_cast<std::size_t>(bodies.size()); }
  ManagedBody& operator[](std::size_t i) { return blocks_[i / kBlock][i % kBlock]; }
  const ManagedBody& operator[](std::size_t i) const { return blocks_[i / kBlock][i % kBlock]; }

  /// Makes entry i the one of bodies[i], a new one where there is none or it was about a body that had the
  /// address before. Other entries come after.
  void align(const Bodies& bodies);
  /// After align: forgets the bodies that are not among `bodies`.
  void forget_others(const Bodies& bodies);
  void clear();

  /// The entry of the body; null if there is none.
  const ManagedBody* find(const btRigidBody& body) const;
  /// The same, a new one if there is none.
  ManagedBody& entry_of(btRigidBody& body);

 private:
  // Blocks, not one array: it grows without copying and without room for as many again.
  static constexpr std::size_t kBlock = 32;
  static constexpr std::uint32_t kNowhere = UINT32_MAX;

  std::size_t index_of(const btRigidBody& body) const;
  std::size_t find_or_append(btRigidBody& body);
  static void renew(ManagedBody& entry, btRigidBody& body);
  void append(btRigidBody& body);
  void rearrange(const Bodies& bodies);
  void remember_place(const btRigidBody& body, std::size_t index) const;
  void shrink_to(std::size_t size);

  std::vector<std::vector<ManagedBody>> blocks_;
  std::size_t size_ = 0;
  // By btCollisionObject::getWorldArrayIndex, which changes without notice: a hint.
  mutable std::vector<std::uint32_t> places_;
  // For bodies without a right hint; made when one is looked up, kept until the end of the next step.
  using AddressTable = std::unordered_map<const btRigidBody*, std::size_t>;
  mutable AddressTable by_address_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
