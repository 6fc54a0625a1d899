#include "bullet/body_identity.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Bullet counts its bodies in m_debugBodyId but has no accessor for it. Everything else that tells two bodies
// apart can be equal in both: broadphases reuse proxy numbers, applications copy flags. The language exempts
// an explicit instantiation from access checks ([temp.spec]); that lets a private member be named, and read,
// without a cast.
struct DebugBodyId {
  using Member = int btRigidBody::*;
  friend Member member_of(DebugBodyId);
};

template <class Tag, typename Tag::Member member>
struct Reveal {
  friend typename Tag::Member member_of(Tag) { return member; }
};

template struct Reveal<DebugBodyId, &btRigidBody::m_debugBodyId>;

}  // namespace

int body_identity(const btRigidBody& body) {
  return body.*member_of(DebugBodyId());
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
