// Which value the colour field has on the surface of a body: on a plane one half, on a ball less, on a drop of a few particles much less.
#pragma once
#include <array>

namespace thaw {

/// The iso-surface of a colour field at one half lies inside of a curved surface, by .1 h^2/R on a ball, and does not exist on drops smaller than
/// the kernel (accuracy.md C). So the level follows how much body there is: the mean, over the particles around and by the kernel, of
/// the colour at the particles. On continuous balls of every size, and in cavities, the level as a function of that mean is
/// tabulated here; on any body it is then exact to first order in the mean curvature. A function of place alone: no feedback through surfels.
class LevelTable {
 public:
  LevelTable();
  /// Both lengths in h_ps, colours 1 deep inside. Linear between 512 entries.
  double level(double meanColour) const { return at(level_, meanColour); }
  /// Distance of the kernel's mean particle from the surface.
  double depth(double meanColour) const { return at(depth_, meanColour); }

 private:
  static constexpr int entries = 512;
  std::array<double, entries + 1> level_{}, depth_{};
  static double at(const std::array<double, entries + 1>& table, double x);
};

/// (1 - q^2)^3 with its integral over the unit ball made 1.
double colourKernel(double q2);

}  // namespace thaw
