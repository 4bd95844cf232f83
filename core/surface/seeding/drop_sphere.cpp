// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/drop_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/hash_random.hpp"
#include "core/math/tangent.hpp"
#include "core/surface/data/surfel_ids.hpp"

namespace thaw {

std::vector<SurfelRow> dropSphere(std::uint64_t component, const Vec3d& centre, double volume,
                                  double spacing) {
  constexpr double pi = std::numbers::pi, goldenAngle = 2.39996322972865332;
  const double R = std::cbrt(0.75 * volume / pi), area = 4 * pi * R * R, perSurfel = std::sqrt(0.75);
  const double n = std::max(24.0, std::ceil(area / (perSurfel * spacing * spacing)));
  std::vector<SurfelRow> rows;
  for (double k = 0; k < n; k++) {
    const double z = 1 - (2 * k + 1) / n, across = std::sqrt(1 - z * z);
    SurfelRow r;
    r.id = surfelBit | birthBit |
           randomBits(0, Purpose::SurfelBirth, component, static_cast<std::uint64_t>(k));
    r.component = component;
    r.normal = {across * std::cos(goldenAngle * k), across * std::sin(goldenAngle * k), z};
    r.position = centre + R * r.normal;
    r.tangent = anyTangent(r.normal);
    r.radius = std::min(spacing, std::sqrt(area / (n * perSurfel)));
    rows.push_back(r);
  }
  return rows;
}

}  // namespace thaw
