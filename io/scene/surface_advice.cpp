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
  const auto tell = [&](bool is, const char* key, const std::string& text) {
    if (!is) return;
    const auto at = s.places.find(key);
    lines.push_back(
        warningLine(at != s.places.end() ? at->second : s.where, "surface." + std::string(key) + " " + text));
  };
  const double spacing = surfelSpacing(scene),
               particles = 2.0 / 3 * std::numbers::pi *
                           std::pow(s.particleSupport * scene.numerics.support, 3),
               surfels = 1.15 * std::numbers::pi * s.support * s.support;
  tell(
      spacing > scene.spacing, "spacing",
      fmt::format("({:g} m) is above spacing ({:g} m): the surface is coarser than the particles, and misses "
                  "drops of a few of them; half of spacing is sensible, or less where a mesh has detail",
                  spacing, scene.spacing));
  tell(spacing < 0.05 * scene.spacing, "spacing",
       fmt::format("({:g} m) is {:.2g} of spacing ({:g} m): {:.0f} surfels and more for each particle at the "
                   "surface; .15 to .5 of spacing is sensible",
                   spacing, spacing / scene.spacing, scene.spacing, std::pow(scene.spacing / spacing, 2)));
  tell(s.support < 2, "support",
       fmt::format("is {:g}: about {:.0f} surfels act on each surfel, too few to tell a smooth surface; 2.5 "
                   "to 4 is sensible",
                   s.support, surfels));
  tell(s.support > 5, "support",
       fmt::format("is {:g}: about {:.0f} surfels act on each surfel, and time and memory grow with it; 2.5 "
                   "to 4 is sensible",
                   s.support, surfels));
  tell(s.particleSupport > 2.5, "particle_support",
       fmt::format("is {:g}: about {:.0f} particles act on each surfel, details of the liquid are lost, and "
                   "time and memory grow with it; 1.5 to 2 is sensible",
                   s.particleSupport, particles));
  tell(s.everyMove > 1, "every_move",
       fmt::format("is {:g}: particles come further than their neighbourhood between two updates, and the "
                   "surface is carried less well; .1 to 1 is sensible",
                   s.everyMove));
  tell(s.implicit == 0, "implicit",
       "is 0: nothing draws the surface to the level of the particles' colour field; .3 to 1 is sensible");
  tell(s.attract > 0.3, "attract",
       fmt::format("is {:g}: the surface is drawn into its particles; 0 to .1 is sensible", s.attract));
  tell(s.smooth == 0, "smooth", "is 0: the surface shows each particle as a bump; .2 to .6 is sensible");
  tell(s.repel == 0, "repel",
       "is 0: surfels are not spaced, and leave gaps that births have to fill; .2 to .5 is sensible");
  tell(s.isoLevel < 0.4 || s.isoLevel > 0.6, "iso_level",
       fmt::format("is {:g}: the surface does not lie where its particles end; a ball of ten spacings began "
                   "with 36 % too much volume at .3 and 28 % too little at .7, more than volume keeping may "
                   "move; .45 to .55 is sensible",
                   s.isoLevel));
  tell(s.damping < 0.2, "damping",
       fmt::format("is {:g}: surfels hardly move in an update, and the surface is not settled when it ends; "
                   ".5 to 1 is sensible",
                   s.damping));
  tell(s.damping > 1.3, "damping", fmt::format("is {:g}: surfels overshoot; .5 to 1 is sensible", s.damping));
  tell(s.iterations < 10, "iterations",
       fmt::format("is {}: most updates end before the surface is settled; 15 to 60 is sensible",
                   s.iterations));
  tell(s.stop > 0.1, "stop",
       fmt::format("is {:g}: surfels stop before they are settled; .003 to .03 is sensible", s.stop));
  tell(s.stop < 1e-4, "stop",
       fmt::format("is {:g}: hardly an update settles before surface.iterations; .003 to .03 is sensible",
                   s.stop));
  tell(s.adapt > 0 && s.adapt < 0.1, "adapt",
       fmt::format("is {:g}: {:.0f} surfels and more for one where the surface is curved; .3 to .7 is "
                   "sensible, 0 for the same spacing everywhere",
                   s.adapt, 1 / (s.adapt * s.adapt)));
  tell(s.keepVolume > 0 && s.keepVolume < 0.5, "keep_volume",
       fmt::format(
           "is {:g}: volume is held in part only (a drop was 3 % off at .1); 1 is sensible, or 0 for none",
           s.keepVolume));
  tell(s.linkLength < 1.3, "link_length",
       fmt::format(
           "is {:g}: bodies that are strained a little come apart into components; 1.4 to 2 is sensible",
           s.linkLength));
  tell(s.linkLength > 2.5, "link_length",
       fmt::format("is {:g}: pieces that far apart count as one component; 1.4 to 2 is sensible",
                   s.linkLength));
  return lines;
}

}  // namespace thaw
