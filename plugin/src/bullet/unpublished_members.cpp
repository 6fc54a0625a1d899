#include "bullet/unpublished_members.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

// Bullet counts its bodies in m_debugBodyId but has no accessor for it. Everything else that tells two bodies
// apart can be equal in both: broadphases reuse proxy numbers, applications copy flags. The language exempts
// an explicit instantiation from access checks ([temp.spec]); that lets a private member be named, and used,
// without a cast.
template <class Value>
struct MemberOfBody {
  using Member = Value btRigidBody::*;
};

struct DebugBodyId : MemberOfBody<int> {
  friend Member member_of(DebugBodyId);
};

struct AdditionalDamping : MemberOfBody<bool> {
  friend Member member_of(AdditionalDamping);
};

struct InverseInertiaTensorW : MemberOfBody<btMatrix3x3> {
  friend Member member_of(InverseInertiaTensorW);
};

template <class Tag, typename Tag::Member member>
struct Reveal {
  friend typename Tag::Member member_of(Tag) { return member; }
};

template struct Reveal<DebugBodyId, &btRigidBody::m_debugBodyId>;
template struct Reveal<AdditionalDamping, &btRigidBody::m_additionalDamping>;
template struct Reveal<InverseInertiaTensorW, &btRigidBody::m_invInertiaTensorWorld>;

}  // namespace

int body_identity(const btRigidBody& body) {
  return body.*member_of(DebugBodyId());
}

bool has_additional_damping(const btRigidBody& body) {
  return body.*member_of(AdditionalDamping());
}

btMatrix3x3& inverse_inertia_tensor_W(btRigidBody& body) {
  return body.*member_of(InverseInertiaTensorW());
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
