// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/fields.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/basic/shape_error.hpp"

namespace thaw {
namespace {

double factorAt(const OrientedField& f, double time) {
  return time < f.from || time >= f.until ? 0 : f.inTime.at(time);
}

/// Returns the mean factor (1) between two times (s).
double meanFactor(const OrientedField& f, double from, double to) {
  const double begin = std::max(from, f.from), end = std::min(to, f.until);
  if (!(begin < end)) return 0;
  const double mean = f.inTime.mean(begin, end);
  return begin == from && end == to ? mean : mean * ((end - begin) / (to - from));
}

/// Returns whether the field is on between two times (s) and changes linearly.
bool linear(const OrientedField& f, double from, double to) {
  return f.from <= from && f.until >= to && f.inTime.linear(from, to);
}
bool constant(const OrientedField& f, double from, double to) {
  return f.until <= from || f.from >= to || (linear(f, from, to) && f.inTime.at(from) == f.inTime.at(to));
}

double factorNow(const OrientedView& w, const OrientedField& f) {
  const OrientedWork& work = w.work;
  if (!(work.over > 0)) return factorAt(f, work.time);
  const double from = w.clock.time, to = from + work.over;
  if (w.scene.oriented.front().integrator == OrientedIntegrator::RungeKutta && linear(f, from, to))
    return f.inTime.at(work.time);
  return meanFactor(f, from, to);
}

/// Returns whether the field acts at a position.
bool meets(const OrientedField& f, const SignedDistance* region, const Vec3d& x) {
  if (region && !region->inside(x)) return false;
  return f.attraction == 0 || length(f.acceleration) > 0 || f.pressure != 0 || length(f.point - x) < f.radius;
}

}  // namespace

FieldForce fieldForce(const OrientedView& w, std::size_t i) {
  const Oriented& o = w.oriented.rows;
  const OrientedWork& work = w.work;
  const std::size_t b = o.body[i];
  const OrientedBody& body = w.scene.oriented[b];
  Vec3d acceleration = body.acceleration;
  double pressure = body.pressure, slope = 0;
  for (std::size_t k = 0; k < body.fields.size(); k++) {
    const OrientedField& f = body.fields[k];
    const double factor = factorNow(w, f);
    if (factor == 0) continue;
    if (const auto& region = work.fieldRegions[b][k]; region && !region->inside(o.position[i])) continue;
    acceleration += factor * f.acceleration;
    pressure += factor * f.pressure;
    if (f.attraction == 0) continue;
    const Vec3d d = f.point - o.position[i];
    // 0.286 is the maximum of u (1 - u^2)^2
    const double left = 1 - dot(d, d) / (f.radius * f.radius),
                 steepest = factor * f.attraction / (0.28621670111997308 * f.radius);
    if (!(left > 0)) continue;
    acceleration += (steepest * left * left) * d;
    slope += 2 * std::abs(steepest);
  }
  Vec3d force = o.mass[i] * acceleration +
                (pressure * orientedArea(body, work.potentials[b].spacing)) * o.normal[i];
  if (body.planar) force.y = 0;
  return {force, slope};
}

void averageFields(const OrientedView& w, double dt) {
  Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  const double from = w.clock.time;
  std::vector<std::uint8_t> changes(w.scene.oriented.size(), 0);
  for (std::size_t b = 0; b < changes.size(); b++)
    for (const OrientedField& f : w.scene.oriented[b].fields) changes[b] |= !constant(f, from, from + dt);
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!changes[o.body[i]]) continue;
    work.over = 0;
    const Vec3d then = fieldForce(w, i).force;
    work.over = dt;
    o.force[i] += fieldForce(w, i).force - then;
  }
  work.over = dt;
}

void recordUnusedFields(const OrientedView& w, Reducer& all, double after, double upTo) {
  const Oriented& o = w.oriented.rows;
  OrientedWork& work = w.work;
  for (std::size_t b = 0; b < w.scene.oriented.size(); b++)
    for (std::size_t k = 0; k < w.scene.oriented[b].fields.size(); k++) {
      const OrientedField& f = w.scene.oriented[b].fields[k];
      if (!(f.from > after && f.from <= upTo)) continue;
      std::int64_t met = 0;
      for (std::size_t i = 0; i < o.owned; i++)
        met += o.body[i] == b && meets(f, work.fieldRegions[b][k].get(), o.position[i]);
      all.sum({&met, 1});
      if (met == 0) work.unusedFields.push_back({b, k});
    }
}

std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions(const Scene& s,
                                                                             const MeshLoader& load) {
  SceneProblems problems;
  std::vector<std::vector<std::shared_ptr<const SignedDistance>>> regions;
  for (const OrientedBody& b : s.oriented) {
    regions.emplace_back();
    for (const OrientedField& f : b.fields)
      regions.back().push_back(
          f.everywhere
              ? nullptr
              : makeSignedDistance(f.region, load, "oriented body '" + b.name + "': a field", problems));
  }
  problems.raise();
  return regions;
}

}  // namespace thaw
