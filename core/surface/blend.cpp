#include "core/surface/blend.hpp"

#include "core/surface/relax_tools.hpp"

namespace thaw {

void blendSurfels(World& w) {
  Surfels& s = w.surface.surfels;
  if (!s.carriedNormal.active) return;
  s.resize(s.owned, 0);
  for (std::size_t i = 0; i < s.owned; i++) {
    const Vec3d before = s.carriedNormal[i];
    if (dot(before, before) == 0) {  // born in this update
      s.calm[i] = 0;
      continue;
    }
    const double b = std::clamp(static_cast<double>(s.liquid[i]), 0.0, 1.0);
    const Vec3d move = b * (s.position[i] - s.carried[i]);
    if (b < 1) {
      s.position[i] = s.carried[i] + move;
      Vec3d d = s.position[i] - s.carried[i];
      const Vec3d n = (1 - b) * before + b * s.normal[i];
      const double size = length(n);
      s.normal[i] = size > 1e-6 ? n / size : before;  // opposite ones have no middle
      d = s.tangent[i] - dot(s.tangent[i], s.normal[i]) * s.normal[i];
      if (dot(d, d) > 1e-12) s.tangent[i] = normalized(d);
    }
    s.calm[i] = std::max(0.0f, s.calm[i] - static_cast<float>(length(move) / s.radius[i]));
    if (length(move) > w.scene.surface.stop * s.radius[i]) s.detail[i] = static_cast<float>(static_cast<double>(s.detail[i]) * (1 - b));
  }
  deactivate(s.carried);
  deactivate(s.carriedNormal);
}

}  // namespace thaw
