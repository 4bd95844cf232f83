// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/breaking/break_pieces.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/math/sym_eigen.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/rigid/breaking/elastic_solve.hpp"
#include "core/rigid/breaking/impacts.hpp"
#include "core/rigid/connect.hpp"
#include "core/rigid/contact_impulses.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/piece_sums.hpp"
#include "core/rigid/update_pieces.hpp"
#include "core/solid/bonds/weight.hpp"

namespace thaw {
namespace {

/// Plane that cuts a piece.
struct Cut {
  double ratio = 1;          ///< principal stress over the strength; above 1
  std::uint64_t particle;    ///< id
  Vec3d origin{}, normal{};  ///< m, and a unit vector
};

using Cuts = std::vector<std::optional<Cut>>;  // by row of pieces

bool comesBefore(const Cut& a, const Cut& b) {
  return a.ratio > b.ratio || (a.ratio == b.ratio && a.particle < b.particle);
}

/// Returns the largest principal stress and its direction.
std::pair<double, Vec3d> principalStress(const Sym3d& stress) {
  const SymEigen e = eigenOf(stress);
  int k = 0;
  for (int a = 1; a < 3; a++)
    if (e.value[a] > e.value[k]) k = a;
  return {e.value[k], e.vector[k]};
}

/// Returns the middle (m, relative to the particle) of the member's bond with the largest tension along a
/// direction.
Vec3d mostStretched(const BondedPieces& b, std::size_t m, const BondedMotion& motion, const Vec3d& along) {
  double most = -never;
  Vec3d middle{};
  for (const BondedPieces::Bond& bond : b.of(m)) {
    const Generalised f = bondForce(bond, b.member[m], b.spacing, motion);
    const Vec3d n = normalized(bond.arm);
    const double share = dot(n, along) * dot(n, along);
    const double tension = share *
                           (dot(f.linear, n) + 6 / b.spacing * length(f.angular - dot(f.angular, n) * n));
    if (!(tension > most)) continue;
    most = tension;
    middle = 0.5 * bond.arm;
  }
  return middle;
}

/// Returns for each row of pieces a cut at the most overloaded particle on this rank.
Cuts cutsHere(const RigidView& v, const BondedPieces& b, const BondedMotion& motion) {
  const Continuum& p = v.particles;
  Cuts cuts(v.pieces.owned);
  for (std::size_t m = 0; m < b.member.size(); m++) {
    const std::uint32_t i = b.member[m];
    const double strength = v.scene.materials[p.material[i]].strength;
    if (!(strength < never) || b.of(m).empty()) continue;
    const auto [stress, along] = principalStress(stressOf(b, m, i, motion));
    const Cut cut{stress / strength, p.id[i], p.position[i] + mostStretched(b, m, motion, along), along};
    std::optional<Cut>& best = cuts[b.pieces[b.system[m]]];
    if (cut.ratio > 1 && (!best || comesBefore(cut, *best))) best = cut;
  }
  return cuts;
}

/// Replaces the cuts of this rank by the cuts with the largest ratio on any rank.
void chooseCuts(const RigidView& v, std::span<const std::uint32_t> hit, Cuts& cuts, Reducer& all) {
  constexpr std::size_t width = 9;  // piece, particle, ratio, origin, normal
  PieceRecords own{width, {}};
  for (const std::uint32_t k : hit) {
    if (!cuts[k]) continue;
    own.words.insert(own.words.end(), {v.pieces.id[k], cuts[k]->particle});
    addNumber(own.words, cuts[k]->ratio);
    addPlace(own.words, cuts[k]->origin);
    addPlace(own.words, cuts[k]->normal);
  }
  const PieceRecords shared = shareRecords(own, idsOf(v.pieces, hit), all);
  for (std::size_t r = 0; r < shared.size(); r++) {
    const Cut cut{shared.number(r, 2), shared.at(r)[1], shared.place(r, 3), shared.place(r, 6)};
    std::optional<Cut>& best = cuts[v.pieces.rowOf(shared.at(r)[0])];
    if (!best || comesBefore(cut, *best)) best = cut;
  }
}

/// Marks the particles on both sides of the cuts. They do not weld while they stay hot. ahead: side of each
/// row.
void markFractures(const RigidView& v, std::span<const std::uint8_t> ahead) {
  Continuum& p = v.particles;
  if (!p.touchTime.active) return;
  const double reach = connectedDistance * v.scene.spacing;
  eachNear(v.cells, p.owned, v.cells, [&](std::uint32_t i, std::uint32_t j) {
    const Vec3d to = p.position[j] - p.position[i];
    if (p.piece[i] != notRigid && p.piece[i] == p.piece[j] && ahead[i] != ahead[j] &&
        dot(to, to) < reach * reach)
      p.touchTime[i] = atFracture;
  });
}

/// Splits pieces along their cuts.
void splitPieces(const RigidView& v, const Halos& halos, const Cuts& cuts) {
  const Continuum& p = v.particles;
  const Periods periods = periodsOf(v.grid);
  std::vector<std::uint8_t> ahead(p.size(), 0);  // side of the plane
  for (std::size_t i = 0; i < p.size(); i++) {
    if (p.piece[i] == notRigid || !cuts[p.pieceRow[i]]) continue;
    const Cut& cut = *cuts[p.pieceRow[i]];
    ahead[i] = dot(minimumImage(p.position[i] - cut.origin, periods), cut.normal) > 0;
  }
  std::int64_t broken = 0;
  for (std::size_t k = 0; k < cuts.size(); k++) broken += cuts[k] && v.pieces.recordsEnergy[k];
  labelPieces(v, halos, false,
              {.parted = [&](std::uint32_t i, std::uint32_t j) { return ahead[i] != ahead[j]; }});
  markFractures(v, ahead);
  remakePieces(v, halos, false);
  linkPieces(v, halos, PieceUsers::AndGhosts);
  halos.all.sum({&broken, 1});
  if (halos.all.rank() == 0) v.counters.brokenPieces += broken;
}

/// Breaks the hit pieces whose strength is exceeded. Returns true if any piece broke on any rank.
bool breakHit(const RigidView& v, const Halos& halos, std::span<const FoundContact> contacts,
              std::span<const std::uint32_t> hit) {
  double any = hit.empty() ? 0 : 1;
  halos.all.maximum({&any, 1});
  if (!(any > 0)) return false;
  const ImpactLoads loads = impactLoads(v, contacts, hit, halos.all);
  const BondedPieces bonded = bondPieces(v, hit);
  BondedMotion motion;
  const bool converged = solveBonds(v, halos, bonded, balancedLoads(v, bonded, loads), motion);
  v.counters.impactsUnfinished += !converged && halos.all.rank() == 0;
  Cuts cuts = cutsHere(v, bonded, motion);
  chooseCuts(v, hit, cuts, halos.all);
  any = std::ranges::any_of(cuts, [](const auto& c) { return c.has_value(); }) ? 1 : 0;
  halos.all.maximum({&any, 1});
  if (!(any > 0)) return false;
  splitPieces(v, halos, cuts);
  return true;
}

/// Records the loads with which impulses of the next step are compared. The loads decay over several steps,
/// so a contact that is lost for one step does not return as an impact.
void recordLoads(Pieces& p, std::span<const double> sizes, double dt) {
  constexpr double kept = 0.5;
  for (std::size_t k = 0; k < p.owned; k++)
    p.contactLoad[k] = std::max(sizes[k] / dt, kept * p.contactLoad[k]);
}

/// Alternates between the contact solve and the breaking of overloaded pieces. Returns the contacts of the
/// final pieces.
SolvedContacts solveAndBreak(const RigidView& v, const Halos& halos, double dt) {
  for (int cuts = 0;; cuts++) {
    SolvedContacts solved = findContactImpulses(v, halos, dt);
    const std::vector<double> sizes = contactSizes(v, solved.contacts, halos.all);
    if (cuts < mostCuts && breakHit(v, halos, solved.contacts, findHit(v, sizes, dt))) continue;
    recordLoads(v.pieces, sizes, dt);
    return solved;
  }
}

}  // namespace

void touchAndBreak(const RigidView& v, const Halos& halos, double dt) {
  acceptContacts(v, v.modules.breaking ? solveAndBreak(v, halos, dt) : findContactImpulses(v, halos, dt), dt,
                 halos.all);
}

}  // namespace thaw
