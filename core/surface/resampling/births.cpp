// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/births.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/math/tangent.hpp"
#include "core/surface/advection/reference_motion.hpp"
#include "core/surface/resampling/unique_ids.hpp"

namespace thaw {

namespace {

/// Surfel with a reference position (m), relative to a new surfel next to it.
struct Follower {
  std::size_t row;
  Vec3d d;
  double weight;
};

/// Returns the reference position of a new surfel. An affine map in the tangent plane is fitted by weighted
/// least squares from current to reference positions of the followers. `frame` holds normal and tangents in
/// rows. The distance normal to the plane is kept. If strain were neglected, the new surfel would be
/// displaced by strain times distance when it moves with the reference. Returns nothing if the followers are
/// collinear.
std::optional<Vec3d> placeAtStart(const Surfels& s, const std::vector<Follower>& followers,
                                  const Mat3d& frame, const Vec3d& referenceNormal) {
  // smallest determinant over the square of the larger moment; below it, followers are collinear
  constexpr double line = 0.02;
  double sum = 0, a = 0, b = 0, c = 0;
  Vec3d mean{}, now{};
  for (const Follower& f : followers)
    sum += f.weight, now += f.weight * f.d, mean += f.weight * s.referencePosition[f.row];
  now = now / sum;
  mean = mean / sum;
  Vec3d along1{}, along2{};
  for (const Follower& f : followers) {
    const Vec3d d = f.d - now, then = s.referencePosition[f.row] - mean;
    const double u = dot(d, frame.row[1]), v = dot(d, frame.row[2]);
    a += f.weight * u * u, b += f.weight * u * v, c += f.weight * v * v;
    along1 += f.weight * u * then;
    along2 += f.weight * v * then;
  }
  // signed distance from the new surfel to the followers' mean
  const double across = dot(now, frame.row[0]);
  const double det = a * c - b * b;
  if (!(det > line * std::max(a, c) * std::max(a, c))) return {};
  const double u = -dot(now, frame.row[1]), v = -dot(now, frame.row[2]);
  return mean + ((c * u - b * v) / det) * along1 + ((a * v - b * u) / det) * along2 -
         across * referenceNormal;
}

/// Sets the reference frame of a new surfel to the mean of the frames that its neighbours with a reference
/// imply.
void startOf(const Patch& patch, SurfelRow& born) {
  const Surfels& s = *patch.surfels;
  const std::size_t i = patch.centre;
  if (!hasReference(s, i)) return;
  const double reach = 2.5 * s.radius[i];
  std::vector<Follower> followers;
  Vec3d place{}, normal{}, tangent{};
  double sum = 0;
  const auto add = [&](std::size_t j) {
    const Vec3d d = born.position - s.position[j];
    const double u = 1 - dot(d, d) / (reach * reach);
    if (!hasReference(s, j) || !(u > 0)) return;
    const double w = u * u * u;
    // Rows of these matrices turn a vector into the local frame.
    const Mat3d now{{s.normal[j], s.tangent[j], cross(s.normal[j], s.tangent[j])}};
    const Mat3d then{
        {s.referenceNormal[j], s.referenceTangent[j], cross(s.referenceNormal[j], s.referenceTangent[j])}};
    const auto back = [&](const Vec3d& v) { return transpose(then) * (now * v); };
    followers.push_back({j, -d, w});
    sum += w;
    place += w * (s.referencePosition[j] + back(d));
    normal += w * back(born.normal);
    tangent += w * back(born.tangent);
  };
  add(i);
  for (const std::uint32_t j : patch.rows) add(j);
  normal = normalized(normal);
  const Vec3d across = tangent - dot(tangent, normal) * normal;
  if (!(sum > 0) || !(dot(normal, normal) > 0.5) || !(dot(across, across) > 0)) return;
  born.hasReference = true;
  born.referencePosition = placeAtStart(s, followers,
                                        {{born.normal, born.tangent, cross(born.normal, born.tangent)}},
                                        normal)
                               .value_or(place / sum);
  born.referenceNormal = normal;
  born.referenceTangent = normalized(across);
}

}  // namespace

SurfelRow blendedSurfel(const Patch& patch, const SurfacePoint& p) {
  const Surfels& s = *patch.surfels;
  const std::size_t i = patch.centre;
  SurfelRow born;
  born.component = s.component[i];
  born.position = p.position;
  born.normal = p.normal;
  const Vec3d across = s.tangent[i] - p.normal * dot(p.normal, s.tangent[i]);
  born.tangent = dot(across, across) > 0.01 ? normalized(across) : anyTangent(p.normal);
  const double reach = 1.5 * s.radius[i];
  double sum = 0, radius = 0, detail = 0, liquid = 0, temperature = 0, colour[3]{}, soft = 0,
         maxLiquidFraction = 0, detailHeight = 0;
  const auto add = [&](std::size_t j) {
    const Vec3d d = s.position[j] - p.position;
    // The parent always contributes.
    const double u = std::max(1 - dot(d, d) / (reach * reach), j == i ? 1e-3 : 0.0), w = u * u * u;
    sum += w;
    radius += w * s.radius[j];
    detail += w * static_cast<double>(s.detail[j]);
    if (s.liquid.active) liquid += w * static_cast<double>(s.liquid[j]);
    if (s.temperature.active) temperature += w * static_cast<double>(s.temperature[j]);
    if (s.maxLiquidFraction.active && s.maxLiquidFraction[j] > 0)
      soft += w, maxLiquidFraction += w * static_cast<double>(s.maxLiquidFraction[j]),
          detailHeight += w * static_cast<double>(s.detailHeight[j]);
    for (int c = 0; c < 3; c++) colour[c] += w * static_cast<double>(s.colour[j] >> 8 * c & 255);
  };
  add(i);
  for (const std::uint32_t j : patch.rows) add(j);
  born.radius = radius / sum;
  born.detail = static_cast<float>(detail / sum);
  born.liquid = static_cast<float>(liquid / sum);
  born.temperature = static_cast<float>(temperature / sum);
  if (s.maxLiquidFraction.active && s.maxLiquidFraction[i] > 0)
    born.maxLiquidFraction = static_cast<float>(maxLiquidFraction / soft),
    born.detailHeight = static_cast<float>(detailHeight / soft);
  for (int c = 0; c < 3; c++)
    born.colour |= static_cast<std::uint32_t>(std::clamp(std::lround(colour[c] / sum), 0l, 255l)) << 8 * c;
  startOf(patch, born);
  return born;
}

void appendSurfels(Surfels& s, const std::vector<SurfelRow>& rows) {
  std::size_t i = s.owned;
  s.resize(s.owned + rows.size(), 0);
  for (const SurfelRow& r : rows) {
    s.id[i] = r.id;
    s.component[i] = r.component;
    s.position[i] = r.position;
    s.normal[i] = r.normal;
    s.tangent[i] = r.tangent;
    s.radius[i] = r.radius;
    s.colour[i] = r.colour;
    s.detail[i] = r.detail;
    s.resampleMargin[i] = 0;
    if (s.wallOffset.active) s.wallOffset[i] = {};
    if (s.hasReference.active)
      s.hasReference[i] = r.hasReference, s.referencePosition[i] = r.referencePosition,
      s.referenceNormal[i] = r.referenceNormal, s.referenceTangent[i] = r.referenceTangent;
    if (s.relaxesOnce.active) s.relaxesOnce[i] = r.detail < 0.5f;
    // blendSurfels treats the new surfel like its neighbours.
    if (s.carriedNormal.active && !(s.relaxesOnce.active && s.relaxesOnce[i]))
      s.carried[i] = r.position, s.carriedNormal[i] = r.normal;
    if (s.liquid.active) s.liquid[i] = r.liquid;
    if (s.maxLiquidFraction.active)
      s.maxLiquidFraction[i] = r.maxLiquidFraction, s.detailHeight[i] = r.detailHeight;
    if (s.temperature.active) s.temperature[i] = r.temperature;
    i++;
  }
}

void addSurfels(Surfels& s, const std::vector<SurfelRow>& rows, std::uint64_t seed, Reducer& all,
                const Surfels* others) {
  const std::size_t first = s.owned;
  appendSurfels(s, rows);
  makeIdsUnique(s, first, seed, all, others);
}

}  // namespace thaw
