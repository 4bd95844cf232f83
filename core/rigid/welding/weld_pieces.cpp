// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/welding/weld_pieces.hpp"

#include <algorithm>
#include <vector>

#include "core/halo/exchange.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/rigid/connect.hpp"
#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/sleeping_pieces.hpp"
#include "core/rigid/update_pieces.hpp"

namespace thaw {
namespace {

constexpr double largestGap = 0.02;   // spacings, between surfaces that touch
constexpr double smallestGap = -0.5;  // spacings; elements with larger overlap do not face each other

/// Largest distance (spacings) between two particles that weld. It is below connectedDistance, so rounding
/// does not separate welded particles.
constexpr double weldDistance = 1.4;
static_assert(weldDistance < connectedDistance);

/// Returns true if temperature and position of a particle allow a weld.
bool isHotSurface(const RigidView& v, std::size_t i) {
  const Continuum& p = v.particles;
  return hasSurface(p, i) && p.temperature[i] > v.scene.materials[p.material[i]].weldTemperature;
}

bool mayWeld(const RigidView& v, std::size_t i) {
  return isHotSurface(v, i) && v.particles.touchTime[i] != atFracture;
}

/// Returns true if two particles of different pieces touch and may weld. The function is symmetric.
bool touch(const RigidView& v, std::size_t i, std::size_t j) {
  const Continuum& p = v.particles;
  if (p.piece[i] == p.piece[j] || p.material[i] != p.material[j]) return false;
  const double spacing = v.scene.spacing, most = weldDistance * spacing;
  const Vec3d d = p.position[j] - p.position[i];
  if (!(dot(d, d) < most * most) || !mayWeld(v, i) || !mayWeld(v, j)) return false;
  if (p.id[j] < p.id[i]) std::swap(i, j);
  const std::optional<ElementContact> c = contactOf(placedElement(p, v.pieces, i, spacing),
                                                    placedElement(p, v.pieces, j, spacing), spacing);
  return c && c->gap < largestGap * spacing && c->gap > smallestGap * spacing;
}

bool touchedLongEnough(const RigidView& v, std::size_t i) {
  const Continuum& p = v.particles;
  return p.touchTime[i] >= v.scene.materials[p.material[i]].weldTime;
}

bool weld(const RigidView& v, std::size_t i, std::size_t j) {
  return touchedLongEnough(v, i) && touchedLongEnough(v, j) && touch(v, i, j);
}

/// Resets the touch time of cold and of inner particles. Returns true if any particle of this rank may weld.
bool resetOthers(const RigidView& v) {
  Continuum& p = v.particles;
  bool any = false;
  for (std::size_t i = 0; i < p.owned; i++)
    if (!isHotSurface(v, i)) p.touchTime[i] = 0;
    else any = any || mayWeld(v, i);
  return any;
}

bool touchesAny(const RigidView& v, std::size_t i, std::span<const RowSpan> ranges) {
  return std::ranges::any_of(ranges, [&](const RowSpan& r) {
    for (std::uint32_t j = r.begin; j < r.end; j++)
      if (touch(v, i, j)) return true;
    return false;
  });
}

/// Updates the touch time of particles that may weld. Returns true if any particle of this rank has touched
/// another piece long enough.
bool measureTouch(const RigidView& v) {
  Continuum& p = v.particles;
  bool any = false;
  eachSurrounded(
      v.cells, p.owned, v.cells, [&](std::uint32_t i) { return mayWeld(v, i); },
      [&](std::uint32_t i, std::span<const RowSpan> ranges) {
        const bool touches = touchesAny(v, i, ranges);
        p.touchTime[i] = touches ? p.touchTime[i] + v.clock.stepDt : 0;
        any = any || (touches && touchedLongEnough(v, i));
      });
  return any;
}

bool onAnyRank(bool here, Reducer& all) {
  double any = here ? 1 : 0;
  all.maximum({&any, 1});
  return any > 0;
}

/// Returns the number of pieces that this rank leads.
std::int64_t ownPieces(const Pieces& p) {
  return std::count(p.recordsEnergy.data(), p.recordsEnergy.data() + p.owned, 1);
}

}  // namespace

void weldPieces(const RigidView& v, const Halos& halos) {
  Continuum& p = v.particles;
  if (!onAnyRank(resetOthers(v), halos.all)) return;
  refresh(halos.cells, p, ColumnList{&p.temperature, &p.touchTime}).wait();
  if (!onAnyRank(measureTouch(v), halos.all)) return;
  refresh(halos.cells, p, ColumnList{&p.touchTime}).wait();
  std::int64_t welded = ownPieces(v.pieces);
  labelPieces(v, halos, false, {.welded = [&](std::uint32_t i, std::uint32_t j) { return weld(v, i, j); }});
  if (v.modules.pieceSleep) wakeNearChanges(v, halos.all);
  remakePieces(v, halos, false);
  linkPieces(v, halos, PieceUsers::AndGhosts);
  welded -= ownPieces(v.pieces);
  halos.all.sum({&welded, 1});
  if (halos.all.rank() == 0) v.counters.weldedPieces += welded;
}

}  // namespace thaw
