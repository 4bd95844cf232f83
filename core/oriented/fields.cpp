#include "core/oriented/fields.hpp"

#include <cmath>

#include "core/geometry/shape_error.hpp"

namespace thaw {

FieldForce fieldForce(const World& w, const OrientedWork& work, std::size_t i) {
  const Oriented& o = w.oriented.rows;
  const std::size_t b = o.body[i];
  const OrientedBody& body = w.scene.oriented[b];
  Vec3d push = body.push;
  double pressure = body.pressure, slope = 0;
  for (std::size_t k = 0; k < body.fields.size(); k++) {
    const OrientedField& f = body.fields[k];
    if (work.time < f.from || work.time >= f.until) continue;
    if (const auto& region = work.fieldRegions[b][k]; region && !region->inside(o.position[i])) continue;
    const double factor = f.inTime.at(work.time);
    push += factor * f.push;
    pressure += factor * f.pressure;
    if (f.pull == 0) continue;
    const Vec3d d = f.point - o.position[i];
    const double left = 1 - dot(d, d) / (f.radius * f.radius), steepest = factor * f.pull / (0.28621670111997308 * f.radius);  // u (1 - u^2)^2 where it is largest
    if (!(left > 0)) continue;
    push += (steepest * left * left) * d;
    slope += 2 * std::abs(steepest);
  }
  Vec3d force = o.mass[i] * push + (pressure * orientedArea(body, work.potentials[b].spacing)) * o.normal[i];
  if (body.planar) force.y = 0;
  return {force, slope};
}

std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions(const Scene& s, const MeshLoader& load) {
  SceneProblems problems;
  std::vector<std::vector<std::shared_ptr<const SignedDistance>>> regions;
  for (const OrientedBody& b : s.oriented) {
    regions.emplace_back();
    for (const OrientedField& f : b.fields) regions.back().push_back(f.everywhere ? nullptr : makeSignedDistance(f.region, load, "oriented body '" + b.name + "': a field", problems));
  }
  problems.raise();
  return regions;
}

}  // namespace thaw
