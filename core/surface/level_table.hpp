// Which value the colour field has on the surface of a body: on a plane 3/8, on a ball less, on a drop of a
// few particles much less.
#pragma once
#include <algorithm>
#include <array>

namespace thaw {

/// The colour field whose iso-surface the surfels settle on is smoothed twice, a = sum V c_j W with c_j = sum
/// V W the colour at the particles and W = (1 - (r/h_ps)^2)^3: at h_ps = 2 h the normals of a ball's surface
/// are then within 2 degrees, with c itself within 4 (benchmark surface). A fixed level would lie inside of a
/// curved surface, by .1 h^2/R on a ball, and not exist on drops smaller than the kernel
/// (docs/theory/surfaces.md). So the level follows how much body there is: b / a, with b = sum V a_j W. On
/// continuous balls of every size, and in cavities, the level as a function of b / a is tabulated here; on
/// any body it is then exact to first order in the mean curvature. It is a function of place alone: there is
/// no feedback through the surfels, as there would be through a curvature that they measure.
class LevelTable {
 public:
  void fill();
  bool filled() const { return level_[entries] > 0; }
  /// a on the surface, for b / a there. Linear between 512 entries.
  double level(double fullness) const { return at(level_, fullness); }
  /// Its derivative there.
  double slope(double fullness) const {
    const double s = std::clamp(fullness, 0.0, 1.0) * entries;
    const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(s), entries - 1);
    return entries * (level_[k + 1] - level_[k]);
  }
  /// Distance from the surface of the mean of the particles with the weights V c_j W, in h_ps.
  double depth(double fullness) const { return at(depth_, fullness); }

 private:
  static constexpr int entries = 512;
  std::array<double, entries + 1> level_{}, depth_{};
  static double at(const std::array<double, entries + 1>& table, double x);
};

/// The level does not know a thin body from one whose particles have gone apart: a fluid that is stretched
/// without a pressure that draws it together, as below a spout, or a splash. Its surface would keep the
/// extent of the particles, and hold up to twice their volume. So the level rises where few particles are
/// near: the sum of (1 - (r/nearSupport)^2)^3 over particles (lengths in spacings) is 2.6 on a plane of the
/// lattice half a spacing above it, 1.4 on a row of particles one spacing apart, .7 on a drop of one
/// particle: those stay. How much so is a matter of the component (Tightening): a cloud of liquid that has
/// gone apart in all directions, as a splash without surface tension does, is drawn in by volume keeping, and
/// least where it is dense. An offset by the same everywhere would draw its thin rims in until their sides
/// pass each other.
inline constexpr double nearSupport = 2;
struct Tightening {
  double full = 0.5, most = 0.6;
};  ///< below which sum the level rises, and by what share where there is nothing near
inline double tightened(double level, double near, const Tightening& t) {
  return level * (1 + t.most * std::max(0.0, 1 - near / t.full));
}

/// What volume keeping asks of a component (SurfaceComponent::raised over the spacing of the particles,
/// negative: less than the level holds): offsets up to leastOffset inward, what is more than that is
/// tightening. On lattices stretched in two or three directions it takes about as much volume as the offset
/// would.
inline constexpr double leastOffset = -0.35;
inline Tightening tighteningOf(double raised) {
  const double more = std::max(leastOffset - raised, 0.0);
  return {0.5 + 3 * more, 0.6 + more};
}
inline double offsetOf(double raised) { return std::max(raised, leastOffset); }

}  // namespace thaw
