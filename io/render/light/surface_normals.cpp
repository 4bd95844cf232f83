// SPDX-License-Identifier: Apache-2.0
#include "io/render/light/surface_normals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/image/linear_light.hpp"

namespace thaw {

namespace {

struct Cell {
  int x, y, z;
};
Cell cellOf(const Vec3f& p, float edge) {
  return {cellAlong(p.x, edge), cellAlong(p.y, edge), cellAlong(p.z, edge)};
}

}  // namespace

CellBins binParticles(std::span<const Vec3f> positions, float edge) {
  CellBins bins;
  bins.edge = edge;
  std::uint32_t size = 16;
  while (size < positions.size() / 4) size *= 2;
  bins.mask = size - 1;
  bins.first.assign(size + 1, 0);
  bins.members.resize(positions.size());
  std::vector<std::uint32_t> bin(positions.size());
  for (std::size_t i = 0; i < positions.size(); i++) {
    const Cell c = cellOf(positions[i], edge);
    bin[i] = bins.bin(c.x, c.y, c.z);
    bins.first[bin[i] + 1]++;
  }
  for (std::uint32_t b = 0; b < size; b++) bins.first[b + 1] += bins.first[b];
  std::vector<std::uint32_t> next(bins.first.begin(), bins.first.end() - 1);
  for (std::size_t i = 0; i < positions.size(); i++)
    bins.members[next[bin[i]]++] = static_cast<std::uint32_t>(i);
  return bins;
}

float nearestNeighbour(std::span<const Vec3f> positions, const CellBins& bins, const Vec3f& from) {
  float nearest2 = std::numeric_limits<float>::infinity();
  forNeighbours(positions, bins, from, [&](std::uint32_t, const Vec3f& d, float) {
    const float d2 = dot(d, d);
    if (d2 > 0) nearest2 = std::min(nearest2, d2);
  });
  return std::sqrt(nearest2);
}

std::vector<SurfaceNormal> surfaceNormals(std::span<const Vec3f> positions,
                                          std::span<const std::uint32_t> which, const CellBins& bins) {
  std::vector<SurfaceNormal> out(which.size());
  for (std::size_t k = 0; k < which.size(); k++) {
    Vec3f sum{};
    float total = 0;
    int count = 0;
    forNeighbours(positions, bins, positions[which[k]], [&](std::uint32_t, const Vec3f& d, float w) {
      sum += w * d;
      total += w;
      count++;
    });
    const float length = std::sqrt(dot(sum, sum));
    if (length <= 0) continue;
    // A flat surface shifts the weighted centre by about 0.2 of the range.
    const float crowd = ramp(3, 12, static_cast<float>(count));
    out[k] = {sum / length, crowd * ramp(0.02f, 0.09f, length / (total * bins.edge))};
  }
  return out;
}

Smoothed smoothOver(std::span<const Vec3f> positions, std::span<const std::uint32_t> which,
                    const CellBins& bins, const Smoothed& raw) {
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> place(positions.size(), none);
  for (std::size_t k = 0; k < which.size(); k++) place[which[k]] = static_cast<std::uint32_t>(k);
  Smoothed out = raw;
  for (std::size_t k = 0; k < which.size(); k++) {
    const SurfaceNormal& own = raw.normals[k];
    if (own.strength <= 0) continue;
    Vec3f normal{};
    float value = 0, strength = 0, total = 0;
    forNeighbours(positions, bins, positions[which[k]], [&](std::uint32_t j, const Vec3f&, float w) {
      const std::uint32_t m = place[j];
      if (m == none) return;
      const SurfaceNormal& n = raw.normals[m];
      const float alike = w * std::max(0.0f, dot(n.normal, own.normal)) * (n.strength + 0.05f);
      normal += alike * n.normal;
      value += alike * raw.values[m];
      strength += alike * n.strength;
      total += alike;
    });
    const float length = std::sqrt(dot(normal, normal));
    if (length <= 0 || total <= 0) continue;
    out.normals[k] = {normal / length, strength / total};
    out.values[k] = value / total;
  }
  return out;
}

}  // namespace thaw
