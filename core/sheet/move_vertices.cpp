// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/move_vertices.hpp"

namespace thaw {
namespace {

inline void moveOne(const VertexMap& m, double& x, double& v, double rest, double load) {
  const double pull = m.stiffness * (x - rest), u = v;
  x += m.qv * u + m.qr * (load - pull);
  v = m.vv * u + (m.before * load - m.vr * pull);
}

}  // namespace

VertexMap vertexMap(const SpringLaw& law, double dt) {
  const ExactStep x = exactStep(law, dt);
  const SplitForce s = splitForce(law, x, dt);
  return {x.qv, x.vv, x.qr, x.vr, law.stiffness, s.before, s.after};
}

void moveVertices(std::span<const VertexMap> maps, const VertexArrays& a, std::size_t begin,
                  std::size_t end) {
  if (maps.size() == 1) {  // components have the same map: one long loop
    double *x = &a.position->x, *v = &a.velocity->x;
    const double *rest = &a.rest->x, *load = &a.load->x;
    const VertexMap m = maps[0];
#ifdef __clang__
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
    for (std::size_t k = 3 * begin; k < 3 * end; k++) moveOne(m, x[k], v[k], rest[k], load[k]);
    return;
  }
  for (std::size_t i = begin; i < end; i++) {
    const VertexMap& m = maps[a.law[i]];
    for (int c = 0; c < 3; c++) moveOne(m, a.position[i][c], a.velocity[i][c], a.rest[i][c], a.load[i][c]);
  }
}

}  // namespace thaw
