// SPDX-License-Identifier: Apache-2.0
#include "io/scene/surface_advice.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/scene/scene_warnings.hpp"

namespace thaw {

std::vector<std::string> surfaceAdvice(const Scene& scene) {
  const SurfaceSettings& s = scene.surface;
  std::vector<std::string> lines;
  if (!s.on) return lines;
  const auto advise = [&](bool is, const char* key, const std::string& text) {
    if (!is) return;
    const auto at = s.places.find(key);
    lines.push_back(
        warningLine(at != s.places.end() ? at->second : s.where, "surface." + std::string(key) + " " + text));
  };
  const double spacing = surfelSpacing(scene),
               particles = 2.0 / 3 * std::numbers::pi *
                           std::pow(s.particleSupport * scene.numerics.support, 3),
               surfels = 1.15 * std::numbers::pi * s.support * s.support;
  advise(
      spacing > scene.spacing, "spacing",
      fmt::format("({:g} m) is above spacing ({:g} m): the surface is coarser than the particles and misses "
                  "drops of a few particles; half of spacing is recommended, or less for detailed meshes",
                  spacing, scene.spacing));
  advise(
      spacing < 0.05 * scene.spacing, "spacing",
      fmt::format("({:g} m) is {:.2g} of spacing ({:g} m): {:.0f} surfels and more for each particle at the "
                  "surface; 0.15 to 0.5 of spacing is recommended",
                  spacing, spacing / scene.spacing, scene.spacing, std::pow(scene.spacing / spacing, 2)));
  advise(
      s.support < 2, "support",
      fmt::format("is {:g}: about {:.0f} surfels act on each surfel, too few for a smooth surface; 2.5 to 4 "
                  "is recommended",
                  s.support, surfels));
  advise(
      s.support > 5, "support",
      fmt::format("is {:g}: about {:.0f} surfels act on each surfel, and time and memory grow with it; 2.5 "
                  "to 4 is recommended",
                  s.support, surfels));
  advise(
      s.particleSupport > 2.5, "particle_support",
      fmt::format("is {:g}: about {:.0f} particles act on each surfel, details of the liquid are lost, and "
                  "time and memory grow with it; 1.5 to 2 is recommended",
                  s.particleSupport, particles));
  advise(
      s.everyMove > 1, "every_move",
      fmt::format("is {:g}: particles move beyond their neighbourhood between two updates, and the surface "
                  "follows them less accurately; 0.1 to 1 is recommended",
                  s.everyMove));
  advise(
      s.implicit == 0, "implicit",
      "is 0: nothing moves the surface to the level of the particles' colour field; 0.3 to 1 is recommended");
  advise(
      s.attract > 0.3, "attract",
      fmt::format("is {:g}: the surface is pulled into its particles; 0 to 0.1 is recommended", s.attract));
  advise(s.smooth == 0, "smooth",
         "is 0: the surface shows each particle as a bump; 0.2 to 0.6 is recommended");
  advise(
      s.repel == 0, "repel",
      "is 0: surfels are not spaced evenly and leave gaps that births must fill; 0.2 to 0.5 is recommended");
  advise(s.isoLevel < 0.4 || s.isoLevel > 0.6, "iso_level",
         fmt::format("is {:g}: the surface does not lie at the boundary of its particles; a ball of ten "
                     "spacings begins with 36 % too much volume at 0.3 and 28 % too little at 0.7, more than "
                     "volume control may correct; 0.45 to 0.55 is recommended",
                     s.isoLevel));
  advise(s.damping < 0.2, "damping",
         fmt::format("is {:g}: surfels hardly move in an update, and the surface has not converged when it "
                     "ends; 0.5 to 1 is recommended",
                     s.damping));
  advise(s.damping > 1.3, "damping",
         fmt::format("is {:g}: surfels overshoot; 0.5 to 1 is recommended", s.damping));
  advise(s.iterations < 10, "iterations",
         fmt::format("is {}: most updates end before the surface has converged; 15 to 60 is recommended",
                     s.iterations));
  advise(
      s.stop > 0.1, "stop",
      fmt::format("is {:g}: surfels stop before they have converged; 0.003 to 0.03 is recommended", s.stop));
  advise(s.stop < 1e-4, "stop",
         fmt::format(
             "is {:g}: hardly any update converges before `surface.iterations`; 0.003 to 0.03 is recommended",
             s.stop));
  advise(s.adapt > 0 && s.adapt < 0.1, "adapt",
         fmt::format("is {:g}: {:.0f} surfels and more for one where the surface is curved; 0.3 to 0.7 is "
                     "recommended, 0 for the same spacing everywhere",
                     s.adapt, 1 / (s.adapt * s.adapt)));
  advise(
      s.enforceVolume > 0 && s.enforceVolume < 0.5, "enforce_volume",
      fmt::format(
          "is {:g}: volume is only partly kept (a drop was 3 % off at 0.1); 1 is recommended, or 0 for none",
          s.enforceVolume));
  advise(s.linkLength < 1.3, "link_length",
         fmt::format("is {:g}: slightly strained bodies fall apart into components; 1.4 to 2 is recommended",
                     s.linkLength));
  advise(s.linkLength > 2.5, "link_length",
         fmt::format("is {:g}: pieces at such a distance count as one component; 1.4 to 2 is recommended",
                     s.linkLength));
  return lines;
}

}  // namespace thaw
