// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/adaptive_sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/halo/exchange.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/adaptive_sampling/blocked_sites.hpp"
#include "core/oriented/adaptive_sampling/follow_interpolant.hpp"
#include "core/oriented/adaptive_sampling/ledger_row.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/interpolation/interpolant.hpp"

namespace thaw {
namespace {

using std::numbers::pi;
// Radius around a birth that must be free, in spacings. Lennard-Jones would eject a closer particle.
constexpr double clearance = 0.86;
// Widest gap that is filled, in spacings. Wider gaps contain particles, or are borders.
constexpr double widestGap = 2.9;
// Empty radius around a gap's middle over the gap's width. It is Gabriel's test, slightly short of the ends.
constexpr double emptyShare = 0.45;
// Sine of the largest angle between a gap and the surface at its ends. A particle above a surface forms no
// gap with it.
constexpr double steepest = 0.7;
// Height above and below a gap that must be free, in spacings. No particle can then return into the gap.
constexpr double column = 2;
constexpr double ring = 1.5;  // spacings, radius around a birth in which a lattice at rest has six neighbours
constexpr int mostInRing = 6;
constexpr int leastInRing = 3;  // fewest neighbours of a gap's end; with fewer, it is a stray particle, not a
                                // surface edge
// Kinetic energy of the relative motion of a gap's ends, over the depth of Lennard-Jones' well. Above this,
// the ends separate.
constexpr double burst = 0.5;
constexpr double beside = 1.65;  // spacings, range of neighbours for an open border
// Angle (rad) between neighbours with space for another one. It is 60 degrees in a hexagonal lattice.
constexpr double openAngle = 1.95;
// Smallest distance of births at borders from obstacles, as a fraction of the thickness. A surface on an
// obstacle keeps a larger distance, unless bonds pull it inward, as at a gap.
constexpr double fromObstacles = 0.5;
constexpr std::uint64_t bornBit = std::uint64_t(1) << 63;

struct BirthCandidate {
  bool there = false;
  Vec3d place{}, normal{};
  double apart = 0;  ///< m, smallest allowed distance from obstacles
};

/// Returns whether no neighbour of i on the same surface lies within a radius (m) of a position. Normals are
/// ignored.
bool isFree(const Oriented& o, const OrientedLists& l, std::size_t i, const Vec3d& place, double radius) {
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
    const Vec3d d = o.position[l.list[k]] - place;
    if (sameSurface(o, i, l.list[k]) && dot(d, d) < radius * radius) return false;
  }
  const Vec3d d = o.position[i] - place;
  return dot(d, d) >= radius * radius;
}

bool isNeighbour(const Oriented& o, const PairPotential& p, std::size_t i, std::size_t j) {
  return sameSurface(o, i, j) && (!p.facing || dot(o.normal[i], o.normal[j]) > 0);
}

/// Returns whether the candidate lies in a gap of width `far` between i and j, where the surface is stretched
/// or torn. Surfaces that rest or vibrate have no gaps. There, the gap's sphere or column is occupied, the
/// ring is full, or a birth costs more energy than a bond. Separating particles do not form a surface.
bool isGap(const Oriented& o, const OrientedLists& l, const PairPotential& p, std::size_t i, std::size_t j,
           const BirthCandidate& at, int leastBeside, bool planar) {
  const Vec3d r = o.position[j] - o.position[i], apart = o.velocity[j] - o.velocity[i];
  const double far = length(r), rise = steepest * far;
  if (!planar && (std::abs(dot(o.normal[i], r)) > rise || std::abs(dot(o.normal[j], r)) > rise ||
                  std::abs(dot(at.normal, r)) > rise))
    return false;
  const double holds = p.scale * (p.attract > 0 ? p.attract : std::max({p.plane, p.normal, p.circle}));
  if (0.25 * o.mass[i] * dot(apart, apart) > burst * holds) return false;
  const double free = std::max(clearance * p.spacing, emptyShare * far), free2 = free * free,
               ring2 = ring * ring * p.spacing * p.spacing;
  const Vec3d back = o.position[i] - at.place;
  if (dot(back, back) < clearance * clearance * p.spacing * p.spacing) return false;
  int around = 1, beside = 0;  // neighbours of the position, including i; neighbours of i
  double energy = pairForces(p, back, at.normal, o.normal[i]).energy;
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
    const std::uint32_t q = l.list[k];
    if (!sameSurface(o, i, q)) continue;
    const Vec3d d = o.position[q] - at.place, along = o.position[q] - o.position[i];
    const double d2 = dot(d, d), height = dot(d, at.normal);
    if (d2 < free2) return false;
    if (!isNeighbour(o, p, i, q)) continue;
    if (q != j && d2 - height * height < free2 && std::abs(height) < column * p.spacing) return false;
    around += d2 < ring2;
    beside += dot(along, along) < ring2;
    energy += pairForces(p, d, at.normal, o.normal[q]).energy;
  }
  return beside >= leastBeside && around <= mostInRing && (energy < p.attract * p.scale || p.attract == 0);
}

/// Returns the candidate half-way along the arc to the neighbour across the widest gap. The particle with the
/// lower id creates it.
BirthCandidate candidateInGap(const Oriented& o, const OrientedWork& work, const OrientedBody& body,
                              const PairPotential& p, std::size_t i) {
  const OrientedLists& l = work.lists;
  BirthCandidate best;
  // given points may be isolated, and ends of a line have one neighbour
  const int leastBeside = body.planar || !work.given[o.body[i]].points.empty() ? 0 : leastInRing;
  double widest = body.gap * p.spacing;
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
    const std::uint32_t j = l.list[k];
    const Vec3d r = o.position[j] - o.position[i];
    const double far = length(r);
    if (!isNeighbour(o, p, i, j) || o.id[i] > o.id[j] || far <= widest || far > widestGap * p.spacing)
      continue;
    const Vec3d n = normalized(o.normal[i] + o.normal[j]);
    // middle of the arc
    const BirthCandidate candidate{
        true, o.position[i] + 0.5 * r + (0.125 * dot(o.normal[j] - o.normal[i], r)) * n, n};
    if (!isGap(o, l, p, i, j, candidate, leastBeside, body.planar)) continue;
    widest = far;
    best = candidate;
  }
  return best;
}

/// Returns a candidate one spacing away in the widest sector without neighbours, 60 degrees from its edge, on
/// the arc that follows the neighbours' normals.
BirthCandidate candidateAtBorder(const Oriented& o, const OrientedWork& work, const Scene& scene,
                                 const PairPotential& p, std::size_t i) {
  const OrientedLists& l = work.lists;
  const Vec3d n = o.normal[i], e = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0},
              u = normalized(cross(n, e)), v = cross(n, u);
  std::array<double, 64> angle;
  std::size_t count = 0;
  double bend = 0, weight = 0;  // mean curvature, from the change of normals along r
  for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
    const std::uint32_t j = l.list[k];
    const Vec3d r = o.position[j] - o.position[i];
    const double far2 = dot(r, r);
    if (!isNeighbour(o, p, i, j)) continue;
    if (far2 < 4 * p.spacing * p.spacing) bend += dot(o.normal[j] - n, r), weight += far2;
    if (far2 < beside * beside * p.spacing * p.spacing && count < angle.size())
      angle[count++] = std::atan2(dot(r, v), dot(r, u));
  }
  double at = 2 * pi * randomUniform(scene.seed, Purpose::OrientedBirth, o.id[i]), widest = 2 * pi;
  if (count > 0) {
    std::sort(angle.begin(), angle.begin() + static_cast<std::ptrdiff_t>(count));
    widest = 0;
    for (std::size_t k = 0; k < count; k++) {
      const double next = k + 1 < count ? angle[k + 1] : angle[0] + 2 * pi, room = next - angle[k];
      if (room <= widest) continue;
      widest = room;
      at = angle[k] + (room > 2.4 ? pi / 3 : 0.5 * room);
    }
  }
  if (widest < openAngle) return {};
  const Vec3d way = std::cos(at) * u + std::sin(at) * v;
  // rad, turn of the normal over a spacing
  const double turn = std::clamp(weight > 0 ? bend / weight * p.spacing : 0, -0.7, 0.7);
  BirthCandidate candidate{
      true, o.position[i] + p.spacing * (std::cos(0.5 * turn) * way - std::sin(0.5 * turn) * n),
      std::cos(turn) * n + std::sin(turn) * way};
  const PointInterpolant& given = work.given[o.body[i]];
  if (!given.points.empty() && !projectOnInterpolant(given, candidate.place, candidate.normal)) return {};
  if (dot(candidate.normal, n) < 0.2 || !isFree(o, l, i, candidate.place, clearance * p.spacing)) return {};
  return candidate;
}

/// Corrects the impulse of gravity for rows that enter or leave. The ledger assumes half kicks
/// (core/simulation/time/integrate.cpp), but oriented particles get the whole impulse at the start of a step.
/// A newborn particle has got none of it, a removed particle all of it.
void recordGravityImpulse(const OrientedView& w, std::size_t i, double time) {
  for (int a = 0; a < 3; a++)
    if (const double impulse = w.oriented.rows.mass[i] * w.scene.domain.gravity[a] * time; impulse != 0)
      w.ledger.gravityImpulse[a].add(impulse);
}

/// Returns for each body the largest candidate rank (63 bits) for which the number of its particles stays
/// within `most`. Bodies that can take all candidates have no limit.
std::vector<std::uint64_t> rankLimits(const Oriented& o, const Scene& scene,
                                      const std::vector<std::int64_t>& members,
                                      const std::vector<std::uint32_t>& parents, Reducer& all) {
  const std::size_t bodies = members.size();
  const auto born = [&](const std::vector<std::uint64_t>& limit) {
    std::vector<std::int64_t> n(bodies, 0);
    for (const std::uint32_t i : parents) n[o.body[i]] += o.candidatePriority[i] <= limit[o.body[i]];
    all.sum(n);
    return n;
  };
  std::vector<std::uint64_t> low(bodies, 0), high(bodies, std::uint64_t(1) << 63), limit = high;
  std::vector<std::int64_t> n = born(limit);
  std::vector<std::size_t> over;
  for (std::size_t b = 0; b < bodies; b++)
    if (members[b] + n[b] > scene.oriented[b].most) over.push_back(b);
  for (int k = 0; k < 63 && !over.empty(); k++) {
    for (const std::size_t b : over) limit[b] = low[b] + (high[b] - low[b]) / 2;
    n = born(limit);
    for (const std::size_t b : over) (members[b] + n[b] > scene.oriented[b].most ? high : low)[b] = limit[b];
  }
  for (const std::size_t b : over) limit[b] = low[b];
  return limit;
}

void insertCandidate(const OrientedView& w, const PairPotential& p, std::size_t parent,
                     const BirthCandidate& candidate, double dt) {
  Oriented& o = w.oriented.rows;
  const std::size_t i = o.owned;
  o.resize(i + 1, 0);
  o.id[i] = bornBit | randomBits(w.scene.seed, Purpose::OrientedBirth, o.id[parent],
                                 static_cast<std::uint64_t>(w.clock.step) + 1) >>
                          1;
  o.position[i] = candidate.place;
  o.velocity[i] = o.velocity[parent];
  o.mass[i] = orientedMass(w.scene.oriented[o.body[parent]], p.spacing);
  o.inertia[i] = w.scene.oriented[o.body[parent]].inertia * o.mass[i] * p.spacing * p.spacing;
  o.body[i] = o.body[parent];
  o.group[i] = o.group[parent];
  o.cutSides[i] = o.cutSides[parent];
  o.orientation[i] = o.restOrientation[i] = towards(candidate.normal);
  o.restPosition[i] = candidate.place;
  o.flags[i] |= w.modules.orientedContact ? newborn | emerging : newborn;
  addOrientedRow(o, i, w.scene.domain.gravity, w.ledger.entered);
  recordGravityImpulse(w, i, -0.5 * dt);
  w.counters.orientedBirths++;
}

/// Returns the birth candidate of an owned particle, in a gap or at a border.
BirthCandidate candidateOf(const OrientedView& w, std::size_t i) {
  const Oriented& o = w.oriented.rows;
  const OrientedBody& body = w.scene.oriented[o.body[i]];
  const PairPotential& p = w.work.potentials[o.body[i]];
  BirthCandidate found = candidateInGap(o, w.work, body, p, i);
  if (!found.there && body.growth == OrientedGrowth::Borders) {
    found = candidateAtBorder(o, w.work, w.scene, p, i);
    found.apart = fromObstacles * body.thickness * p.spacing;
  }
  const bool periodic = w.grid.periodic[0] || w.grid.periodic[1] || w.grid.periodic[2];
  if (found.there && !periodic && !w.scene.domain.holds(found.place)) found.there = false;
  return found;
}

/// Returns the candidates of owned particles. Sets displacements and ranks of candidates, also for ghosts.
/// All criteria use columns that ghosts have. members: number of particles of each body on all ranks.
/// Collective.
std::vector<BirthCandidate> findCandidates(const OrientedView& w, Halos halos,
                                           const std::vector<std::int64_t>& members) {
  Oriented& o = w.oriented.rows;
  std::vector<BirthCandidate> candidates(o.owned);
  std::vector<std::uint32_t> parents;
  std::vector<BirthSite> sites;
  for (std::size_t i = 0; i < o.owned; i++) {
    o.candidatePriority[i] = 0;
    o.candidate[i] = {};
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    if (body.growth == OrientedGrowth::None || members[o.body[i]] >= body.most) continue;
    candidates[i] = candidateOf(w, i);
    if (!candidates[i].there) continue;
    parents.push_back(static_cast<std::uint32_t>(i));
    sites.push_back({o.body[i], candidates[i].place, candidates[i].apart});
  }
  const std::vector<char> blocked = blockedSites(w, sites, halos.all);
  for (std::size_t k = 0; k < parents.size(); k++) {
    const std::uint32_t i = parents[k];
    if (blocked[k]) continue;
    o.candidate[i] = candidates[i].place - o.position[i];
    o.candidatePriority[i] = 1 + (randomBits(w.scene.seed, Purpose::OrientedBirth, o.id[i],
                                             static_cast<std::uint64_t>(w.clock.step)) >>
                                  1);
  }
  refresh(*halos.bodyTypes[orientedType], o, ColumnList{&o.candidate, &o.candidatePriority}).wait();
  return candidates;
}

/// Owned rows that give birth or die in this step.
struct PopulationChange {
  std::vector<std::uint32_t> parents, dead;
};

/// Selects births and deaths among conflicting candidates and crowded particles, by their ranks.
PopulationChange selectChanges(const OrientedView& w) {
  const Oriented& o = w.oriented.rows;
  const OrientedLists& l = w.work.lists;
  const auto deathRank = [&](std::size_t i) {
    return randomBits(w.scene.seed, Purpose::OrientedDeath, o.id[i],
                      static_cast<std::uint64_t>(w.clock.step));
  };
  PopulationChange change;
  for (std::size_t i = 0; i < o.owned; i++) {
    const OrientedBody& body = w.scene.oriented[o.body[i]];
    const PairPotential& p = w.work.potentials[o.body[i]];
    bool wins = o.candidatePriority[i] > 0, dies = isOffInterpolant(o, w.work, i);
    const std::uint64_t own = deathRank(i);
    for (std::uint32_t k = l.first[i]; k < l.first[i + 1]; k++) {
      const std::uint32_t j = l.list[k];
      if (!sameSurface(o, i, j)) continue;
      const Vec3d r = o.position[j] - o.position[i];
      if (wins && o.candidatePriority[j] > 0 && o.candidatePriority[j] < o.candidatePriority[i]) {
        const Vec3d d = r + o.candidate[j] - o.candidate[i];
        wins = dot(d, d) >= 0.81 * p.spacing * p.spacing;
      }
      if (body.removalDistance > 0 && !(o.flags[i] & fixedPosition) && isNeighbour(o, p, i, j) &&
          dot(r, r) < body.removalDistance * body.removalDistance * p.spacing * p.spacing)
        dies = dies || (o.flags[j] & fixedPosition) || own < deathRank(j);
    }
    if (dies) change.dead.push_back(static_cast<std::uint32_t>(i));
    else if (wins) change.parents.push_back(static_cast<std::uint32_t>(i));
  }
  return change;
}

}  // namespace

void removeRow(const OrientedView& w, std::size_t i, double dt) {
  Oriented& o = w.oriented.rows;
  o.energy[i] = 0;
  addOrientedRow(o, i, w.scene.domain.gravity, w.ledger.left);
  w.ledger.dissipated.add(o.dissipated[i]);
  recordGravityImpulse(w, i, 0.5 * dt);
  o.mass[i] = 0;  // dropped by redistributeOriented
}

bool adaptSamplingDue(const Scene& scene, const Clock& clock, double dt) {
  bool due = false;
  if (dt == 0) return due;
  for (const OrientedBody& b : scene.oriented)
    due = due ||
          ((b.growth != OrientedGrowth::None || b.removalDistance > 0) && (clock.step + 1) % b.every == 0);
  return due;
}

bool adaptSampling(const OrientedView& w, Halos halos, double dt) {
  Oriented& o = w.oriented.rows;
  std::vector<std::int64_t> members(w.scene.oriented.size(), 0);
  for (std::size_t i = 0; i < o.owned; i++) members[o.body[i]]++;
  halos.all.sum(members);
  const std::vector<BirthCandidate> candidates = findCandidates(w, halos, members);
  PopulationChange change = selectChanges(w);
  if (std::any_of(w.scene.oriented.begin(), w.scene.oriented.end(),
                  [](const OrientedBody& b) { return b.growth != OrientedGrowth::None; })) {
    const std::vector<std::uint64_t> limit = rankLimits(o, w.scene, members, change.parents, halos.all);
    std::erase_if(change.parents, [&](std::uint32_t i) { return o.candidatePriority[i] > limit[o.body[i]]; });
  }
  std::int64_t changed = static_cast<std::int64_t>(change.parents.size() + change.dead.size());
  halos.all.sum({&changed, 1});
  if (changed == 0) return false;
  o.resize(o.owned, 0);
  for (const std::uint32_t i : change.parents)
    insertCandidate(w, w.work.potentials[o.body[i]], i, candidates[i], dt);
  for (const std::uint32_t i : change.dead) removeRow(w, i, dt);
  w.counters.orientedDeaths += static_cast<std::int64_t>(change.dead.size());
  return true;
}

}  // namespace thaw
