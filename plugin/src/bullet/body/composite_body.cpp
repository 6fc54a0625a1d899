#include "bullet/body/composite_body.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <Eigen/Eigenvalues>

#include "bullet/internals/private_members.h"
#include "polhode/bullet/conversions.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

namespace {

bool is_fixed_to_its_parent(const btMultiBody& multibody, int link) {
  return multibody.getLink(link).m_jointType == btMultibodyLink::eFixed &&
         !multibody.isLinkStaticOrKinematic(link);
}

// Returns the inertia of a point mass at r, kg m^2.
Matrix3 point_inertia(double mass, const Vector3& r) {
  return mass * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
}

// Assigns the value. Returns true if the old value was different.
template <class Value>
bool replace(const Value& value, Value& kept) {
  const bool is_other = !(value == kept);
  kept = value;
  return is_other;
}

}  // namespace

// Excludes links with global velocities: Bullet then moves them with the velocities of the last step.
bool turns_as_one_body(const btMultiBody& multibody) {
  if (multibody.hasFixedBase() || !is_finalized(multibody)) return false;
  if (multibody.getNumLinks() > 0 && multibody.isUsingGlobalVelocities()) return false;
  for (int link = 0; link < multibody.getNumLinks(); ++link) {
    if (!is_fixed_to_its_parent(multibody, link)) return false;
  }
  return true;
}

CompositeBody::CompositeBody(const btMultiBody& multibody) {
  read(multibody);
  combine();
}

bool CompositeBody::update(const btMultiBody& multibody) {
  if (!read(multibody)) return false;
  combine();
  return true;
}

// Returns true if a value has changed.
bool CompositeBody::read(const btMultiBody& multibody) {
  const auto count = static_cast<std::size_t>(multibody.getNumLinks());
  bool has_changed = links_.size() != count;
  links_.resize(count, base_);
  has_changed |= replace(multibody.getBaseMass(), base_.mass);
  has_changed |= replace(multibody.getBaseInertia(), base_.inertia);
  for (int link = 0; link < multibody.getNumLinks(); ++link) {
    const int parent = multibody.getParent(link);
    const btTransform& parent_pose_B =
        parent < 0 ? base_.pose_B : links_[static_cast<std::size_t>(parent)].pose_B;
    // Bullet stores the rotation into the link's frame, and the vector from the parent in that frame.
    const btQuaternion q_link_to_parent = multibody.getParentToLocalRot(link).inverse();
    const btTransform pose(q_link_to_parent, quatRotate(q_link_to_parent, multibody.getRVector(link)));
    Part& part = links_[static_cast<std::size_t>(link)];
    has_changed |= replace(btTransform(parent_pose_B * pose), part.pose_B);
    has_changed |= replace(multibody.getLinkMass(link), part.mass);
    has_changed |= replace(multibody.getLinkInertia(link), part.inertia);
  }
  return has_changed;
}

// Steiner: I_C = sum R_i I_i R_i^T + m_i (r_i^2 - r_i r_i^T), r_i from the common centre of mass.
void CompositeBody::combine() {
  inertia_C_ = to_double(base_.inertia);
  if (links_.empty()) return;
  double mass = static_cast<double>(base_.mass);
  Vector3 moment_B = Vector3::Zero();
  for (const Part& link : links_) {
    mass += static_cast<double>(link.mass);
    moment_B += static_cast<double>(link.mass) * to_double(link.pose_B.getOrigin());
  }
  const Vector3 centre_B = mass > 0.0 ? Vector3(moment_B / mass) : Vector3(Vector3::Zero());
  Matrix3 inertia_B = inertia_C_.asDiagonal();
  inertia_B += point_inertia(static_cast<double>(base_.mass), centre_B);
  for (const Part& link : links_) {
    const Matrix3 R = to_double(link.pose_B.getBasis());
    inertia_B += R * to_double(link.inertia).asDiagonal() * R.transpose();
    inertia_B += point_inertia(static_cast<double>(link.mass), to_double(link.pose_B.getOrigin()) - centre_B);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(inertia_B);
  Matrix3 axes_B = principal.eigenvectors();
  if (axes_B.determinant() < 0.0) axes_B.col(0) = -axes_B.col(0);
  q_BC_ = Quaternion(axes_B).normalized();
  inertia_C_ = principal.eigenvalues();
  centre_B_ = to_bullet(centre_B);
}

CompositeBody::Wrench CompositeBody::cancelling(const btMatrix3x3& R_WB, const btVector3& omega_W) const {
  btScalar mass = base_.mass;
  btVector3 torque_W(0, 0, 0);
  for (const Part& link : links_) {
    const btVector3 r_W = R_WB * link.pose_B.getOrigin();
    mass += link.mass;
    torque_W += link.mass * omega_W.dot(r_W) * r_W.cross(omega_W);
  }
  return {mass * omega_W.cross(omega_W.cross(R_WB * centre_B_)), torque_W};
}

}  // namespace POLHODE_PRECISION
}  // namespace polhode
