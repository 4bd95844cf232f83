// SPDX-License-Identifier: Apache-2.0
#include "core/surface/advection/reference_motion.hpp"

#include "core/solid/bonds/weight.hpp"
#include "core/solid/elasticity/moment.hpp"

namespace thaw {
namespace {

constexpr float flowingFraction = 0.02f;
/// Distance from a plane, relative to the square of the reference positions' distances. If all positions lie
/// this close, the displacement along the normal follows from the plane's rotation.
constexpr double flat = 0.03;

/// Particle relative to the surfel: reference and current position (m).
struct Partner {
  Vec3d then, now;
  double weight;
};

enum class Found { Map, TooFew, Exposed };

/// x = now + gradient (X - then), from weighted means and least squares.
struct AffineMap {
  Vec3d then{}, now{};
  Mat3d gradient{};
};

/// Input of the search for partners.
struct PartnerSearch {
  const Scene& scene;
  const Surface& surface;
  const Bins& bins;  ///< bins of the particles
  Periods periods;
};

Found findPartners(const PartnerSearch& w, std::size_t i, std::vector<Partner>& partners) {
  const Surfels& s = w.surface.surfels;
  const SurfaceParticles& p = w.surface.particles;
  const double reach = referenceReach * w.scene.spacing, reach2 = reach * reach;
  partners.clear();
  bool exposed = false;
  forRowsWithin(w.bins, s.position[i], w.surface.particleSupport, [&](std::uint32_t j, double) {
    // The second test finds particles that appeared after the start.
    if (p.component[j] != s.component[i] || (!p.covered[j] && p.referencePosition[j] == Vec3d{})) return;
    const Vec3d then = minimumImage(p.referencePosition[j] - s.referencePosition[i], w.periods);
    const double share = 1 - dot(then, then) / reach2;
    if (!(share > 0)) return;
    exposed = exposed || !p.covered[j];
    partners.push_back({then, p.position[j] + p.displacement[j] - s.position[i], share * share * share});
  });
  return exposed ? Found::Exposed : partners.size() < 3 ? Found::TooFew : Found::Map;
}

bool fit(const std::vector<Partner>& partners, AffineMap& map) {
  map = {};
  double sum = 0;
  for (const Partner& q : partners)
    sum += q.weight, map.then += q.weight * q.then, map.now += q.weight * q.now;
  if (!(sum > 0)) return false;
  map.then = map.then / sum;
  map.now = map.now / sum;
  Sym3d moment;
  Mat3d moved{};
  for (const Partner& q : partners) {
    const Vec3d d = q.then - map.then;
    moment = moment + q.weight * symmetric(outer(d, d));
    moved = moved + outer(q.weight * (q.now - map.now - d), d);
  }
  const MomentInverse inverse = invertMoment(moment, flat);
  if (inverse.rank < 2) return false;
  map.gradient = identity3<double>() +
                 completeGradient(moved * full(inverse.inverse), inverse.inverse, inverse.rank);
  return true;
}

/// Rotates the frame. Returns false, without a change, if the tangents become collinear.
bool turnFrame(const Mat3d& gradient, const Vec3d& referenceNormal, const Vec3d& referenceTangent,
               Vec3d& normal, Vec3d& tangent) {
  const Vec3d a = gradient * referenceTangent, b = gradient * cross(referenceNormal, referenceTangent),
              n = cross(a, b);
  const double size = length(n);
  if (!(size > 1e-6 * length(a) * length(b))) return false;
  normal = n / size;
  tangent = normalized(a - dot(a, normal) * normal);
  return true;
}

}  // namespace

void recordReference(Continuum& particles, Surface& surface) {
  Surfels& s = surface.surfels;
  if (!s.hasReference.active) return;
  for (std::size_t i = 0; i < particles.owned; i++) particles.surfaceStartPosition[i] = particles.position[i];
  for (std::size_t i = 0; i < s.owned; i++) {
    s.hasReference[i] = !(s.liquid.active && s.liquid[i] >= flowingFraction);
    s.referencePosition[i] = s.position[i];
    s.referenceNormal[i] = s.normal[i];
    s.referenceTangent[i] = s.tangent[i];
  }
}

void moveByReference(const Scene& scene, Surface& surface, const Bins& bins) {
  Surfels& s = surface.surfels;
  if (!s.hasReference.active) return;
  const PartnerSearch around{scene, surface, bins, periodsOf(surface.grid)};
  std::vector<Partner> partners;
  AffineMap map;
  for (std::size_t i = 0; i < s.owned; i++) {
    if (!s.hasReference[i]) continue;
    const Found found = s.liquid.active && s.liquid[i] >= flowingFraction ? Found::Exposed
                                                                          : findPartners(around, i, partners);
    if (found == Found::Exposed) {
      s.hasReference[i] = 0;
      s.referencePosition[i] = s.referenceNormal[i] = s.referenceTangent[i] = {};
      continue;
    }
    if (found == Found::TooFew || !fit(partners, map)) continue;
    s.carried[i] = map.now - map.gradient * map.then;
    turnFrame(map.gradient, s.referenceNormal[i], s.referenceTangent[i], s.normal[i], s.tangent[i]);
  }
}

}  // namespace thaw
