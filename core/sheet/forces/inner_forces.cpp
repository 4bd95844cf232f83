// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/forces/inner_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sheet/forces/cell_sums.hpp"
#include "core/sheet/forces/time_factors.hpp"

namespace thaw {

void activateEdges(SheetEdges& e) {
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&e.ends.id, &e.ends.particle, &e.ends.material,
                                                        &e.ends.position, &e.ends.changed})
    e.ends.activate(*c);
}

void clearEdges(SheetBodies& b) {
  b.edges.ends.resize(b.edges.ends.owned, 0);
  b.edges.ends.resize(0, 0);
  b.edges.bonds = {};
  b.edgesAtStart = true;
}

void clearSolidsAtStart(SheetBodies& b, bool left) {
  if (b.edgesAtStart) std::fill_n(b.rows.solidIndex.data(), b.rows.owned, noSolid);
  b.leftHere = b.leftHere || left;
}

std::vector<BondRequest> edgeRequests(const SheetBodies& b) {
  std::vector<BondRequest> requests;
  for (std::uint32_t solidIndex = 0; solidIndex < b.edges.ends.owned; solidIndex++) {
    const std::uint64_t id = b.edges.ends.id[solidIndex], sheet = id >> 40;
    const auto v = static_cast<std::uint32_t>(id & ((1ull << 40) - 1));
    const SheetPlan& plan = b.plans[sheet];
    const SheetTopology& t = plan.topology;
    double number = 1;
    const auto ask = [&](std::uint32_t to, double length, double stiffness, double triangle) {
      requests.push_back({solidIndex, sheet << 40 | to, {length, stiffness, triangle}, {}, number++});
    };
    for (std::uint32_t k = t.first[v]; k < t.first[v + 1]; k++) {
      const RingEdge& r = t.ring[k];
      ask(r.to, plan.edgeLength[k], plan.edgeStiffness[k], r.triangle ? 1.0 + r.next : 0.0);
    }
    for (const SheetHinge& h : hingesAt(plan, v)) ask(h.to, h.length, h.stiffness, 0);
  }
  return requests;
}

int searchTriangle(const Bonds& b, std::size_t solidIndex, double next) {
  for (int other = 0; other < b.capacity; other++)  // a neighbour has left the domain
    if (b.weight[b.at(solidIndex, other)] == next) return other;
  return -1;
}

void updateEdgeEnds(SheetBodies& b, BondHalo& edges) {
  Solids& e = b.edges.ends;
  for (std::size_t s = 0; s < e.owned; s++) e.position[s] = b.rows.position[e.particle[s]];
  const std::array<AnyColumn*, 1> columns{&e.position};
  edges.begin(e, columns);
  edges.finish(e);
}

Vec3d areaNormalOf(const SheetEdges& e, std::size_t solidIndex) {
  Vec3d sum{};
  for (int k = 0; k < e.bonds.capacity; k++) {
    if (!(e.bonds.weight[e.bonds.at(solidIndex, k)] > 0)) break;
    const int next = triangleWith(e.bonds, solidIndex, k);
    if (next >= 0) sum += cross(edgeVector(e, solidIndex, k), edgeVector(e, solidIndex, next));
  }
  return sum / 6.0;
}

namespace {

/// Adds the springs of a vertex, and sets its area vector (as areaNormalOf), in one pass over its neighbours.
void addBonds(SheetBodies& b, const Scene& scene, std::size_t solidIndex, bool springs, bool normals) {
  Sheets& s = b.rows;
  const std::uint32_t i = b.edges.ends.particle[solidIndex];
  const SheetBody& body = scene.sheets[s.body[i]];
  const Bonds& bonds = b.edges.bonds;
  const bool limited = body.stretchLimit < never;
  std::vector<SheetFactor> kinds;  // empty if no coefficient changes in time
  if (springs && s.changing.active)
    kinds = springKinds(b.plans[s.body[i]], static_cast<std::uint32_t>(s.id[i] & ((1ull << 40) - 1)));
  const FactorsNow& factors = b.factors[s.body[i]];
  Vec3d force{};
  double energy = 0, slope = 0;
  constexpr int room = 64;
  Vec3d edge[room];
  int count = 0;
  for (; count < bonds.capacity; count++) {
    const std::size_t at = bonds.at(solidIndex, count);
    if (!(bonds.weight[at] > 0)) break;
    const Vec3d d = b.edges.ends.position[bonds.neighbour[at]] - b.edges.ends.position[solidIndex];
    if (count < room) edge[count] = d;
    double stiffness = bonds.y[at], later = stiffness;
    if (!springs || !(stiffness > 0)) continue;
    const SheetFactor kind = kinds.empty() ? SheetFactor::Warp
                                           : kinds[static_cast<std::size_t>(bonds.weight[at]) - 1];
    if (!kinds.empty()) {
      stiffness *= factors.now[placeOf(kind)];
      later *= factors.most[placeOf(kind)];
    }
    const double l = length(d), stretch = l - bonds.x[at];
    double pull = stiffness * stretch, squares = stretch * stretch;
    slope += later;
    if (limited) {
      const double beyond = l - body.stretchLimit * bonds.x[at];
      if (beyond > 0) {
        pull += body.rigid * stiffness * beyond;
        squares += body.rigid * beyond * beyond;
      }
      slope += body.rigid * later;
    }
    energy += 0.25 * stiffness * squares;  // the other half belongs to the other end
    if (!kinds.empty()) factorEnergyOf(s, i, kind) += 0.25 * bonds.y[at] * squares;
    if (l > 0) force += d * (pull / l);
  }
  if (springs) {
    s.load[i] += force / s.area[i];
    s.energy[i] += energy;
    b.slope[i] += 2 * slope / s.area[i];  // Gershgorin's bound counts both ends of each spring
  }
  if (!normals) return;
  if (count > room) {
    s.areaNormal[i] = areaNormalOf(b.edges, solidIndex);
    return;
  }
  Vec3d sum{};
  for (int k = 0; k < count; k++)
    if (const int next = triangleWith(bonds, solidIndex, k); next >= 0)
      sum += cross(edge[k], next < count ? edge[next] : edgeVector(b.edges, solidIndex, next));
  s.areaNormal[i] = sum / 6.0;
}

/// Adds the pressure from volume changes of each part, after a reduction of the volumes.
void addPressure(SheetBodies& b, Reducer& all) {
  Sheets& s = b.rows;
  std::vector<std::uint32_t> parts;
  for (std::uint32_t p = 0; p < b.parts.size(); p++)
    if (b.parts[p].stiffness > 0) parts.push_back(p);
  if (parts.empty()) return;
  // volume, and gradient squared per area: the stiffness of the pressure
  std::vector<ExactSum> sums(2 * parts.size());
  for (std::size_t k = 0; k < parts.size(); k++) {
    const Vec3d origin = b.parts[parts[k]].origin;
    addByCell(b.cells, s.owned, sums[2 * k], [&](std::size_t i) {
      return s.part[i] == parts[k] ? dot(s.position[i] - origin, s.areaNormal[i]) / 3 : 0;
    });
    addByCell(b.cells, s.owned, sums[2 * k + 1], [&](std::size_t i) {
      return s.part[i] == parts[k] ? dot(s.areaNormal[i], s.areaNormal[i]) / s.area[i] : 0;
    });
  }
  std::vector<std::int64_t> digits;
  for (ExactSum& x : sums) {
    x.carry();
    digits.insert(digits.end(), x.digit.begin(), x.digit.end());
  }
  const std::size_t counts = digits.size();
  for (const std::uint32_t p : parts) digits.push_back(std::count(s.part.data(), s.part.data() + s.owned, p));
  all.sum(digits);
  for (std::size_t k = 0; k < sums.size(); k++)
    std::copy_n(digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits), ExactSum::digits,
                sums[k].digit.begin());

  std::vector<double> pressure(b.parts.size(), 0), share(b.parts.size(), 0), whole(b.parts.size(), 0),
      turning(b.parts.size(), 0), slope(b.parts.size(), 0);
  for (std::size_t k = 0; k < parts.size(); k++) {
    SheetPart& p = b.parts[parts[k]];
    if (digits[counts + k] < p.vertices) {  // some vertices have left, so the part is open and encloses no
                                            // volume
      p.now = 0;
      continue;
    }
    const FactorsNow& factors = b.factors[p.sheet];
    const double stiffness = p.stiffness * factors.now[placeOf(SheetFactor::Volume)],
                 later = p.stiffness * factors.most[placeOf(SheetFactor::Volume)];
    p.now = sums[2 * k].value();
    const double change = (p.now - p.volume) / p.volume;
    pressure[parts[k]] = -stiffness * change;
    share[parts[k]] = 0.5 * stiffness * change * change * p.volume / p.area;  // energy per area
    whole[parts[k]] = 0.5 * p.stiffness * change * change * p.volume / p.area;
    slope[parts[k]] = later / p.volume * sums[2 * k + 1].value();
    turning[parts[k]] = later * std::abs(change);
  }
  for (std::size_t i = 0; i < s.owned; i++) {
    const std::uint32_t p = s.part[i];
    if (slope[p] == 0) continue;
    s.load[i] += s.areaNormal[i] * (pressure[p] / s.area[i]);
    s.energy[i] += share[p] * s.area[i];
    if (s.changing.active) factorEnergyOf(s, i, SheetFactor::Volume) += whole[p] * s.area[i];
    // the area vector turns with the neighbours, by a third of a triangle's edge per vertex
    const double turn = 2 * turning[p] / std::sqrt(s.area[i]);
    b.slope[i] += slope[p] + turn;
  }
}

}  // namespace

void addInnerForces(SheetBodies& b, const Scene& scene, Halos halos) {
  bool springs = false, normals = false;
  for (const SheetPlan& p : b.plans) {
    springs = springs || p.edgeForces;
    normals = normals || p.normals;
  }
  if (!springs && !normals) return;
  updateEdgeEnds(b, *halos.edges);
  for (std::size_t solidIndex = 0; solidIndex < b.edges.ends.owned; solidIndex++) {
    const std::uint32_t i = b.edges.ends.particle[solidIndex];
    const SheetPlan& p = b.plans[b.rows.body[i]];
    if (p.edgeForces || p.normals) addBonds(b, scene, solidIndex, p.edgeForces, p.normals);
  }
  if (normals) addPressure(b, halos.all);
}

}  // namespace thaw
