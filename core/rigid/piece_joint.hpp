// SPDX-License-Identifier: Apache-2.0
// Strong coupling of pieces to the solvers of incompressible and of highly viscous liquids [GPBPT19].
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/particles/joint_motion.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Makes the velocity changes of a piece's particles a rigid motion. Requires: rows of the pieces of owned
/// particles. Pieces must not move while this object is in use.
class PieceJoint : public JointMotion {
 public:
  PieceJoint(const RigidView& view, Reducer& all);
  void join(std::span<Vec3d> changes) override;
  void kick() override;
  void keep() override;

 private:
  struct Member {
    std::uint32_t particle, row;
    Vec3d lever;  ///< m, from the centre of the piece
  };
  RigidView view_;
  Reducer& all_;
  std::vector<Member> members_;
  std::vector<Vec3d> impulse_, twist_;  ///< N s and N m s by row, from the last call of join
};

}  // namespace thaw
