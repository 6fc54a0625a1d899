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

/// Which body of the world is in which batch. A body gets a place when it is first seen in the world's list
/// and loses it when it is gone from there; the last body of its scheme then fills the hole. Bodies are the
/// application's and may be dead between two calls of synchronize: until then none is looked at.
/// A function that throws std::bad_alloc changes nothing.
class BodyRegistry {
 public:
  /// A list of bodies that somebody else holds.
  struct List {
    btRigidBody* const* first;
    std::size_t size;

    btRigidBody* operator[](std::size_t index) const { return first[index]; }
  };

  /// Brings the batches in line with the list. Cheap where the list is as it was; then returns false.
  /// Bodies for which there is no memory stay with Bullet; the next call tries again.
  bool synchronize(const List& list, const SchemeChoices& choices) noexcept;
  /// Returns whether there are such bodies.
  bool lacks_memory() const { return lacks_memory_; }
  /// Counts the calls of synchronize that returned true, and those of clear.
  std::uint64_t changes() const { return changes_; }
  /// Gives each body of the list the scheme that is chosen for it, starting afresh where that is another one,
  /// and where a new body has come to the address of an old one. To be called after synchronize.
  void apply_choices(const SchemeChoices& choices);
  /// @name The two parts of apply_choices, so that two registries change together or not at all
  /// @{
  void expect_choices(const SchemeChoices& choices);
  void adopt_choices(const SchemeChoices& choices) noexcept;
  /// In place of adopt_choices.
  void expect_nothing() noexcept { list_batches(); }
  /// @}
  /// Gives one body of the list this treatment, starting afresh in any case.
  void restart(btRigidBody& body, const Treatment& treatment);
  /// The same with another drive or none, which the body goes on with from where it is.
  void drive(btRigidBody& body, const Treatment& treatment);
  void clear();

  /// The bodies as last synchronized.
  const std::vector<btRigidBody*>& bodies() const { return bodies_; }
  const std::vector<Batch*>& batches() const { return batches_; }

  struct Lane {
    Batch* batch;  ///< null: the library does not rotate the body
    std::size_t lane;
  };
  /// The place of bodies()[index].
  Lane lane_at(std::size_t index) const;
  /// The same, but null if that is another body by now.
  Lane lane_at(std::size_t index, const btRigidBody& body) const;
  /// The place of a body that is alive. One that has replaced another is looked at afresh.
  Lane find(const btRigidBody& body, const SchemeChoices& choices);

  /// Returns whether another body than the one seen has come to the address of bodies()[index].
  bool is_replaced(std::size_t index) const;
  /// Returns whether that is so for any body that is in no batch.
  bool has_replaced_bodies_left_to_bullet() const;

 private:
  // The bodies of one scheme, those that have a drive or those that have none, numbered from 0 to count - 1,
  // eight to a batch.
  struct Family {
    SchemePointer scheme;
    bool is_driven = false;
    std::vector<std::unique_ptr<Batch>> batches;
    std::size_t count = 0;
    std::size_t expected = 0;  ///< bodies to come, for which there is room

    Batch& batch_of(std::size_t number) { return *batches[number / kLanes]; }
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;         // Bullet rotates the body
  static constexpr std::uint32_t kArrived = UINT32_MAX - 1;  // for want of memory, so far
  struct Place {
    std::uint32_t family = kNone;
    std::uint32_t number = 0;  ///< in the family; of a body without one, its identity
  };
  struct Moved {
    const btRigidBody* body;
    Place place;
  };

  static bool has_lane(const Place& place) { return place.family < kArrived; }
  std::size_t reserve(std::size_t size) noexcept;
  void follow(const List& list) noexcept;
  void try_to_add(std::size_t index, const SchemeChoices& choices) noexcept;
  void expect(const Treatment& treatment);
  bool has_other_treatment(std::size_t index, const Treatment& wanted) const;
  template <class Expect>
  void all_or_none(const Expect& expect_all);
  void add(std::size_t index, const Treatment& treatment) noexcept;
  void remove(std::size_t index) noexcept { remove(std::exchange(places_[index], Place())); }
  void remove(const Place& place) noexcept;
  std::uint32_t family_of(const Treatment& treatment);
  std::uint32_t known_family(const Treatment& treatment) const;
  std::size_t index_of(const btRigidBody& body) const;
  void list_batches() noexcept;

  std::vector<btRigidBody*> bodies_;
  std::vector<Place> places_;  // of bodies_
  std::vector<Moved> moved_;   // within follow
  bool lacks_memory_ = false;
  std::uint64_t changes_ = 0;
  std::vector<Family> families_;
  std::array<std::unordered_map<const RotationScheme*, std::uint32_t>, 2> family_of_scheme_;  // [is_driven]
  std::vector<Batch*> batches_;
  // Index in bodies_ by btCollisionObject::getWorldArrayIndex, which changes without notice: a hint.
  mutable std::vector<std::uint32_t> hints_;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
