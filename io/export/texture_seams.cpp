// SPDX-License-Identifier: Apache-2.0
#include "io/export/texture_seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaw {

namespace {

/// An edge crosses a seam if its length in the texture exceeds this times the median.
constexpr float seamLength = 6;

float lengthBetween(const Uv& a, const Uv& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

}  // namespace

std::vector<std::array<Uv, 3>> cornerUvs(const TriangleMesh& mesh, const std::vector<Uv>& uv) {
  std::vector<float> lengths;
  for (const auto& t : mesh.triangles) lengths.push_back(lengthBetween(uv[t[0]], uv[t[1]]));
  float most = std::numeric_limits<float>::infinity();
  if (!lengths.empty()) {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    most = std::max(seamLength * *middle, 0.02f);
  }
  std::vector<std::array<Uv, 3>> corners;
  corners.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    std::array<Uv, 3> c{uv[t[0]], uv[t[1]], uv[t[2]]};
    for (std::size_t k = 1; k < 3; k++)
      if (lengthBetween(c[k], c[0]) > most) c[k] = c[0];
    corners.push_back(c);
  }
  return corners;
}

}  // namespace thaw
