// SPDX-License-Identifier: Apache-2.0
#include "core/surface/field/iso_surface.hpp"

#include <algorithm>
#include <array>

namespace thaw {

std::optional<IsoStep> isoStep(const FieldSample& c, double particleSupport, double isoOffset,
                               double longest) {
  const double slope = length(c.gradient);
  if (!(slope * particleSupport > 0.05 * c.level && c.value > 0)) return {};
  return IsoStep{c.gradient * (-1 / slope),
                 std::clamp(c.tight * (isoOffset - (c.level - c.value) / slope), -longest, longest)};
}

void projectToIsoSurface(FieldProbe& probe, const IsoTarget& target, std::span<const Vec3d> from,
                         std::optional<SurfacePoint>* found) {
  const double farthest = target.farthest;
  std::size_t n = from.size();
  const double longest = 0.5 * probe.scene().spacing, enough = 0.01 * probe.surface().spacing;
  std::array<Vec3d, FieldProbe::most> x;
  std::array<std::size_t, FieldProbe::most> of;  // index of the starting position of x[k]
  std::array<FieldSample, FieldProbe::most> field;
  PlaceBox box{from[0], from[0]};
  for (std::size_t k = 0; k < n; k++) x[k] = from[k], of[k] = k, found[k] = {}, box.add(from[k]);
  const Vec3d room{farthest, farthest, farthest};
  probe.around({box.low - room, box.high + room}, target.component, target.ownPosition);
  for (int round = 0; round < 12 && n > 0; round++) {
    probe.at(x.data(), n, field.data());
    std::size_t left = 0;
    for (std::size_t k = 0; k < n; k++) {
      const std::optional<IsoStep> step = isoStep(field[k], probe.surface().particleSupport, 0, longest);
      if (!step) continue;
      const Vec3d to = x[k] + step->outward * step->out, gone = to - from[of[k]];
      if (dot(gone, gone) > farthest * farthest) continue;
      if (std::abs(step->out) <= enough) {
        found[of[k]] = {to, step->outward};
        continue;
      }
      x[left] = to;
      of[left++] = of[k];
    }
    n = left;
  }
}

}  // namespace thaw
