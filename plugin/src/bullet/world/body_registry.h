#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bullet/batch/batch.h"
#include "bullet/world/scheme_choices.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Assigns the bodies of a world to batches. A body gets a lane when it first appears in the world's list and
/// loses the lane when it disappears from the list; the last body of the same scheme then fills the hole. The
/// application may delete bodies between two calls of synchronize, so no body is accessed before the list is
/// synchronized. A function that throws std::bad_alloc changes nothing.
class BodyRegistry {
 public:
  /// A view of a list of bodies.
  struct List {
    btRigidBody* const* first;
    std::size_t size;

    btRigidBody* operator[](std::size_t index) const { return first[index]; }
  };

  /// Updates the batches to match the list. Returns false, at little cost, if the list has not changed.
  /// Leaves bodies to Bullet if no memory is available for them; the next call tries again.
  bool synchronize(const List& list, const SchemeChoices& choices) noexcept;
  /// Returns true if the last call of synchronize left bodies to Bullet because memory ran out.
  bool lacks_memory() const { return lacks_memory_; }
  /// Number of calls of clear, and of synchronize that returned true.
  std::uint64_t changes() const { return changes_; }
  /// Moves each body to the scheme chosen for it. A body whose scheme changes, or that replaces a deleted
  /// body at the same address, starts from its present motion. Call after synchronize().
  void apply_choices(const SchemeChoices& choices);
  /// @name The two halves of apply_choices, so that two registries change together or not at all
  /// @{
  void reserve_for_choices(const SchemeChoices& choices);
  void adopt_choices(const SchemeChoices& choices) noexcept;
  /// Cancels reserve_for_choices.
  void cancel_reservations() noexcept { list_batches(); }
  /// @}
  /// Applies a treatment to a body of the list, which starts from its present motion.
  void restart(btRigidBody& body, const Treatment& treatment);
  /// Applies a treatment with a different drive or none to a body of the list, which keeps its state.
  void drive(btRigidBody& body, const Treatment& treatment);
  void clear();

  /// The bodies at the last call of synchronize.
  const std::vector<btRigidBody*>& bodies() const { return bodies_; }
  const std::vector<Batch*>& batches() const { return batches_; }

  struct Lane {
    Batch* batch;  ///< null: the library does not rotate the body
    std::size_t lane;
  };
  /// Returns the lane of bodies()[index].
  Lane lane_at(std::size_t index) const;
  /// Returns the lane of bodies()[index], or a null batch if that is not the given body any more.
  Lane lane_at(std::size_t index, const btRigidBody& body) const;
  /// Returns the lane of a living body. A body that replaces a deleted one is restarted first.
  Lane find(const btRigidBody& body, const SchemeChoices& choices);

  /// Returns true if bodies()[index] has been replaced by another body at the same address.
  bool is_replaced(std::size_t index) const;
  /// Returns true if a body without a batch has been replaced.
  bool has_replaced_bodies_left_to_bullet() const;

 private:
  // The bodies of one scheme, with or without a drive, numbered from 0 to count - 1, eight to a batch.
  struct Family {
    SchemePointer scheme;
    bool is_driven = false;
    std::vector<std::unique_ptr<Batch>> batches;
    std::size_t count = 0;
    std::size_t reserved = 0;  ///< bodies for which memory is reserved

    Batch& batch_of(std::size_t number) { return *batches[number / kLanes]; }
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;         // Bullet rotates the body
  static constexpr std::uint32_t kPending = UINT32_MAX - 1;  // new, not in a batch yet
  struct Place {
    std::uint32_t family = kNone;
    std::uint32_t number = 0;  ///< in the family; for a body without a family, the identity of the body
  };
  struct Moved {
    const btRigidBody* body;
    Place place;
  };

  static bool has_lane(const Place& place) { return place.family < kPending; }
  std::size_t reserve(std::size_t size) noexcept;
  void follow(const List& list) noexcept;
  void try_to_add(std::size_t index, const SchemeChoices& choices) noexcept;
  void reserve_lane(const Treatment& treatment);
  bool has_other_treatment(std::size_t index, const Treatment& wanted) const;
  template <class ReserveAll>
  void reserve_all_or_none(const ReserveAll& reserve_all);
  void add(std::size_t index, const Treatment& treatment) noexcept;
  void remove(std::size_t index) noexcept { remove(std::exchange(places_[index], Place())); }
  void remove(const Place& place) noexcept;
  std::uint32_t family_of(const Treatment& treatment);
  std::uint32_t known_family(const Treatment& treatment) const;
  std::size_t index_of(const btRigidBody& body) const;
  void list_batches() noexcept;

  std::vector<btRigidBody*> bodies_;
  std::vector<Place> places_;  // of bodies_
  std::vector<Moved> moved_;   // scratch space of follow
  bool lacks_memory_ = false;
  std::uint64_t changes_ = 0;
  std::vector<Family> families_;
  std::array<std::unordered_map<const RotationScheme*, std::uint32_t>, 2> family_of_scheme_;  // [is_driven]
  std::vector<Batch*> batches_;
  // Index in bodies_ by btCollisionObject::getWorldArrayIndex. Only a hint, since Bullet changes that index.
  mutable std::vector<std::uint32_t> hints_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
