#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns true if the multibody turns as one rigid body: its base is free, and it has no links or only fixed
/// ones.
bool turns_as_one_body(const btMultiBody& multibody);

/// A multibody's base and the links fixed to it, as one rigid body. B is the frame of the base. C has its
/// origin in the common centre of mass and its axes along the principal axes; without links C is B.
class CompositeBody {
 public:
  /// @throws std::bad_alloc
  explicit CompositeBody(const btMultiBody& multibody);

  /// Adopts changed masses, moments and positions. Returns false if nothing has changed.
  bool update(const btMultiBody& multibody);

  bool has_links() const { return !links_.empty(); }
  const Vector3& inertia_C() const { return inertia_C_; }  ///< kg m^2
  const btVector3& centre_B() const { return centre_B_; }  ///< centre of mass, m
  const Quaternion& q_BC() const { return q_BC_; }
  const btTransform& link_pose_B(int link) const { return links_[static_cast<std::size_t>(link)].pose_B; }

  /// The force on the base and the torque that cancel velocity changes which Bullet makes to a composite
  /// body: Bullet computes the links' centrifugal forces explicitly, even if the gyroscopic term is off. With
  /// r_i from the base to a link's centre of mass, c to the common one, and m the total mass:
  ///
  ///   F = m omega x (omega x c),   T = sum m_i (r_i x omega) (omega . r_i)
  struct Wrench {
    btVector3 force_W;
    btVector3 torque_W;
  };
  Wrench cancelling(const btMatrix3x3& R_WB, const btVector3& omega_W) const;

 private:
  struct Part {
    btTransform pose_B;  ///< origin in the part's centre of mass
    btScalar mass;
    btVector3 inertia;  ///< about the part's own axes
  };
  bool read(const btMultiBody& multibody);
  void combine();

  std::vector<Part> links_;
  Part base_{btTransform::getIdentity(), 0, btVector3(0, 0, 0)};
  Vector3 inertia_C_ = Vector3::Ones();
  btVector3 centre_B_ = btVector3(0, 0, 0);
  Quaternion q_BC_ = Quaternion::Identity();
};

}  // namespace POLHODE_PRECISION
}  // namespace polhode
