// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact/edge_code.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math/tangent.hpp"

namespace thaw {
namespace {

// The code is 1 + ahead + ends * behind + angle / pi. A float holds it without rounding.
constexpr int ends = 17;          // number of codes for an end; 0: the edge continues
constexpr double endStep = 0.1;   // spacings
constexpr double angles = 32768;  // number of directions in half a turn

struct Unpacked {
  Vec3d along{};
  int ahead = 0, behind = 0;
};

/// Two orthogonal unit vectors normal to the vector to the edge.
struct Across {
  Vec3d first, second;
};

Across across(const Vec3d& to) {
  const Vec3d first = normalized(cross(to, leastAxis(to)));
  return {first, cross(normalized(to), first)};
}

float pack(const Vec3d& to, Unpacked u) {
  const Across t = across(to);
  const double part = std::atan2(dot(u.along, t.second), dot(u.along, t.first)) / std::numbers::pi;
  double number = std::round(part * angles);
  if (number < 0 || number >= angles) {
    number -= std::copysign(angles, number);  // the opposite direction
    std::swap(u.ahead, u.behind);
  }
  return static_cast<float>(-(1 + u.ahead + ends * u.behind + std::abs(number) / angles));
}

Unpacked unpack(const Vec3d& to, float code) {
  const double number = -static_cast<double>(code) - 1, whole = std::floor(number);
  const double angle = std::numbers::pi * (number - whole);
  const Across t = across(to);
  return {std::cos(angle) * t.first + std::sin(angle) * t.second, static_cast<int>(whole) % ends,
          static_cast<int>(whole) / ends};
}

int numberOfEnd(double distance, double spacing) {
  if (!(distance < endStep * (ends - 0.5) * spacing)) return 0;
  return std::max(1, static_cast<int>(std::lround(distance / (endStep * spacing))));
}

double endOf(int number, double spacing) { return number > 0 ? number * endStep * spacing : HUGE_VAL; }

bool hasEdge(const SurfaceElement& e) { return e.radius < 0; }

}  // namespace

SurfaceElement elementOfEdge(double offset, const SharpEdge& edge, double spacing) {
  const auto r = static_cast<float>(offset);
  SurfaceElement e{single(edge.to / static_cast<double>(r)), r, r};
  if (edge.along == Vec3d{}) return e;
  e.radius = pack(wide(e.normal),
                  {edge.along, numberOfEnd(edge.ahead, spacing), numberOfEnd(edge.behind, spacing)});
  return e;
}

SharpEdge edgeOf(const SurfaceElement& e, double spacing) {
  SharpEdge edge;
  edge.to = static_cast<double>(e.offset) * wide(e.normal);
  if (!hasEdge(e)) return edge;
  const Unpacked u = unpack(wide(e.normal), e.radius);
  edge.along = u.along;
  edge.ahead = endOf(u.ahead, spacing);
  edge.behind = endOf(u.behind, spacing);
  return edge;
}

SurfaceElement turned(const SurfaceElement& e, const Quat& rotation) {
  SurfaceElement t{single(rotated(rotation, wide(e.normal))), e.offset, e.radius};
  if (!hasEdge(e)) return t;
  Unpacked u = unpack(wide(e.normal), e.radius);
  u.along = rotated(rotation, u.along);
  t.radius = pack(wide(t.normal), u);
  return t;
}

}  // namespace thaw
