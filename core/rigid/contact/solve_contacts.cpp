// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/solve_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "core/rigid/contact/contact_islands.hpp"
#include "core/rigid/contact/fixed_sum.hpp"
#include "core/rigid/contact/solve_island.hpp"

namespace thaw {
namespace {

bool isFinite(const RigidContact& c, std::span<const PieceMotion> pieces) {
  bool finite = std::isfinite(c.gap) && isFinite(c.impulse) && isFinite(c.angularImpulse) &&
                isFinite(c.otherVelocity) && isFinite(c.otherSpin);
  for (const std::uint32_t r : {c.a, c.b})
    if (r != noPiece) finite = finite && isFinite(pieces[r].velocity) && isFinite(pieces[r].spin);
  return finite;
}

enum Balance { Lost, Work, ImpulseX, ImpulseY, ImpulseZ, balances };

/// Sums the dissipated energy, and the work and impulse of obstacles.
void recordBalance(const GatheredIslands& gathered, const std::vector<IslandSolve>& solves, Reducer& all,
                   ContactResult& result) {
  const auto eachContact = [&](auto&& use) {
    for (std::size_t k = 0; k < solves.size(); k++)
      for (std::size_t i = 0; i < gathered.islands[k].contacts.size(); i++) {
        const bool rolls = !solves[k].meanSpin.empty();
        use(gathered.islands[k].contacts[i], solves[k].mean[i], rolls ? solves[k].meanSpin[i] : Vec3d{});
      }
  };
  double scale = 0;
  eachContact([&](const RigidContact& c, const Vec3d& mean, const Vec3d& spin) {
    scale = std::max({scale, length(c.impulse) * (1 + length(mean) + length(c.otherVelocity)),
                      length(c.angularImpulse) * (length(spin) + length(c.otherSpin))});
  });
  all.maximum({&scale, 1});
  if (!(scale > 0)) return;
  ContactSums<balances> sums{FixedUnit::forScale(scale)};
  eachContact([&](const RigidContact& c, const Vec3d& mean, const Vec3d& spin) {
    const Vec3d onPiece = c.b == noPiece ? c.impulse : Vec3d{};
    sums.add({-dot(c.impulse, mean) - dot(c.angularImpulse, spin),
              dot(onPiece, c.otherVelocity) + dot(c.angularImpulse, c.otherSpin), onPiece.x, onPiece.y,
              onPiece.z});
  });
  sums.sum(all);
  result.dissipated = sums.value(Lost);
  result.obstacleWork = sums.value(Work);
  result.obstacleImpulse = {sums.value(ImpulseX), sums.value(ImpulseY), sums.value(ImpulseZ)};
}

/// Sets the numbers of iterations, and the error of the island with the largest ratio of residual to
/// tolerance.
void recordProgress(const std::vector<IslandSolve>& solves, Reducer& all, ContactResult& result) {
  double most[3] = {};  // iterations, iterations of the overlap solve, residual over the tolerance
  const auto excess = [](const IslandSolve& s) { return s.residual / s.tolerance; };
  for (const IslandSolve& s : solves) {
    most[0] = std::max(most[0], static_cast<double>(s.iterations));
    most[1] = std::max(most[1], static_cast<double>(s.correctionIterations));
    most[2] = std::max(most[2], excess(s));
  }
  all.maximum(most);
  double worst[2] = {};  // residual, tolerance
  for (const IslandSolve& s : solves)
    if (excess(s) == most[2] && s.tolerance > worst[1]) {
      worst[0] = s.residual;
      worst[1] = s.tolerance;
    }
  all.maximum(worst);
  result.iterations = static_cast<int>(most[0]);
  result.correctionIterations = static_cast<int>(most[1]);
  result.residual = worst[0];
  if (worst[1] > 0) result.tolerance = worst[1];
  result.converged = most[2] <= 1;
}

}  // namespace

ContactResult solveContacts(std::span<PieceMotion> pieces, std::span<RigidContact> contacts,
                            const ContactSettings& settings, PieceExchange& exchange, Reducer& all,
                            std::span<PieceChange> changes) {
  std::fill(changes.begin(), changes.end(), PieceChange{});
  ContactResult result;
  result.tolerance = settings.tolerance;
  double most[2] = {0, 0};  // overlap; 1: numbers that are not finite
  for (const RigidContact& c : contacts) {
    most[0] = std::max(most[0], -c.gap);
    if (!isFinite(c, pieces)) most[1] = 1;
  }
  all.maximum(most);
  result.deepest = most[0];
  if (most[1] > 0) {
    result.residual = HUGE_VAL;
    result.converged = false;
    return result;
  }
  GatheredIslands gathered = gatherIslands(pieces, contacts, exchange, all);
  std::vector<IslandSolve> solves;
  for (ContactIsland& island : gathered.islands) solves.push_back(solveIsland(island, settings));
  recordProgress(solves, all, result);
  recordBalance(gathered, solves, all, result);
  for (RigidContact& c : contacts) c.impulse = c.angularImpulse = {};
  returnIslands(gathered, pieces, contacts, changes, all);
  return result;
}

}  // namespace thaw
