#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "polhode/bullet/precision.h"
#include "polhode/rotation_state.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Returns whether the multibody turns as one rigid body: a free base whose links, if it has any, are all fixed.
bool turns_as_one_body(const btMultiBody& multibody);

/// A base and the links fixed to it as one rigid body. B is the base's frame, C has its origin in the common centre of
/// mass and the principal axes; of a base alone C is B.
class CompositeBody {
 public:
  /// @throws std::bad_alloc
  explicit CompositeBody(const btMultiBody& multibody);

  /// Follows changes of masses, moments and places. Returns false if nothing was changed.
  bool update(const btMultiBody& multibody);

  bool has_links() const { return !links_.empty(); }
  const Vector3& inertia_C() const { return inertia_C_; }  ///< kg m^2
  const btVector3& centre_B() const { return centre_B_; }  ///< of mass, m
  const Quaternion& q_BC() const { return q_BC_; }
  const btTransform& link_pose_B(int link) const { return links_[static_cast<std::size_t>(link)].pose_B; }

  /// The force (on the base) and torque that cancel what Bullet adds to the velocities of a composite body by itself. It
  /// computes the centrifugal forces of the links explicitly, also without the gyroscopic term. With r_i from the
  /// base to the link's centre of mass, c to the common one, and m the mass of all:
  ///
  ///   F = m omega x (omega x c),   T = sum m_i (r_i x omega) (omega . r_i)
  struct Wrench {
    btVector3 force_W;
    btVector3 torque_W;
  };
  Wrench cancelling(const btMatrix3x3& R_WB, const btVector3& omega_W) const;

 private:
  struct Part {
    btTransform pose_B;  ///< origin: its centre of mass
    btScalar mass;
    btVector3 inertia;  ///< about its own axes
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
