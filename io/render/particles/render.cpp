// SPDX-License-Identifier: Apache-2.0
#include "io/render/particles/render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/render/light/backdrop.hpp"
#include "io/render/light/lights.hpp"
#include "io/render/light/surface_normals.hpp"
#include "io/render/particles/glass.hpp"
#include "io/render/particles/splat.hpp"

namespace thaw {

namespace {

Vec3f unit(const Vec3f& a) { return a / std::sqrt(dot(a, a)); }

constexpr Rgb plain{176, 182, 190};

/// Copies of finite particles, all or some.
struct Particles {
  std::vector<Vec3f> positions;
  std::vector<float> radii;
  std::vector<std::uint8_t> colour;  ///< index into the palette
};

Particles finiteParticles(const RenderInput& in, const ColourScale& scale) {
  Particles p;
  p.positions.reserve(in.positions.size());
  const bool single = in.radii.size() == 1;
  for (std::size_t i = 0; i < in.positions.size(); i++) {
    const Vec3f& x = in.positions[i];
    const float r = single ? in.radii[0] : in.radii[i];
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z) || !(r > 0) || !std::isfinite(r))
      continue;
    p.positions.push_back(x);
    p.radii.push_back(r);
    p.colour.push_back(static_cast<std::uint8_t>(in.values.empty() ? 0 : paletteIndex(scale, in.values[i])));
  }
  return p;
}

/// Shading data of visible particles: surface normal, sky light, and the light that passes glass. The latter
/// is from the sun and from each further light, and is empty without glass.
struct Visible {
  std::vector<std::uint32_t> place;  ///< index of a particle in the lists below
  std::vector<SurfaceNormal> normals;
  std::vector<float> sky;
  std::vector<Light> glass;
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
  if (lights.glass.empty()) return v;
  for (const std::uint32_t i : which) {
    v.glass.push_back(lights.glass.at(p.positions[i]));
    for (const SideLight& light : lights.more) v.glass.push_back(light.glass.at(p.positions[i]));
  }
  return v;
}

class Shader {
 public:
  Shader(const RenderStyle& style, const View& view, const Particles& particles, const DepthBuffer& buffer,
         const ViewBox& stage, bool coloured)
      : view_(view),
        particles_(particles),
        lights_(makeLights({particles.positions, particles.radii, {}}, style, view)),
        backdrop_(style, view, stage, lights_, {particles.positions, particles.radii, {}}) {
    const float spacing = style.spacing > 0 ? style.spacing : std::max(lights_.radius / 0.65f, 1e-20f);
    visible_ = lightVisible(particles, buffer, lights_, spacing);
    const Palette palette = paletteOf(style.colours.map);
    for (std::size_t i = 0; i < palette.size(); i++) colours_[i] = toLinear(coloured ? palette[i] : plain);
  }

  /// Returns the light to the camera through a point of the picture, from sphere `index` at `depth` or from
  /// behind all spheres.
  Light operator()(float x, float y, std::uint32_t index, float depth) const {
    const Vec3f ray = view_.ray(x, y);
    float floorDepth = depth;
    const FloorLight* floor = backdrop_.floorBefore(ray, floorDepth);
    if (floor) return backdrop_.floorShade(*floor, ray, floorDepth);
    return index == DepthBuffer::none ? backdrop_.sky(ray) : sphereShade(ray, index, depth);
  }

 private:
  Light sphereShade(const Vec3f& ray, std::uint32_t index, float depth) const {
    const std::uint32_t k = visible_.place[index];
    const SurfaceNormal& surface = visible_.normals[k];
    const Vec3f point = view_.origin + depth * ray;
    const Vec3f round = (point - particles_.positions[index]) / particles_.radii[index];
    Vec3f normal = mixed(round, surface.normal, 0.78f * surface.strength);
    const float l2 = dot(normal, normal);
    normal = l2 > 1e-12f ? normal / std::sqrt(l2) : -unit(ray);
    const float sun = directLight(lights_.sun, lights_.radius, point, normal, 2),
                fromSky = lights_.ambient * visible_.sky[k] *
                          (0.8f + 0.2f * std::max(0.0f, dot(normal, round)));
    const Vec3f half = unit(lights_.sun.toLight - unit(ray));
    const float shine = sun > 0 ? 0.09f * std::pow(std::max(0.0f, dot(normal, half)), 40.0f) : 0.0f;
    const Light colour = colours_[particles_.colour[index]];
    const Light tint{0.52f * fromSky, 0.54f * fromSky, 0.58f * fromSky};
    const auto behindGlass = [&](std::size_t light, const Light& l) {
      return visible_.glass.empty() ? l : product(l, visible_.glass[k * (1 + lights_.more.size()) + light]);
    };
    Light direct = behindGlass(0, sun * lights_.source.colour);
    for (std::size_t m = 0; m < lights_.more.size(); m++) {
      const SideLight& light = lights_.more[m];
      const float seen = directLight(light.maps[0], lights_.radius, point, normal, 2);
      direct += behindGlass(m + 1, seen * light.source.colour);
    }
    return Light{colour.x * (tint.x + 0.88f * direct.x), colour.y * (tint.y + 0.86f * direct.y),
                 colour.z * (tint.z + 0.82f * direct.z)} +
           shine * lights_.source.colour;
  }

  const View& view_;
  const Particles& particles_;
  Lights lights_;
  Visible visible_;
  std::array<Light, 256> colours_;
  Backdrop backdrop_;
};

void check(const RenderInput& input, const RenderStyle& style) {
  if (style.width < 1 || style.height < 1 || style.width > 16384 || style.height > 16384)
    throw std::invalid_argument("expected a picture 1 to 16384 pixels wide and high");
  if (style.samples < 1 || style.samples > 4)
    throw std::invalid_argument("expected 1 to 4 samples per pixel and axis");
  if (!input.values.empty() && input.values.size() != input.positions.size())
    throw std::invalid_argument("expected as many values as positions to draw");
  if (input.radii.size() != 1 && input.radii.size() != input.positions.size())
    throw std::invalid_argument("expected one radius, or as many as positions to draw");
}

}  // namespace

Image render(const RenderInput& input, const RenderStyle& style) {
  check(input, style);
  const int s = style.samples;
  const View view = viewOf(style.camera, style.width * s, style.height * s);
  const Particles particles = finiteParticles(input, style.colours);
  ViewBox stage = style.stage;
  if (stage.empty())
    for (const Vec3f& p : particles.positions) stage.add({p.x, p.y, p.z});
  const float near = stage.empty() ? 0 : static_cast<float>(1e-4 * length(stage.max - stage.min));
  const DepthBuffer buffer = splatSpheres({particles.positions, particles.radii, {}}, view, style.width * s,
                                          style.height * s, near);
  const Shader shade(style, view, particles, buffer, stage, !input.values.empty());
  const Encoder encode;
  Image image(style.width, style.height);
  const float part = 1 / static_cast<float>(s * s);
  for (int y = 0; y < style.height; y++)
    for (int x = 0; x < style.width; x++) {
      const std::size_t corner = static_cast<std::size_t>(y) * s * buffer.width +
                                 static_cast<std::size_t>(x) * s;
      bool empty = true;
      for (int j = 0; j < s; j++)
        for (int i = 0; i < s; i++)
          empty = empty &&
                  buffer.index[corner + static_cast<std::size_t>(j) * buffer.width + i] == DepthBuffer::none;
      Light sum{};
      if (empty) {  // floor and sky are smooth: one sample is enough
        sum = shade(static_cast<float>(s) * (static_cast<float>(x) + 0.5f),
                    static_cast<float>(s) * (static_cast<float>(y) + 0.5f), DepthBuffer::none,
                    std::numeric_limits<float>::infinity());
      } else {
        for (int j = 0; j < s; j++)
          for (int i = 0; i < s; i++) {
            const std::size_t at = corner + static_cast<std::size_t>(j) * buffer.width + i;
            sum += part * shade(static_cast<float>(x * s + i) + 0.5f, static_cast<float>(y * s + j) + 0.5f,
                                buffer.index[at], buffer.depth[at]);
          }
      }
      image.at(x, y) = encode(sum);
    }
  drawGlasses(image, style, view, buffer);
  return image;
}

}  // namespace thaw
