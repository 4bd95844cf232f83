// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/builtin/bust.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/builtin/blended_shapes.hpp"
#include "core/geometry/marching/polygonise.hpp"

namespace thaw {
namespace {

// Parts of the sculpture. Lengths are in m, for a height of about 1 m. Values approximate distances, negative
// inside.

double ball(const Vec3d& x, const Vec3d& centre, double radius) { return length(x - centre) - radius; }

/// Returns 1 at 0, and falls smoothly to 0 at -1 and 1.
double bump(double u) { return u > -1 && u < 1 ? (1 - u * u) * (1 - u * u) : 0; }

/// Blunt cone between the middles of its flat ends, rounded at the rims, with a ribbon and a band on the
/// forehead.
double crown(const Vec3d& x) {
  const Vec3d low{0, 0.000, 0.655}, high{0, 0.105, 0.965};
  const Vec3d e = high - low;
  const double l = length(e), t = dot(x - low, e) / l, share = t / l;
  const Vec3d across = x - low - e * (t / l);
  // Longer from front to back, like the head.
  const double r = length({across.x, across.y * 0.90, across.z * 0.90});
  const double rounding = 0.022;
  const double radius = 0.112 + 0.052 * share * (0.6 + 0.4 * share) + 0.011 * bump((share - 0.50) / 0.11) +
                        0.014 * bump((share - 0.06) / 0.075);
  const double dr = r - (radius - rounding), dt = std::max(-t, t - l) + rounding;
  const double u = std::max(dr, 0.0), v = std::max(dt, 0.0);
  return (std::sqrt(u * u + v * v) + std::min(std::max(dr, dt), 0.0) - rounding) * 0.95;
}

/// Shoulders, chest, collar, foot. All parts are symmetric and take x.x >= 0.
double torso(const Vec3d& x) {
  double d = ellipsoid(x, {0, 0.025, 0.125}, {0.18, 0.115, 0.145});                     // chest
  d = blend(d, limb(x, {0, 0.035, 0.205}, {0.190, 0.045, 0.168}, 0.078, 0.064), 0.06);  // shoulders
  d = carve(d, x.x * -0.97 + (0.1 - x.z) * 0.24 + 0.238, 0.02);                         // end at the arms
  d = blend(d, limb(x, {0, 0.045, 0.22}, {0, 0.015, 0.42}, 0.082, 0.070), 0.07);        // neck
  const Vec3d c = x - Vec3d{0, 0.040, 0.315};  // collar: ridges at distances from the throat
  const double away = std::sqrt(c.x * c.x * 0.85 + c.y * c.y * 1.1 + c.z * c.z);
  d -= 0.012 * std::clamp((0.30 - x.z) / 0.05, 0.0, 1.0) *
       (bump((away - 0.105) / 0.020) + bump((away - 0.146) / 0.020) + bump((away - 0.188) / 0.021));
  const Vec3d p = x - Vec3d{0, 0.03, 0};
  const double foot = std::max(std::sqrt(p.x * p.x * 0.5 + p.y * p.y) - 0.112, p.z - 0.045);
  d = blend(d, foot, 0.012);
  return std::max(d, -x.z);
}

double face(const Vec3d& x) {
  double d = ellipsoid(x, {0, 0.005, 0.605}, {0.108, 0.135, 0.125});                            // skull
  d = blend(d, ellipsoid(x, {0, -0.050, 0.545}, {0.090, 0.085, 0.130}), 0.03);                  // face
  d = blend(d, limb(x, {0.070, -0.010, 0.495}, {0.0, -0.100, 0.445}, 0.030, 0.034), 0.04);      // jaw
  d = blend(d, ball(x, {0, -0.124, 0.432}, 0.022), 0.03);                                       // chin
  d = blend(d, ball(x, {0.058, -0.085, 0.537}, 0.038), 0.03);                                   // cheekbones
  d = carve(d, ellipsoid(x, {0.044, -0.148, 0.582}, {0.036, 0.034, 0.024}), 0.016);             // eye sockets
  d = blend(d, ellipsoid(x, {0.044, -0.098, 0.580}, {0.027, 0.024, 0.0135}), 0.004);            // eyes
  d = blend(d, limb(x, {0.016, -0.134, 0.611}, {0.055, -0.122, 0.624}, 0.0125, 0.012), 0.012);  // brows
  d = blend(d, limb(x, {0.055, -0.122, 0.624}, {0.092, -0.080, 0.606}, 0.012, 0.008), 0.012);
  d = blend(d, limb(x, {0, -0.132, 0.612}, {0, -0.170, 0.532}, 0.012, 0.018), 0.018);  // nose
  d = blend(d, ball(x, {0.019, -0.155, 0.525}, 0.014), 0.012);
  d = blend(d, limb(x, {0, -0.147, 0.4905}, {0.033, -0.127, 0.484}, 0.0135, 0.007), 0.006);  // lips
  d = blend(d, limb(x, {0, -0.143, 0.464}, {0.027, -0.126, 0.469}, 0.0140, 0.008), 0.006);
  d = carve(d, limb(x, {0, -0.164, 0.4775}, {0.036, -0.138, 0.4765}, 0.0055, 0.005), 0.006);
  d = carve(d, limb(x, {0, -0.146, 0.446}, {0.02, -0.136, 0.447}, 0.007, 0.005), 0.012);  // above the chin
  double ear = ellipsoid(x, {0.112, 0.012, 0.560}, {0.016, 0.032, 0.050});
  ear = blend(ear, ball(x, {0.106, 0.000, 0.516}, 0.015), 0.012);
  ear = carve(ear, ellipsoid(x, {0.131, 0.004, 0.566}, {0.014, 0.017, 0.028}), 0.006);
  return blend(d, ear, 0.010);
}

double head(const Vec3d& x) {
  double d = blend(face(x), crown(x), 0.006);
  // The snake on the crown.
  d = blend(d, limb(x, {0, -0.124, 0.672}, {0, -0.094, 0.765}, 0.013, 0.016), 0.006);
  return blend(d, ball(x, {0, -0.104, 0.782}, 0.023), 0.008);
}

/// A round plinth with two steps below the centre of mass, wide enough for stability.
double plinth(const Vec3d& x) {
  const auto disc = [&](double radius, double low, double high) {
    constexpr double rounding = 0.012;
    const Vec3d p = x - Vec3d{0, 0.042, 0};
    const double dr = std::sqrt(p.x * p.x + p.y * p.y) - (radius - rounding),
                 dz = std::max(low - x.z, x.z - high) + rounding;
    const double u = std::max(dr, 0.0), v = std::max(dz, 0.0);
    return std::sqrt(u * u + v * v) + std::min(std::max(dr, dz), 0.0) - rounding;
  };
  return blend(disc(0.190, -0.075, 0.010), disc(0.232, -0.140, -0.060), 0.010);
}

double queen(Vec3d x) {
  x.x = std::abs(x.x);
  constexpr double larger = 1.2;  // scale of the head over the shoulders, for particles to resolve the head
  const double h = larger * head({x.x / larger, x.y / larger, 0.43 + (x.z - 0.365) / larger});
  return blend(blend(torso(x), h, 0.030), plinth(x), 0.012);
}

}  // namespace

namespace {

/// x of the mesh = (x of the sculpture - (0, middle, low)) * scale.
struct Frame {
  double middle = 0, low = 0, scale = 1;
};

/// The mesh is cached, because it takes a sixth of a second and is used several times.
const TriangleMesh& unplacedMesh() {
  static const TriangleMesh mesh = polygonise(queen, {{-0.2605, -0.2605, -0.1605}, {0.2605, 0.3305, 1.0905}},
                                              0.0131);
  return mesh;
}

Frame frameOf(const TriangleMesh& mesh) {
  Vec3d low{never, never, never}, high{-never, -never, -never};
  for (const Vec3d& v : mesh.vertices)
    for (int a = 0; a < 3; a++) low[a] = std::min(low[a], v[a]), high[a] = std::max(high[a], v[a]);
  return {0.5 * (low.y + high.y), low.z, 1 / (high.z - low.z)};
}

}  // namespace

TriangleMesh bustMesh() {
  TriangleMesh mesh = unplacedMesh();
  const Frame f = frameOf(mesh);
  for (Vec3d& v : mesh.vertices) v = Vec3d{v.x, v.y - f.middle, v.z - f.low} * f.scale;
  return mesh;
}

double bustValue(const Vec3d& x) {
  static const Frame f = frameOf(unplacedMesh());
  const double back = 1 / f.scale;
  return queen({x.x * back, x.y * back + f.middle, x.z * back + f.low}) * f.scale;
}

}  // namespace thaw
