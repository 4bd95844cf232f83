// SPDX-License-Identifier: Apache-2.0
// Pieces in the solvers of incompressible and of thick liquids: strong coupling [GPBPT19].
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/particles/joint_motion.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Joins the velocity changes of the particles of pieces. Requires: rows of the pieces of owned particles,
/// which do not move while it is in use.
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
  std::vector<Vec3d> impulse_, twist_;  ///< N s and N m s by row, of the last call of join
};

}  // namespace thaw
