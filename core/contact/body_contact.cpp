// SPDX-License-Identifier: Apache-2.0
#include "core/contact/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/contact/friction_spring.hpp"
#include "core/neighbours/mixed_cells.hpp"

namespace thaw {
namespace {

/// Sums of a particle over the solids of other bodies. The weights w and g = -dw/dr include the shares of
/// both particles.
struct BodySums {
  double phi = 0, rate = 0;                 ///< 1, 1/s: sum of w, and its rate
  double stiffness = 0, stiffnessRate = 0;  ///< N/m, N/(m s): sum of w k, and its rate
  double dashpot = 0, frictionRate = 0;     ///< kg/s, sums of w times the pair's dashpot and frictionRate
  double friction = 0;                      ///< 1, sum of w mu
  double steepness = 0;                     ///< 1/m, sum of g
  Vec3d away{};                             ///< 1/m, sum of g times the direction from the other particle
  Vec3d motion{};                           ///< 1/s, sum of g times the relative velocity
};

/// Contact of a particle, computed from its sums.
struct Press {
  double energy = 0, rate = 0;  ///< J, W
  /// The force of a pair is (byStiffness k + alone + dash) g.
  double byStiffness = 0, alone = 0, dash = 0;  ///< m^2, J, J
  double normal = 0;                            ///< J, mean factor of the pairs
};

struct FaceSum {
  double sum = 0, slope = 0;  ///< 1, 1/m
};

/// Sum of the kernel and its slope, `height` spacings above a flat surface of a cubic lattice.
FaceSum overFace(const ContactKernel& k, double spacing, double height) {
  FaceSum f;
  constexpr int reach = 2;
  for (int z = 0; z <= reach; z++)
    for (int y = -reach; y <= reach; y++)
      for (int x = -reach; x <= reach; x++) {
        const double up = z + height, r = spacing * std::sqrt(x * x + y * y + up * up);
        f.sum += k.weight(r);
        f.slope += k.steepness(r) * spacing * up / r;
      }
  return f;
}

/// Product of the shares (1) of a pair.
double shareOf(const ContactKernel& kernel, const Continuum& p, const ClosePair& pair) {
  return kernel.share(p.contactDepth[pair.own]) * kernel.share(p.contactDepth[pair.other]);
}

std::span<const ClosePair> pairsOf(const BodyContactWork& work, const BodyTouch& touch) {
  return {work.pairs.data() + touch.first, work.pairs.data() + touch.last};
}

/// Velocities that a sum uses. After the evaluation, the velocities of ghosts differ from those of their
/// owners.
enum class Velocities { Now, OfEvaluation };

/// Sums over the pairs for which wanted(pair) is true.
template<class Wanted>
BodySums sumsOf(const BodyContactView& v, std::span<const ClosePair> pairs, const Wanted& wanted,
                Velocities velocities = Velocities::Now) {
  const ContactKernel& kernel = v.work.kernel;
  const Continuum& p = v.particles;
  BodySums s;
  for (const ClosePair& pair : pairs) {
    if (!wanted(pair)) continue;
    const Vec3d d = exactDifference(v.grid, p.position[pair.own], p.position[pair.other]);
    const double r = length(d), share = shareOf(kernel, p, pair);
    const double w = share * kernel.weight(r), g = share * kernel.steepness(r);
    const ContactPair c = contactPair(v.scene, p, pair.own, pair.other, v.step);
    s.phi += w;
    s.stiffness += w * c.stiffness;
    s.dashpot += w * c.dashpot;
    s.frictionRate += w * c.frictionRate;
    s.friction += w * c.friction;
    if (!(r > 0)) continue;  // coincident particles have no direction; separateCoincident moves them
    const Vec3d u = p.velocity[pair.own] - p.velocity[pair.other];
    double& closing = v.work.closing[static_cast<std::size_t>(&pair - v.work.pairs.data())];
    if (velocities == Velocities::Now) closing = -dot(u, d) / r;
    s.rate += g * closing;
    s.stiffnessRate += g * closing * c.stiffness;
    s.steepness += g;
    s.away += d * (g / r);
    s.motion += u * g;
  }
  return s;
}

/// Returns the contact. rest: sum (1) above which there is a force.
Press pressOf(const ContactKernel& kernel, const BodySums& s, double rest) {
  Press press;
  const double excess = s.phi - rest;
  if (!(excess > 0)) return press;
  const double slope = kernel.slopeAt(rest), scale = 0.5 / (slope * slope), part = excess / s.phi;
  press.energy = 0.5 * scale * s.stiffness * part * excess;
  press.byStiffness = 0.5 * scale * part * excess;
  press.alone = 0.5 * scale * s.stiffness / s.phi * part * (2 * s.phi - excess);
  press.rate = press.byStiffness * s.stiffnessRate + press.alone * s.rate;
  const double spring = press.byStiffness * s.stiffness / s.phi + press.alone;
  press.dash = std::max(scale * s.dashpot / s.phi * s.rate, -spring);  // a contact never pulls
  press.normal = spring + press.dash;
  return press;
}

/// Friction of a particle, its stored energy and the power it dissipates.
struct Friction {
  SpringFriction force;
  double energy = 0, lost = 0;  ///< J, W
};

/// Stiffness (N/m) of a particle's friction spring. It is half of the pair's stiffness, since each
/// particle of a pair has a spring.
double shearStiffness(const BodySums& s) { return s.steepness > 0 ? 0.5 * s.stiffness / s.phi : 0; }

/// Friction of a particle whose spring had the displacement `old` (m) before the step.
Friction frictionOf(const BodySums& s, const Press& press, const Vec3d& old, double dt) {
  Friction f;
  if (!(s.steepness > 0)) return f;
  const double away = length(s.away), bound = s.friction / s.phi * press.normal * away;
  const double k = shearStiffness(s);
  const Vec3d u = s.motion / s.steepness;
  if (press.energy > 0 && bound > 0)
    f.force = springFriction({k, 0.25 * s.frictionRate / s.phi, bound}, s.away / away, old + u * dt, u);
  const Vec3d& shear = f.force.shear;
  f.energy = 0.5 * k * dot(shear, shear);
  f.lost = -dot(f.force.dashpot, u);
  if (dt > 0) {
    const double work = 0.5 * k * dot(old + shear, u);  // work rate (W) against the spring, over both half
                                                        // kicks
    f.lost += work - (f.energy - 0.5 * k * dot(old, old)) / dt;
  }
  return f;
}

/// Returns Continuum::bodyContact: the factors of Press, and the friction of a pair divided by its g.
Mat3f contactData(const BodySums& s, const Press& press, const Friction& friction) {
  Mat3f data{};
  data.row[0] = single(Vec3d{press.byStiffness, press.alone, press.dash});
  if (!(s.steepness > 0)) return data;
  data.row[1] = single(friction.force.spring / s.steepness);
  data.row[2] = single(friction.force.dashpot / s.steepness);
  return data;
}

/// Lists the pairs of an owned row with solids of other bodies within a distance `reach` (m).
void listPairs(const BodyContactView& v, double reach, std::uint32_t i, std::span<const RowSpan> around) {
  const Continuum& p = v.particles;
  const auto first = static_cast<std::uint32_t>(v.work.pairs.size());
  for (const RowSpan& rows : around)
    for (std::uint32_t j = rows.begin; j < rows.end; j++) {
      if (p.body[j] == p.body[i] || !canTouch(p, i, j)) continue;
      const Vec3d d = exactDifference(v.grid, p.position[i], p.position[j]);
      if (!(dot(d, d) < reach * reach)) continue;
      if (v.welding && hasBondTo(v.solids, v.bonds, p, i, j)) continue;
      v.work.pairs.push_back({i, j});
    }
  const auto last = static_cast<std::uint32_t>(v.work.pairs.size());
  if (last == first) return;
  BodyTouch touch{i, first, last};
  if (p.liquid.active) touch.liquid = p.liquid[i];
  v.work.rows.push_back(touch);
}

void listRows(const BodyContactView& v, double reach) {
  v.work.pairs.clear();
  v.work.rows.clear();
  const Continuum& p = v.particles;
  rangesOfCells(v.cells, p, p.body, v.work.mixed.ranges);
  anyMixedCell(v.cells, p.owned, v.work.mixed, [&](std::size_t c, std::span<const RowSpan> around) {
    for (std::uint32_t i = v.cells.first[c]; i < v.cells.first[c] + v.cells.count[c]; i++)
      if (p.phase[i] == Solid) listPairs(v, reach, i, around);
    return false;
  });
}

double restOf(const ContactKernel& kernel, const Continuum& p, std::uint32_t i) {
  return std::max(kernel.touch, static_cast<double>(p.contactRest[i]));
}

/// Sets the sum `rest` at which contact begins. New particles that are closer than one spacing, up to half a
/// spacing, begin there. If particles of another body just froze, the excess of the sum stays the same as
/// without those particles (`before`).
void setRest(const ContactKernel& kernel, float& rest, bool fresh, double phi, double before) {
  const double old = fresh ? kernel.touch : std::max(kernel.touch, static_cast<double>(rest));
  const double excess = fresh ? 0 : std::max(0.0, before - old);
  double now = old;
  if (phi < kernel.touch) now = kernel.touch;  // the bodies have separated
  else if (fresh || before < phi) now = std::max(old, std::min(phi - excess, std::max(kernel.overlap, old)));
  rest = static_cast<float>(now);
}

/// Returns true if a particle of the pair just froze.
bool justFroze(const Continuum& p, const ClosePair& pair) {
  return p.justFrozen[pair.own] || p.justFrozen[pair.other];
}

void findTouch(const BodyContactView& v, const ContactKernel& kernel, BodyTouch& touch, ExactSum* frozen) {
  Continuum& p = v.particles;
  const std::uint32_t i = touch.row;
  const auto pairs = pairsOf(v.work, touch);
  const BodySums sums = sumsOf(v, pairs, [](const ClosePair&) { return true; });
  BodySums before = sums;
  if (frozen) before = sumsOf(v, pairs, [&](const ClosePair& pair) { return !justFroze(p, pair); });
  const Press without = frozen ? pressOf(kernel, before, restOf(kernel, p, i)) : Press{};
  const bool fresh = p.contactRest[i] == 0 || (frozen && p.justFrozen[i]);
  setRest(kernel, p.contactRest[i], fresh, sums.phi, before.phi);
  const Press press = pressOf(kernel, sums, restOf(kernel, p, i));
  // Includes half the work of the step, since the force did not exist before the step's last kick.
  if (frozen) frozen->add(without.energy - press.energy + 0.5 * v.step * (press.rate - without.rate));
  const Friction friction = frictionOf(sums, press, p.contactShear[i], v.dt);
  // In a restored state, the velocities are not those of the evaluation that set the displacement.
  if (v.dt > 0) p.contactShear[i] = friction.force.shear;
  touch.energy = press.energy, touch.rate = press.rate;
  touch.soon = sums.phi + 2 * v.step * std::max(sums.rate, 0.0) >= restOf(kernel, p, i);
  touch.sheared = friction.energy, touch.lost = friction.lost;
  touch.shearStiffness = shearStiffness(sums);
  if (sums.steepness > 0) touch.motion = sums.motion / sums.steepness;
  p.bodyContact[i] = contactData(sums, press, friction);
}

bool hasContactForce(const Mat3f& data) { return data.row[0].y > 0; }

/// Sum (1) of the same factor of both particles, in double precision.
double sumOf(float a, float b) { return static_cast<double>(a) + static_cast<double>(b); }

}  // namespace

double ContactKernel::weight(double r) const {
  const double steepest = radius * steepestAt,
               q = 1 - std::max(r, steepest) * std::max(r, steepest) / (radius * radius);
  return q > 0 ? q * q * q * (q * q * q) + std::max(0.0, steepest - r) * steepness(r) : 0;
}

double ContactKernel::steepness(double r) const {
  const double s = std::max(r, radius * steepestAt), q = 1 - s * s / (radius * radius);
  return q > 0 ? 12 * s / (radius * radius) * (q * q) * (q * q * q) : 0;
}

double ContactKernel::slopeAt(double rest) const {
  return slope + (overlapSlope - slope) * std::clamp((rest - touch) / (overlap - touch), 0.0, 1.0);
}

double ContactKernel::share(float depth) const {
  if (!(depth > 0 && depth < 0.5F)) return 1;  // 0: the depth is unknown
  const double x = 2 * depths * static_cast<double>(depth);
  const auto k = static_cast<std::size_t>(x);
  return shares[k] + (shares[k + 1] - shares[k]) * (x - static_cast<double>(k));
}

ContactKernel contactKernel(double spacing, double support) {
  ContactKernel k{std::min(2 * spacing, support)};
  k.touch = overFace(k, spacing, 1).sum;
  k.slope = overFace(k, spacing, 1).slope;
  k.overlap = overFace(k, spacing, 0.5).sum;
  k.overlapSlope = overFace(k, spacing, 0.5).slope;
  for (std::size_t n = 0; n < k.shares.size(); n++)
    k.shares[n] = k.touch /
                  overFace(k, spacing, 0.5 + 0.5 * static_cast<double>(n) / ContactKernel::depths).sum;
  return k;
}

void prepareBodyContact(const Scene& scene, const CellGrid& grid, BodyContactWork& work) {
  work.kernel = contactKernel(scene.spacing, grid.support);
}

void findBodyTouches(const BodyContactView& v, ExactSum* frozen) {
  Continuum& p = v.particles;
  const ContactKernel& kernel = v.work.kernel;
  listRows(v, kernel.radius);
  std::fill_n(p.bodyContact.data(), p.owned, Mat3f{});
  v.work.closing.assign(v.work.pairs.size(), 0);
  for (BodyTouch& touch : v.work.rows) findTouch(v, kernel, touch, frozen);
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.contactRest[i] == 0) p.contactRest[i] = static_cast<float>(kernel.touch);
}

bool touchesSoon(const BodyContactWork& work) {
  return std::any_of(work.rows.begin(), work.rows.end(), [](const BodyTouch& touch) { return touch.soon; });
}

void addBodyContacts(const BodyContactView& v, std::span<const std::uint8_t> skipped) {
  Continuum& p = v.particles;
  const ContactKernel& kernel = v.work.kernel;
  v.work.resistance.clear();
  for (BodyTouch& touch : v.work.rows) {
    const std::uint32_t i = touch.row;
    touch.inContact = hasContactForce(p.bodyContact[i]);
    Vec3d force{}, resistance{};
    double lost = touch.lost;
    for (const ClosePair& pair : pairsOf(v.work, touch)) {
      const std::uint32_t j = pair.other;
      const Mat3f &own = p.bodyContact[i], &other = p.bodyContact[j];
      if (!hasContactForce(own) && !hasContactForce(other)) continue;
      touch.inContact = true;
      const Vec3d d = exactDifference(v.grid, p.position[i], p.position[j]);
      const double r = length(d);
      if (!(r > 0)) continue;
      const double g = shareOf(kernel, p, pair) * kernel.steepness(r), k = contactStiffness(v.scene, p, i, j);
      const Vec3d n = d / r, u = p.velocity[i] - p.velocity[j];
      const Vec3d dissipative = (n * sumOf(own.row[0].z, other.row[0].z) +
                                 (wide(own.row[2]) - wide(other.row[2]))) *
                                g;
      force += (n * (k * sumOf(own.row[0].x, other.row[0].x) + sumOf(own.row[0].y, other.row[0].y)) +
                (wide(own.row[1]) - wide(other.row[1]))) *
               g;
      resistance += dissipative;
      lost -= 0.5 * dot(n, u) * g * sumOf(own.row[0].z, other.row[0].z);
    }
    if ((!touch.inContact && lost == 0) || (!skipped.empty() && skipped[i])) continue;
    p.interaction[i] += touch.energy + touch.sheared;
    p.force[i] += force + resistance;
    p.dissipation[i] += lost;
    v.work.resistance.push_back({i, resistance});
  }
}

bool changesStiffness(const BodyContactWork& work, const Continuum& p) {
  return std::any_of(work.rows.begin(), work.rows.end(), [&](const BodyTouch& touch) {
    return touch.inContact &&
           (p.phase[touch.row] != Solid || (p.liquid.active && p.liquid[touch.row] != touch.liquid));
  });
}

void recordStiffnessChanges(const BodyContactView& v, double next, ExactSum& phaseJump) {
  Continuum& p = v.particles;
  const ContactKernel& kernel = v.work.kernel;
  for (const BodyTouch& touch : v.work.rows) {
    if (!(touch.energy > 0)) continue;
    const BodySums s = sumsOf(
        v, pairsOf(v.work, touch), [&](const ClosePair& pair) { return canTouch(p, pair.own, pair.other); },
        Velocities::OfEvaluation);
    const Press now = pressOf(kernel, s, restOf(kernel, p, touch.row));
    const Vec3d shear = p.contactShear[touch.row];
    const double stiffer = shearStiffness(s) - touch.shearStiffness;
    const double change = now.energy - touch.energy + 0.5 * stiffer * dot(shear, shear);
    p.interaction[touch.row] += change;
    phaseJump.add(-change - 0.5 * next * (now.rate - touch.rate + stiffer * dot(shear, touch.motion)));
    if (p.phase[touch.row] != Solid) p.contactShear[touch.row] = {};
  }
}

}  // namespace thaw
