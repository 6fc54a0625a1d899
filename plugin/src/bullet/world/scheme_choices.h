#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <memory>
#include <unordered_map>
#include <utility>

#include "bullet/internals/private_members.h"
#include "polhode/bullet/precision.h"
#include "polhode/scheme_registry.h"
#include "scheme_base/driven_step.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// How a body is rotated.
struct Treatment {
  SchemePointer scheme;    ///< null: Bullet rotates the body
  Drive* drive = nullptr;  ///< null: no torque law and no rotors
};

/// The schemes and drives that the application has chosen for the bodies.
class SchemeChoices {
 public:
  /// The scheme of all bodies without a choice of their own; null: Bullet rotates them.
  SchemePointer default_scheme = polhode::default_scheme();

  /// Allocates memory for a choice, without changing any. Call before `choose` and `set_drive`.
  void reserve(const btRigidBody& body) { choices_.try_emplace(&body); }
  /// Sets the scheme. Null: Bullet rotates the body, and its drive is deleted.
  void choose(const btRigidBody& body, SchemePointer scheme) noexcept {
    Choice& choice = choice_of_this(body);
    if (scheme == nullptr) choice.drive.reset();
    choice.scheme = std::move(scheme);
    choice.has_scheme = true;
  }
  void choose_default(const btRigidBody& body) noexcept {
    const auto found = choices_.find(&body);
    if (found == choices_.end()) return;
    found->second.has_scheme = false;
    if (found->second.drive == nullptr) choices_.erase(found);
  }
  /// Replaces and deletes the drive; null for none.
  void set_drive(const btRigidBody& body, std::unique_ptr<Drive> drive) noexcept {
    choice_of_this(body).drive = std::move(drive);
  }

  Treatment treatment_of(const btRigidBody& body) const {
    const Choice* const choice = find(body);
    if (choice == nullptr) return {default_scheme, nullptr};
    const SchemePointer& scheme = choice->has_scheme ? choice->scheme : default_scheme;
    return {scheme, scheme == nullptr ? nullptr : choice->drive.get()};
  }

  /// Returns true if the scheme was set by `choose`, false if the default applies.
  bool has_own_choice(const btRigidBody& body) const {
    const Choice* const choice = find(body);
    return choice != nullptr && choice->has_scheme;
  }

  /// Calls function(drive) for the drives of bodies that use the default scheme.
  template <class Function>
  void for_each_drive_with_default_scheme(const Function& function) const {
    for (const auto& [body, choice] : choices_) {
      if (!choice.has_scheme && choice.drive != nullptr) function(*choice.drive);
    }
  }

  /// Drops the choices of bodies for which `is_present(address)` is false.
  template <class IsPresent>
  void keep_only(const IsPresent& is_present) {
    for (auto it = choices_.begin(); it != choices_.end();)
      it = is_present(it->first) ? std::next(it) : choices_.erase(it);
    changed_ = false;
  }
  /// Call after bodies were added or removed.
  void bodies_changed() { changed_ = true; }
  /// Returns true if a choice may belong to a body that is gone: since the last keep_only, a choice was made,
  /// or bodies were added or removed.
  bool changed() const { return changed_ && !choices_.empty(); }

 private:
  static constexpr int kNoBody = -1;  // Bullet counts from 0
  struct Choice {
    int identity = kNoBody;   ///< body_identity: another body may take the address
    bool has_scheme = false;  ///< false: the default scheme applies
    SchemePointer scheme;
    std::unique_ptr<Drive> drive;
  };

  const Choice* find(const btRigidBody& body) const {
    const auto found = choices_.find(&body);
    return found == choices_.end() || found->second.identity != body_identity(body) ? nullptr
                                                                                    : &found->second;
  }
  // Requires memory from `reserve`. Resets the choice of an earlier body at the same address.
  Choice& choice_of_this(const btRigidBody& body) noexcept {
    Choice& choice = choices_.find(&body)->second;
    if (choice.identity != body_identity(body)) {
      choice = Choice();
      choice.identity = body_identity(body);
    }
    changed_ = true;
    return choice;
  }

  std::unordered_map<const btRigidBody*, Choice> choices_;
  bool changed_ = false;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
