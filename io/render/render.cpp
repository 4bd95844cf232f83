#include "io/render/render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/render/glass.hpp"
#include "io/render/lights.hpp"
#include "io/render/splat.hpp"
#include "io/render/surface_normals.hpp"

namespace thaw {

namespace {

using Light = Vec3f;  // linear red, green, blue; 1 is white

float ramp(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}
Vec3f unit(const Vec3f& a) { return a / std::sqrt(dot(a, a)); }
Light mixed(const Light& a, const Light& b, float t) { return (1 - t) * a + t * b; }

float decoded(std::uint8_t c) {
  const float x = static_cast<float>(c) / 255;
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}
Light toLinear(Rgb c) { return {decoded(c.r), decoded(c.g), decoded(c.b)}; }

/// sRGB bytes by table.
class Encoder {
 public:
  Encoder() {
    for (std::size_t i = 0; i < table_.size(); i++) {
      const double x = static_cast<double>(i) / (table_.size() - 1);
      table_[i] = static_cast<std::uint8_t>(std::lround(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055)));
    }
  }
  Rgb operator()(const Light& l) const { return {byte(l.x), byte(l.y), byte(l.z)}; }

 private:
  std::uint8_t byte(float x) const { return table_[static_cast<std::size_t>(std::clamp(x, 0.0f, 1.0f) * static_cast<float>(table_.size() - 1) + 0.5f)]; }
  std::array<std::uint8_t, 8192> table_;
};

constexpr Rgb skyTop{232, 236, 241}, skyLow{205, 211, 218}, floorColour{206, 206, 204}, plain{176, 182, 190};

/// Copies of what is finite, for all particles or only some.
struct Particles {
  std::vector<Vec3f> positions;
  std::vector<float> radii;
  std::vector<std::uint8_t> colour;  ///< index into the palette
};

Particles finiteOnes(const RenderInput& in, const ColourScale& scale) {
  Particles p;
  p.positions.reserve(in.positions.size());
  const bool single = in.radii.size() == 1;
  for (std::size_t i = 0; i < in.positions.size(); i++) {
    const Vec3f& x = in.positions[i];
    const float r = single ? in.radii[0] : in.radii[i];
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z) || !(r > 0) || !std::isfinite(r)) continue;
    p.positions.push_back(x);
    p.radii.push_back(r);
    p.colour.push_back(static_cast<std::uint8_t>(in.values.empty() ? 0 : paletteIndex(scale, in.values[i])));
  }
  return p;
}

/// What only particles that show need: the surface's normal there and the light of the sky.
struct Visible {
  std::vector<std::uint32_t> place;  ///< of a particle in the lists below
  std::vector<SurfaceNormal> normals;
  std::vector<float> sky;
};

Visible lightVisible(const Particles& p, const DepthBuffer& buffer, const Lights& lights, float spacing) {
  std::vector<std::uint8_t> seen(p.positions.size(), 0);
  for (std::uint32_t i : buffer.index)
    if (i != DepthBuffer::none) seen[i] = 1;
  std::vector<std::uint32_t> which;
  Visible v;
  v.place.assign(p.positions.size(), 0);
  for (std::size_t i = 0; i < seen.size(); i++)
    if (seen[i]) {
      v.place[i] = static_cast<std::uint32_t>(which.size());
      which.push_back(static_cast<std::uint32_t>(i));
    }
  const CellBins bins = binParticles(p.positions, 2.6f * spacing);
  Smoothed raw{surfaceNormals(p.positions, which, bins), std::vector<float>(which.size())};
  for (std::size_t k = 0; k < which.size(); k++) {
    const SurfaceNormal& n = raw.normals[k];
    raw.values[k] = skyLight(lights, p.positions[which[k]], n.strength > 0 ? n.normal : Vec3f{0, 0, 1});
  }
  Smoothed smooth = smoothOver(p.positions, which, bins, raw);
  v.normals = std::move(smooth.normals);
  v.sky = std::move(smooth.values);
  return v;
}

class Shader {
 public:
  Shader(const RenderStyle& style, const View& view, const Particles& particles, const DepthBuffer& buffer, const ViewBox& stage, bool coloured)
      : view_(view), particles_(particles), lights_(makeLights({particles.positions, particles.radii}, view)) {
    const float spacing = style.spacing > 0 ? style.spacing : std::max(lights_.radius / 0.65f, 1e-20f);
    visible_ = lightVisible(particles, buffer, lights_, spacing);
    const Palette palette = paletteOf(style.colours.map);
    for (std::size_t i = 0; i < palette.size(); i++) colours_[i] = toLinear(coloured ? palette[i] : plain);
    const Vec3d c = stage.empty() ? Vec3d{} : stage.centre();
    centre_ = {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
    reach_ = stage.empty() ? 1 : std::max(static_cast<float>(0.5 * length(stage.max - stage.min)), 1e-6f);
    for (const FloorHint& floor : style.floors) {
      const Vec3d from{view.origin.x, view.origin.y, view.origin.z};
      if (dot(from - floor.point, floor.normal) > 0) floors_.emplace_back(lights_, floor, centre_, 2.2f * reach_);
    }
  }

  /// Light that reaches the camera through a point of the depth buffer's picture, from sphere `index` at `depth` or from behind all of them.
  Light operator()(float x, float y, std::uint32_t index, float depth) const {
    const Vec3f ray = view_.ray(x, y);
    float floorDepth = depth;
    const FloorLight* floor = nullptr;
    for (const FloorLight& f : floors_) {
      const float down = -dot(ray, f.normal());
      if (down <= 1e-6f) continue;
      const float t = dot(view_.origin - f.origin(), f.normal()) / down;
      if (t < floorDepth) floorDepth = t, floor = &f;
    }
    if (floor) return floorShade(*floor, ray, floorDepth);
    return index == DepthBuffer::none ? sky(ray) : sphereShade(ray, index, depth);
  }

 private:
  Light sky(const Vec3f& ray) const {
    const float up = ray.z / std::sqrt(dot(ray, ray));
    return mixed(low_, top_, ramp(-0.05f, 0.55f, up));
  }

  Light floorShade(const FloorLight& floor, const Vec3f& ray, float depth) const {
    const Vec3f point = view_.origin + depth * ray, d = point - floor.origin();
    const float far = std::sqrt(dot(d, d)) / reach_;
    const FloorLight::Light l = floor.at(point);
    const float bright = 0.62f * l.sun + 0.46f * l.sky;
    return mixed(bright * floor_, sky(ray), ramp(2.0f, 7.0f, far));
  }

  Light sphereShade(const Vec3f& ray, std::uint32_t index, float depth) const {
    const std::uint32_t k = visible_.place[index];
    const SurfaceNormal& surface = visible_.normals[k];
    const Vec3f point = view_.origin + depth * ray;
    const Vec3f round = (point - particles_.positions[index]) / particles_.radii[index];
    Vec3f normal = mixed(round, surface.normal, 0.78f * surface.strength);
    const float l2 = dot(normal, normal);
    normal = l2 > 1e-12f ? normal / std::sqrt(l2) : -unit(ray);
    const float sun = sunLight(lights_, point, normal, 2), fromSky = visible_.sky[k] * (0.8f + 0.2f * std::max(0.0f, dot(normal, round)));
    const Vec3f half = unit(lights_.sun.toLight - unit(ray));
    const float shine = sun > 0 ? 0.09f * std::pow(std::max(0.0f, dot(normal, half)), 40.0f) : 0.0f;
    const Light colour = colours_[particles_.colour[index]];
    const Light tint{0.52f * fromSky, 0.54f * fromSky, 0.58f * fromSky};
    const Light white{shine, shine, shine};
    return Light{colour.x * (tint.x + 0.88f * sun), colour.y * (tint.y + 0.86f * sun), colour.z * (tint.z + 0.82f * sun)} + white;
  }

  const View& view_;
  const Particles& particles_;
  Lights lights_;
  Visible visible_;
  std::array<Light, 256> colours_;
  Vec3f centre_;
  float reach_ = 1;
  std::vector<FloorLight> floors_;
  const Light top_ = toLinear(skyTop), low_ = toLinear(skyLow), floor_ = toLinear(floorColour);
};

void check(const RenderInput& input, const RenderStyle& style) {
  if (style.width < 1 || style.height < 1 || style.width > 16384 || style.height > 16384) throw std::invalid_argument("a picture is 1 to 16384 pixels wide and high");
  if (style.samples < 1 || style.samples > 4) throw std::invalid_argument("a picture has 1 to 4 samples a pixel and axis");
  if (!input.values.empty() && input.values.size() != input.positions.size()) throw std::invalid_argument("values to draw differ in number from the positions");
  if (input.radii.size() != 1 && input.radii.size() != input.positions.size()) throw std::invalid_argument("radii to draw are neither one nor as many as the positions");
}

}  // namespace

Image render(const RenderInput& input, const RenderStyle& style) {
  check(input, style);
  const int s = style.samples;
  const View view = viewOf(style.camera, style.width * s, style.height * s);
  const Particles particles = finiteOnes(input, style.colours);
  ViewBox stage = style.stage;
  if (stage.empty())
    for (const Vec3f& p : particles.positions) stage.add({p.x, p.y, p.z});
  const float near = stage.empty() ? 0 : static_cast<float>(1e-4 * length(stage.max - stage.min));
  const DepthBuffer buffer = splatSpheres({particles.positions, particles.radii}, view, style.width * s, style.height * s, near);
  const Shader shade(style, view, particles, buffer, stage, !input.values.empty());
  const Encoder encode;
  Image image(style.width, style.height);
  const float part = 1 / static_cast<float>(s * s);
  for (int y = 0; y < style.height; y++)
    for (int x = 0; x < style.width; x++) {
      const std::size_t corner = static_cast<std::size_t>(y) * s * buffer.width + static_cast<std::size_t>(x) * s;
      bool empty = true;
      for (int j = 0; j < s; j++)
        for (int i = 0; i < s; i++) empty = empty && buffer.index[corner + static_cast<std::size_t>(j) * buffer.width + i] == DepthBuffer::none;
      Light sum{};
      if (empty) {  // floor and sky are smooth: one sample will do
        sum = shade(static_cast<float>(s) * (static_cast<float>(x) + 0.5f), static_cast<float>(s) * (static_cast<float>(y) + 0.5f), DepthBuffer::none,
                    std::numeric_limits<float>::infinity());
      } else {
        for (int j = 0; j < s; j++)
          for (int i = 0; i < s; i++) {
            const std::size_t at = corner + static_cast<std::size_t>(j) * buffer.width + i;
            sum += part * shade(static_cast<float>(x * s + i) + 0.5f, static_cast<float>(y * s + j) + 0.5f, buffer.index[at], buffer.depth[at]);
          }
      }
      image.at(x, y) = encode(sum);
    }
  drawGlasses(image, style, view, buffer);
  return image;
}

}  // namespace thaw
