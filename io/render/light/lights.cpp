// SPDX-License-Identifier: Apache-2.0
#include "io/render/light/lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/render/light/triangle_rows.hpp"

namespace thaw {

namespace {

Vec3f unit(const Vec3f& a) {
  const float l = std::sqrt(dot(a, a));
  return l > 0 ? a / l : a;
}

constexpr int skyDirections = 24, glassDirections = 8;

Vec3f sunDirection(const Lighting& lighting, const View& view) {
  if (lighting.sun) return single(normalized(*lighting.sun));
  Vec3f level{view.forward.x, view.forward.y, 0};
  level = dot(level, level) > 1e-6f ? unit(level) : unit({view.up.x, view.up.y, 0});
  return unit(-0.62f * view.right - 0.52f * level + Vec3f{0, 0, 0.95f});
}

}  // namespace

std::vector<LightSource> lightSources(const Lighting& lighting, const View& view) {
  std::vector<LightSource> all;
  for (const DistantLight& l : lighting.lights)
    all.push_back({single(normalized(l.direction)), l.colour, static_cast<float>(0.5 * l.size)});
  // about ten times the size of the real sun, as in haze
  if (all.empty()) all.push_back({sunDirection(lighting, view), {1, 1, 1}, 0.07f});
  return all;
}

std::vector<Vec3f> lightDisc(const LightSource& light, int count) {
  const Vec3f& toSun = light.toLight;
  const Vec3f u = unit(cross(toSun, std::abs(toSun.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{1, 0, 0})),
              v = cross(toSun, u);
  std::vector<Vec3f> directions;
  for (int k = 0; k < count; k++) {  // Vogel's spiral: uniform over the disc
    const float r = light.radius * std::sqrt((static_cast<float>(k) + 0.5f) / static_cast<float>(count));
    const float angle = static_cast<float>(k * std::numbers::pi * (3 - std::sqrt(5.0)));
    directions.push_back(unit(toSun + (r * std::cos(angle)) * u + (r * std::sin(angle)) * v));
  }
  return directions;
}

std::vector<Vec3f> skyDome(int count) {
  // Fibonacci's spiral: uniform over the hemisphere, from nearly horizontal to nearly vertical.
  std::vector<Vec3f> directions;
  for (int k = 0; k < count; k++) {
    const float z = 0.06f + 0.93f * (static_cast<float>(k) + 0.5f) / static_cast<float>(count),
                s = std::sqrt(1 - z * z);
    const float angle = static_cast<float>(k * std::numbers::pi * (3 - std::sqrt(5.0)));
    directions.push_back({s * std::cos(angle), s * std::sin(angle), z});
  }
  return directions;
}

Lights makeLights(const Discs& spheres, const RenderStyle& style, const View& view) {
  Lights lights;
  const std::vector<LightSource> sources = lightSources(style.lighting, view);
  lights.source = sources[0];
  lights.ambient = style.lighting.ambient;
  for (std::size_t k = 1; k < sources.size(); k++)
    lights.more.push_back({sources[k], {makeDepthMap(spheres, sources[k].toLight, 3.5f, 2048)}});
  double sum = 0;
  for (std::size_t i = 0; i < spheres.positions.size(); i++) sum += spheres.radius(i);
  lights.radius = spheres.positions.empty()
                      ? 0
                      : static_cast<float>(sum / static_cast<double>(spheres.positions.size()));
  lights.sun = makeDepthMap(spheres, lights.source.toLight, 3.5f, 2048);
  for (const Vec3f& toLight : skyDome(skyDirections))
    lights.sky.push_back(makeDepthMap(spheres, toLight, 1.3f, 512));
  addGlasses(style, lights);
  return lights;
}

void addGlasses(const RenderStyle& style, Lights& lights) {
  const std::vector<GlassWalk> glasses = glassWalks(style);
  if (glasses.empty()) return;
  const auto shadeOf = [&](const LightSource& light) {
    return GlassShade(glasses, lightDisc(light, glassDirections), light.radius);
  };
  lights.glass = shadeOf(lights.source);
  for (SideLight& light : lights.more) light.glass = shadeOf(light.source);
}

float skyLight(const Lights& lights, const Vec3f& point, const Vec3f& normal) {
  float light = 0, full = 0, open = 0;
  const Vec3f from = point + (0.5f * lights.radius) * normal;
  for (const DepthMap& map : lights.sky) {
    const float facing = dot(normal, map.toLight) + 0.15f;  // light from slightly below the horizon counts,
                                                            // as from a sky
    full += map.toLight.z + 0.15f;
    if (facing <= 0) continue;
    const float visible = map.visible(from, 1.4f * lights.radius, 0);
    light += facing * visible;
    open += visible;
  }
  const float bounce = 0.2f * (1 - normal.z) * (0.5f + open / static_cast<float>(lights.sky.size()));
  return light / full + bounce;
}

float directLight(const DepthMap& map, float radius, const Vec3f& point, const Vec3f& normal, int taps) {
  const float facing = dot(normal, map.toLight);
  if (facing <= 0) return 0;
  return facing * map.visible(point + (0.6f * radius) * normal, 1.2f * radius, taps);
}

namespace {

/// Grid on a floor for shadow outlines.
struct FloorGrid {
  Vec3f origin, normal, u, v;
  float reach = 1;
  int side = 1;
  std::vector<std::uint8_t> dark;

  /// Marks cells in the shadow of the casters for a distant light. Discs with normals away from it are
  /// skipped.
  void drawShadows(const Discs& casters, const Vec3f& toLight) {
    std::fill(dark.begin(), dark.end(), 0);
    const float scale = 0.5f * static_cast<float>(side) / reach, up = dot(normal, toLight);
    // Shift of the shadow along u and v per displacement.
    const Vec3f shiftU = u - (dot(toLight, u) / up) * normal, shiftV = v - (dot(toLight, v) / up) * normal;
    for (std::size_t i = 0; i < casters.positions.size(); i++) {
      const Vec3f n = casters.normals.empty() ? toLight : casters.normals[i];
      const float facing = dot(n, toLight);
      if (facing <= 0.02f) continue;
      const Vec3f d = casters.positions[i] - origin;
      if (dot(d, normal) <= 0) continue;
      const float r = casters.radius(i), x = (dot(d, shiftU) + reach) * scale,
                  y = (dot(d, shiftV) + reach) * scale;
      const auto half = [&](const Vec3f& shift) {
        const float along = dot(shift, n);
        return r * scale * std::sqrt(std::max(0.0f, dot(shift, shift) - along * along));
      };
      drawOutline({x, y, half(shiftU), half(shiftV), r * scale, dot(d, normal) * scale}, n, toLight, facing);
    }
    for (const auto& t : casters.triangles) drawTriangle(t, shiftU, shiftV);
  }

  /// Draws the shadow of the part of a triangle above the floor. It must face the light.
  void drawTriangle(const std::array<Vec3f, 3>& corners, const Vec3f& shiftU, const Vec3f& shiftV) {
    const float scale = 0.5f * static_cast<float>(side) / reach;
    std::array<Vec3f, 4> above;  // relative to the origin
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; k++) {
      const Vec3f a = corners[k] - origin, b = corners[(k + 1) % 3] - origin;
      const float ha = dot(a, normal), hb = dot(b, normal);
      if (ha > 0) above[count++] = a;
      if ((ha > 0) != (hb > 0)) above[count++] = a + (ha / (ha - hb)) * (b - a);
    }
    for (std::size_t k = 2; k < count; k++) {
      GridTriangle t;
      const Vec3f* of[3] = {&above[0], &above[k - 1], &above[k]};
      for (std::size_t c = 0; c < 3; c++)
        t.x[c] = (dot(*of[c], shiftU) + reach) * scale, t.y[c] = (dot(*of[c], shiftV) + reach) * scale;
      if (!(t.area2() > 0)) continue;
      forRowsInside(t, side, side, [&](int row, int from, int to) {
        std::fill_n(dark.begin() + static_cast<std::ptrdiff_t>(row) * side + from, to - from + 1,
                    std::uint8_t{1});
      });
    }
  }

  /// Position and half size of a shadow, radius of the disc and height of its centre above the floor, in
  /// cells.
  struct Outline {
    float x, y, halfX, halfY, r, height;
  };

  /// Draws the shadow of one disc: points q relative to its centre that project to the cells. Parts below the
  /// floor cast none.
  void drawOutline(const Outline& o, const Vec3f& n, const Vec3f& toLight, float facing) {
    const auto [x, y, halfX, halfY, r, height] = o;
    const float most = static_cast<float>(side);
    if (!(x > -halfX && y > -halfY && x < most + halfX && y < most + halfY)) return;
    const int y0 = std::max(0, static_cast<int>(std::ceil(y - halfY - 0.5f))),
              y1 = std::min(side - 1, static_cast<int>(std::floor(y + halfY - 0.5f)));
    const int x0 = std::max(0, static_cast<int>(std::ceil(x - halfX - 0.5f))),
              x1 = std::min(side - 1, static_cast<int>(std::floor(x + halfX - 0.5f)));
    const Vec3f stepU = u - (dot(n, u) / facing) * toLight, stepV = v - (dot(n, v) / facing) * toLight;
    const float r2 = r * r;
    for (int j = y0; j <= y1; j++) {
      const Vec3f across = (static_cast<float>(j) + 0.5f - y) * stepV;
      std::uint8_t* row = dark.data() + static_cast<std::size_t>(j) * side;
      for (int k = x0; k <= x1; k++) {
        const Vec3f q = across + (static_cast<float>(k) + 0.5f - x) * stepU;
        if (dot(q, q) <= r2 && dot(q, normal) > -height) row[k] = 1;
      }
    }
    // smaller than a cell
    if (x >= 0 && y >= 0 && x < most && y < most)
      dark[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] = 1;
  }
};

/// Averages each cell with its eight neighbours, repeatedly.
void blur(std::vector<float>& field, int side, int times) {
  std::vector<float> other(field.size());
  for (int pass = 0; pass < 2 * times; pass++) {
    const int step = pass % 2 ? side : 1;
    for (int j = 0; j < side; j++)
      for (int i = 0; i < side; i++) {
        const int k = pass % 2 ? j : i;
        const std::size_t c = static_cast<std::size_t>(j) * side + i;
        other[c] = (field[c] + field[k > 0 ? c - step : c] + field[k < side - 1 ? c + step : c]) / 3;
      }
    field.swap(other);
  }
}

/// Returns the strength of shadows at a cell of a floor: 1, faded out toward the border.
float innerShare(std::size_t cell, int side) {
  const auto inner = [&](std::size_t i) {
    const auto last = static_cast<std::size_t>(side) - 1;
    return std::min(1.0f, 0.05f * static_cast<float>(std::min(i, last - i)));
  };
  return inner(cell % static_cast<std::size_t>(side)) * inner(cell / static_cast<std::size_t>(side));
}

constexpr int floorSunDirections = 32, floorSkyDirections = 64;

}  // namespace

FloorLight::FloorLight(const Lights& lights, const Discs& casters, const FloorHint& floor,
                       const Vec3f& centre, float reach)
    : reach_(reach) {
  normal_ = single(floor.normal);
  origin_ = centre - dot(centre - single(floor.point), normal_) * normal_;
  u_ = unit(cross(normal_, std::abs(normal_.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{1, 0, 0}));
  v_ = cross(normal_, u_);
  // The table extends farther for high objects, whose shadows fall far aside.
  const float height = std::max(0.0f, dot(centre - origin_, normal_)),
              up = std::max(0.2f, dot(normal_, lights.source.toLight));
  reach_ += std::min(height * std::sqrt(std::max(0.0f, 1 - up * up)) / up, 2 * reach);
  FloorGrid grid{origin_,
                 normal_,
                 u_,
                 v_,
                 reach_,
                 side_,
                 std::vector<std::uint8_t>(static_cast<std::size_t>(side_) * side_)};
  // Blocked light by direction, faded out toward the border.
  std::vector<float> sky(grid.dark.size());
  const auto blockedOf = [&](const LightSource& light) {
    std::vector<float> blocked(grid.dark.size());
    const float facing = std::max(0.0f, dot(normal_, light.toLight));
    for (const Vec3f& toLight : lightDisc(light, floorSunDirections)) {
      if (dot(normal_, toLight) <= 0.02f) continue;
      grid.drawShadows(casters, toLight);
      for (std::size_t c = 0; c < blocked.size(); c++)
        blocked[c] += static_cast<float>(grid.dark[c]) * (facing / floorSunDirections);
    }
    blur(blocked, side_, 1);
    return blocked;
  };
  const std::vector<float> sun = blockedOf(lights.source);
  const float sunFacing = std::max(0.0f, dot(normal_, lights.source.toLight));
  float full = 0;
  open_ = {sunFacing, 0};
  for (const Vec3f& toLight : skyDome(floorSkyDirections)) {
    full += toLight.z + 0.15f;
    const float facing = dot(normal_, toLight) + 0.15f;
    if (facing <= 0.17f) continue;
    open_.sky += facing;
    grid.drawShadows(casters, toLight);
    for (std::size_t c = 0; c < sky.size(); c++) sky[c] += static_cast<float>(grid.dark[c]) * facing;
  }
  blur(sky, side_, 2);
  open_.sky /= full;
  table_.resize(sun.size());
  for (std::size_t c = 0; c < table_.size(); c++)
    table_[c] = {std::max(0.0f, open_.sun - innerShare(c, side_) * sun[c]),
                 std::max(0.0f, open_.sky - innerShare(c, side_) * sky[c] / full)};
  if (!lights.glass.empty())
    for (std::size_t c = 0; c < table_.size(); c++) table_[c].glass = lights.glass.at(pointOf(c));
  for (const SideLight& light : lights.more) addLight(light, blockedOf(light.source));
}

Vec3f FloorLight::pointOf(std::size_t cell) const {
  const auto place = [&](std::size_t i) {
    return ((static_cast<float>(i) + 0.5f) * 2 / static_cast<float>(side_) - 1) * reach_;
  };
  return origin_ + place(cell % side_) * u_ + place(cell / side_) * v_;
}

void FloorLight::addLight(const SideLight& light, const std::vector<float>& blocked) {
  const float facing = std::max(0.0f, dot(normal_, light.source.toLight));
  open_.more += facing * light.source.colour;
  for (std::size_t c = 0; c < table_.size(); c++) {
    thaw::Light here = std::max(0.0f, facing - innerShare(c, side_) * blocked[c]) * light.source.colour;
    if (!light.glass.empty()) here = product(here, light.glass.at(pointOf(c)));
    table_[c].more += here;
  }
}

FloorLight::Light FloorLight::at(const Vec3f& point) const {
  const Vec3f d = point - origin_;
  const float x = (dot(d, u_) / reach_ + 1) * 0.5f * side_ - 0.5f,
              y = (dot(d, v_) / reach_ + 1) * 0.5f * side_ - 0.5f;
  if (!(x > 0 && y > 0 && x < side_ - 1 && y < side_ - 1)) return open_;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const Light* p = &table_[static_cast<std::size_t>(j) * side_ + i];
  const auto between = [&](auto Light::*m) {
    return (1 - fy) * ((1 - fx) * p[0].*m + fx * p[1].*m) +
           fy * ((1 - fx) * p[side_].*m + fx * p[side_ + 1].*m);
  };
  return {between(&Light::sun), between(&Light::sky), between(&Light::more), between(&Light::glass)};
}

}  // namespace thaw
