// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/piece_joint.hpp"

#include "core/rigid/motion.hpp"
#include "core/rigid/piece_sums.hpp"

namespace thaw {

PieceJoint::PieceJoint(const RigidView& view, Reducer& all) : view_(view), all_(all) {
  const Continuum& p = view.particles;
  for (std::uint32_t i = 0; i < p.owned; i++)
    if (p.piece[i] != notRigid)
      members_.push_back(
          {i, p.pieceRow[i], rotated(view.pieces.orientation[p.pieceRow[i]], p.bodyPosition[i])});
}

void PieceJoint::join(std::span<Vec3d> changes) {
  constexpr std::size_t perPiece = 6;
  const Pieces& s = view_.pieces;
  std::vector<ExactSum>& sums = view_.work.sums;
  sums.assign(perPiece * s.owned, ExactSum{});
  for (const Member& m : members_) {
    const Vec3d impulse = view_.particles.mass[m.particle] * changes[m.particle],
                twist = cross(m.lever, impulse);
    for (int a = 0; a < 3; a++) {
      sums[perPiece * m.row + static_cast<std::size_t>(a)].add(impulse[a]);
      sums[perPiece * m.row + 3 + static_cast<std::size_t>(a)].add(twist[a]);
    }
  }
  RankPieceExchange exchange = exchangeOf(s, view_.work, all_);
  sumOverRanks(exchange, sums, perPiece, view_.work.words);
  impulse_.resize(s.owned);
  twist_.resize(s.owned);
  std::vector<Vec3d> velocity(s.owned), spin(s.owned);
  for (std::size_t k = 0; k < s.owned; k++) {
    for (int a = 0; a < 3; a++) {
      impulse_[k][a] = sums[perPiece * k + static_cast<std::size_t>(a)].value();
      twist_[k][a] = sums[perPiece * k + 3 + static_cast<std::size_t>(a)].value();
    }
    if (s.fixed[k]) continue;
    velocity[k] = impulse_[k] / s.mass[k];
    spin[k] = spinOf(s, k, twist_[k]);
  }
  for (const Member& m : members_) changes[m.particle] = velocity[m.row] + cross(spin[m.row], m.lever);
}

void PieceJoint::kick() {
  Pieces& s = view_.pieces;
  for (std::size_t k = 0; k < s.owned; k++) addImpulse(view_, k, impulse_[k], twist_[k]);
  for (const Member& m : members_)
    view_.particles.velocity[m.particle] = velocityOf(s, m.row) +
                                           cross(spinOf(s, m.row, s.angularMomentum[m.row]), m.lever);
}

void PieceJoint::keep() {
  Pieces& s = view_.pieces;
  for (std::size_t k = 0; k < s.owned; k++) {
    s.pressureImpulse[k] = s.fixed[k] ? Vec3d{} : impulse_[k];
    s.pressureTwist[k] = s.fixed[k] ? Vec3d{} : twist_[k];
  }
}

}  // namespace thaw
