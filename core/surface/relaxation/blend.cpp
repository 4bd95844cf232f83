// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/blend.hpp"

#include <algorithm>
#include <cmath>

#include "core/surface/work/relax_tools.hpp"

namespace thaw {
namespace {

/// Rate of fading with strain. On a half-molten surface, a strain of 1 leaves 1/e of a detail's height.
constexpr double strainFading = 2;

/// Motion of a surfel in this update from its carried to its relaxed position.
struct RelaxationStep {
  double down = 0;   // m, against the relaxed normal
  double share = 0;  // 1, fraction of the remaining motion: along the surface, and of the rotation
};

/// Returns the motion of surfel i. Its height over the smooth surface is its detail height plus a height
/// added by motion. The detail fades to the factor 1 - b, for the largest liquid fraction b since it was
/// solid. It also fades with strain, by exp(-strainFading b strain). The added height fades by b in each
/// update, as in the paper, permanently. At small b, added height becomes detail, because nearly solid
/// surfels are carried, not relaxed.
RelaxationStep relaxationStepOf(Surfels& s, std::size_t i, double b, double height) {
  const bool recorded = s.maxLiquidFraction.active;
  const double before = recorded ? static_cast<double>(s.maxLiquidFraction[i]) : 0,
               detailHeight = before > 0 ? static_cast<double>(s.detailHeight[i]) : height;
  const double strain = s.strain.active ? static_cast<double>(s.strain[i]) : 0, added = height - detailHeight;
  const double left = b >= 1
                          ? 0
                          : (b > before ? (1 - b) / (1 - before) : 1) * std::exp(-strainFading * b * strain);
  if (recorded) {
    const double solid = (1 - b) * (1 - b);
    s.maxLiquidFraction[i] = static_cast<float>(std::max(before, b));
    s.detailHeight[i] = static_cast<float>(detailHeight * left + solid * solid * added);
  }
  const double off = std::min(1.0, added * added / (s.radius[i] * s.radius[i]));
  // The surfel never moves away from the surface.
  const double down = std::clamp(detailHeight * (1 - left) + b * added, std::min(height, 0.0),
                                 std::max(height, 0.0));
  return {down, 1 - left * (1 - b * off)};
}

}  // namespace

void blendSurfels(Surfels& s) {
  if (!s.carriedNormal.active) return;
  s.resize(s.owned, 0);
  for (std::size_t i = 0; i < s.owned; i++) {
    const Vec3d before = s.carriedNormal[i], relaxed = s.normal[i];
    if (dot(before, before) == 0) {  // born in this update
      s.resampleMargin[i] = 0;
      continue;
    }
    const double b = std::clamp(static_cast<double>(s.liquid[i]), 0.0, 1.0);
    Vec3d move = s.position[i] - s.carried[i];
    const double height = -dot(move, relaxed);
    RelaxationStep way;
    if (b > 0) way = relaxationStepOf(s, i, b, height);
    else if (s.maxLiquidFraction.active) s.maxLiquidFraction[i] = s.detailHeight[i] = 0;
    if (b < 1) {
      move = way.share * (move + height * relaxed) - way.down * relaxed;
      s.position[i] = s.carried[i] + move;
      const Vec3d n = (1 - way.share) * before + way.share * relaxed;
      const double size = length(n);
      // Opposite normals have no mean.
      s.normal[i] = size > 1e-6 ? n / size : before;
      const Vec3d d = s.tangent[i] - dot(s.tangent[i], s.normal[i]) * s.normal[i];
      if (dot(d, d) > 1e-12) s.tangent[i] = normalized(d);
    }
    s.resampleMargin[i] = std::max(0.0f,
                                   s.resampleMargin[i] - static_cast<float>(length(move) / s.radius[i]));
    s.detail[i] = static_cast<float>(static_cast<double>(s.detail[i]) * (1 - way.share));
  }
  deactivate(s.carried);
  deactivate(s.carriedNormal);
  deactivate(s.strain);
}

}  // namespace thaw
