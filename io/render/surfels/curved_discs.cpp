// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/curved_discs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/surface/search/bins.hpp"

namespace thaw {

namespace {

constexpr float around = 1.7f;    // in disc radii: range of neighbours for its curvature
constexpr float sameFace = 0.2f;  // least cosine of a neighbour's normal, for the curvature
// The same for the surface: other normals belong to the other side of a thin sheet.
constexpr float oneSheet = -0.3f;
constexpr float sharpness = 0.48f;  // in disc radii: width of the weights
constexpr float uneven = 0.12f;     // fraction of the squared change of normals that the fitted
                                    // curvature may leave unexplained
constexpr std::size_t fewest = 4;
// Cosines: of one flat face, and of another one beyond a sharp edge.
constexpr float flatFace = 0.995f, sharp = 0.5f;
/// Spacing of the hexagonal lattice on which 1 + 3 k (k + 1) discs cover a disc of radius 1. A part's radius
/// is `partOf` times the spacing.
constexpr float ringSpacing[4] = {0, 0.81f, 0.476f, 0.34f};
constexpr float partOf = 0.62f;

Vec3f anyAcross(const Vec3f& n) {
  const Vec3f a = cross(n, std::abs(n.x) < 0.6f ? Vec3f{1, 0, 0} : Vec3f{0, 1, 0});
  return a / std::sqrt(dot(a, a));
}

/// sine: approximate sine of the rotation of normals within a disc's radius. It is 0 on flat faces, also at a
/// sharp edge between them, where discs are clipped instead (disc_clips.hpp).
struct Turn {
  float sine = 0;
  bool edge = false;
};
Turn turnOf(const Discs& discs, std::span<const std::uint32_t> components, std::uint32_t i,
            std::span<const std::uint32_t> near) {
  const Vec3f x = discs.positions[i], n = discs.normals[i];
  const float r = discs.radius(i);
  float most = 0;
  bool flat = true, edge = false;
  int same = 0;
  for (const std::uint32_t j : near) {
    const float cosine = dot(n, discs.normals[j]);
    if (cosine < oneSheet || (!components.empty() && components[j] != components[i])) continue;
    const Vec3f d = discs.positions[j] - x;
    same += j != i && cosine > flatFace;
    flat = flat && (cosine > flatFace || cosine < sharp);
    edge = edge || cosine < sharp;
    const float sine2 = std::max(0.0f, 1 - cosine * std::max(0.0f, cosine)), d2 = dot(d, d);
    most = std::max(most, sine2 * std::min(1.0f, r * r / std::max(1e-30f, d2)));
  }
  if (flat && same > 1) return {0, edge};
  return {std::sqrt(most), false};
}

/// Projects a part of disc i onto the surface between nearby discs and sets its normal. The surface is where
/// the mean of their planes and of the plane across the mean normal vanishes. It is exact on spheres, and
/// rounds edges by a third of a spacing. Returns false without discs nearby.
bool ontoDiscs(const Discs& discs, std::span<const std::uint32_t> components, std::uint32_t i,
               std::span<const std::uint32_t> near, DiscPart& part) {
  const Vec3f start = part.position;
  const float r = discs.radius(i);
  for (int round = 0; round < 3; round++) {
    float nearest2 = std::numeric_limits<float>::infinity();
    const auto forSheet = [&](auto use) {
      for (const std::uint32_t j : near) {
        if (dot(discs.normals[i], discs.normals[j]) < oneSheet ||
            (!components.empty() && components[j] != components[i]))
          continue;
        const Vec3f d = part.position - discs.positions[j];
        use(j, d, dot(d, d));
      }
    };
    forSheet([&](std::uint32_t, const Vec3f&, float d2) { nearest2 = std::min(nearest2, d2); });
    float sum = 0, planes = 0;
    Vec3f away{}, normal{};
    forSheet([&](std::uint32_t j, const Vec3f& d, float d2) {
      const float width = sharpness * discs.radius(j),
                  w = std::exp(std::max(-60.0f, (nearest2 - d2) * 0.5f / (width * width)));
      sum += w;
      planes += w * dot(d, discs.normals[j]);
      away += w * d;
      normal += w * discs.normals[j];
    });
    const float size = std::sqrt(dot(normal, normal));
    if (!(size > 0.2f * sum)) return false;
    part.normal = normal / size;
    const float height = 0.5f * (planes + dot(part.normal, away)) / sum;
    part.position -= height * part.normal;
    if (std::abs(height) < 0.01f * r) break;
  }
  const Vec3f moved = part.position - start;
  if (!(dot(moved, moved) < r * r)) return false;
  float sum = 0;
  for (const std::uint32_t j : near) {
    if (dot(part.normal, discs.normals[j]) < sameFace ||
        (!components.empty() && components[j] != components[i]))
      continue;
    const Vec3f d = part.position - discs.positions[j];
    DiscPart::Share own{j, std::max(0.0f, 1 - dot(d, d) / (r * r))};
    for (DiscPart::Share& s : part.mix)
      if (own.share > s.share) std::swap(own, s);
  }
  for (const DiscPart::Share& s : part.mix) sum += s.share;
  if (!(sum > 0)) return false;
  for (DiscPart::Share& s : part.mix) s.share /= sum;
  return true;
}

}  // namespace

DiscCurvature curvatureOf(const Discs& discs, std::span<const std::uint32_t> components, std::uint32_t i,
                          std::span<const std::uint32_t> near) {
  const Vec3f x = discs.positions[i], n = discs.normals[i];
  DiscCurvature c{anyAcross(n)};
  const Vec3f u = c.u, v = cross(n, u);
  float m[3][3]{}, right[3]{}, turned = 0;
  std::size_t count = 0;
  const auto forFace = [&](auto use) {
    for (const std::uint32_t j : near) {
      const Vec3f d = discs.positions[j] - x, other = discs.normals[j];
      if (j == i || dot(n, other) < sameFace || (!components.empty() && components[j] != components[i]))
        continue;
      const float a = dot(d, u), b = dot(d, v), r2 = a * a + b * b;
      if (r2 > 0) use(a, b, dot(other, u), dot(other, v), 1 / r2);
    }
  };
  forFace([&](float a, float b, float p, float q, float w) {
    const float row[2][3] = {{a, b, 0}, {0, a, b}}, turn[2] = {p, q};
    for (int e = 0; e < 2; e++)
      for (int k = 0; k < 3; k++) {
        for (int l = 0; l < 3; l++) m[k][l] += w * row[e][k] * row[e][l];
        right[k] += w * row[e][k] * turn[e];
      }
    turned += w * (p * p + q * q);
    count++;
  });
  if (count < fewest) return c;
  const float det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  const float size = static_cast<float>(count);
  if (!(det > 1e-3f * size * size * size / 27)) return c;  // neighbours lie on one side, or are collinear
  const auto solve = [&](int k) {                          // Cramer's rule
    float a[3][3];
    for (int r = 0; r < 3; r++)
      for (int l = 0; l < 3; l++) a[r][l] = l == k ? right[r] : m[r][l];
    return (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
            a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
            a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0])) /
           det;
  };
  const DiscCurvature fit{u, solve(0), solve(1), solve(2)};
  float left = 0;
  forFace([&](float a, float b, float p, float q, float w) {
    const float dp = p - fit.uu * a - fit.uv * b, dq = q - fit.uv * a - fit.vv * b;
    left += w * (dp * dp + dq * dq);
  });
  return left < uneven * turned ? fit : c;
}

std::vector<DiscPart> curvedDiscs(const Discs& discs, std::span<const std::uint32_t> components,
                                  const std::function<float(std::uint32_t)>& allowed) {
  std::vector<DiscPart> parts;
  const std::size_t count = discs.positions.size();
  parts.reserve(count);
  float largest = 0;
  for (std::size_t i = 0; i < count; i++) largest = std::max(largest, discs.radius(i));
  if (!(largest > 0)) return parts;
  std::vector<float> radii;
  for (std::size_t i = 0; i < count; i++) radii.push_back(discs.radius(i));
  // Bins follow the 90th percentile, since radii may vary widely.
  const std::size_t typical = count * 9 / 10;
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(typical), radii.end());
  std::vector<Vec3d> places;
  for (const Vec3f& p : discs.positions) places.push_back({p.x, p.y, p.z});
  Bins bins;
  fillBins(places.data(), count, around * radii[typical], bins);
  RowBlock block;
  std::vector<std::uint32_t> near;
  const auto draw = [&](std::uint32_t i, float most, const RowBlock& beside) {
    const Vec3f x = discs.positions[i], n = discs.normals[i];
    const float r = discs.radius(i);
    const auto whole = [&](bool edge = false) { parts.push_back({x, n, r, i, edge, {{{i, 1}}}}); };
    if (!(0.5f * r > most)) return whole();  // flat enough even if normals rotate by a right angle
    near.clear();
    const double far2 = static_cast<double>(around * around * r * r);
    for (std::size_t k = 0; k < beside.count; k++)
      if (const Vec3d d = beside.at[k] - places[i]; dot(d, d) < far2) near.push_back(beside.row[k]);
    const Turn turn = turnOf(discs, components, i, near);
    if (turn.edge) return whole(true);
    const float rise = 0.5f * r * turn.sine;
    int rings = 0;
    while (rings < 3 &&
           rise * (rings == 0 ? 1.0f : partOf * ringSpacing[rings] * partOf * ringSpacing[rings]) > most)
      rings++;
    if (rings == 0) return whole();
    const DiscCurvature c = curvatureOf(discs, components, i, near);
    const Vec3f u = c.u, v = cross(n, u);
    const float step = ringSpacing[rings] * r;
    for (int row = -rings; row <= rings; row++)
      for (int column = std::max(-rings, -rings - row); column <= std::min(rings, rings - row); column++) {
        const float away = step * std::sqrt(static_cast<float>(row * row + row * column + column * column));
        const float a = away > 0 ? step * (static_cast<float>(column) + 0.5f * static_cast<float>(row)) / away
                                 : 1,
                    b = away > 0 ? step * 0.8660254f * static_cast<float>(row) / away : 0;
        // along an arc of the curvature in this direction, by length on the surface; then projected
        const float bend = a * a * c.uu + 2 * a * b * c.uv + b * b * c.vv;
        const float angle = std::clamp(bend * away, -1.6f, 1.6f),
                    flat = std::abs(angle) > 1e-4f ? std::sin(angle) / angle * away : away;
        const float sunk = std::abs(angle) > 1e-4f ? (1 - std::cos(angle)) / angle * away : 0;
        DiscPart part{x + flat * (a * u + b * v) - sunk * n, n, partOf * step, i, false, {}};
        if (ontoDiscs(discs, components, i, near, part)) parts.push_back(part);
      }
  };
  std::vector<float> most;
  for (std::size_t b = 0; b < bins.size(); b++) {
    most.clear();
    bool any = false;
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++) {
      most.push_back(allowed(bins.row[k]));
      any = any || 0.5f * discs.radius(bins.row[k]) > most.back();
    }
    if (any) block.find(bins, boxOf(bins, b), static_cast<double>(around * radii[typical]));
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++)
      draw(bins.row[k], most[k - bins.first[b]], block);
  }
  return parts;
}

}  // namespace thaw
