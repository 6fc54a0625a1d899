#include "bullet/world/scheme_choices.h"

#include "bullet/internals/private_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

void SchemeChoices::choose(const btRigidBody& body, SchemePointer scheme) {
  choices_[&body] = {body_identity(body), std::move(scheme)};
  changed_ = true;
}

void SchemeChoices::choose_default(const btRigidBody& body) {
  choices_.erase(&body);
}

SchemePointer SchemeChoices::scheme_of(const btRigidBody& body) const {
  const auto found = choices_.find(&body);
  if (found == choices_.end() || found->second.identity != body_identity(body)) return default_scheme;
  return found->second.scheme;
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
