#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <unordered_map>
#include <utility>

#include "bullet/internals/private_members.h"
#include "polhode/bullet/precision.h"
#include "polhode/scheme_registry.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Which scheme the application wants for which body.
class SchemeChoices {
 public:
  /// The scheme of every body without a choice of its own; null: Bullet rotates them.
  SchemePointer default_scheme = polhode::default_scheme();

  /// Makes room for a choice, and changes none: to be called before `choose`.
  void expect(const btRigidBody& body) { choices_.try_emplace(&body, Choice{kNoBody, nullptr}); }
  /// Null: Bullet rotates the body.
  void choose(const btRigidBody& body, SchemePointer scheme) noexcept {
    choices_.find(&body)->second = {body_identity(body), std::move(scheme)};
    changed_ = true;
  }
  void choose_default(const btRigidBody& body) noexcept { choices_.erase(&body); }

  /// The scheme of the body; null: Bullet rotates it.
  SchemePointer scheme_of(const btRigidBody& body) const {
    const auto found = choices_.find(&body);
    if (found == choices_.end() || found->second.identity != body_identity(body)) return default_scheme;
    return found->second.scheme;
  }

  /// Drops the choices of bodies for which `is_present(address)` is false.
  template <class IsPresent>
  void keep_only(const IsPresent& is_present) {
    for (auto it = choices_.begin(); it != choices_.end();)
      it = is_present(it->first) ? std::next(it) : choices_.erase(it);
    changed_ = false;
  }
  /// To be called when bodies have come or gone.
  void bodies_changed() { changed_ = true; }
  /// Returns whether some choice may be of a body that is gone: one was made, or bodies came or went, since
  /// the last keep_only.
  bool changed() const { return changed_ && !choices_.empty(); }

 private:
  static constexpr int kNoBody = -1;  // Bullet counts from 0
  struct Choice {
    int identity;  ///< body_identity: another body may get the address
    SchemePointer scheme;
  };

  std::unordered_map<const btRigidBody*, Choice> choices_;
  bool changed_ = false;
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
