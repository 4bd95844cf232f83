// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/render_surfels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/image/parallel_for.hpp"
#include "io/render/light/backdrop.hpp"
#include "io/render/particles/glass.hpp"
#include "io/render/surfels/curved_discs.hpp"
#include "io/render/surfels/splat_faces.hpp"
#include "io/render/surfels/surfel_lights.hpp"

namespace thaw {

namespace {

constexpr Rgb plain{188, 193, 200};
// Fraction of the drawn radius: small gaps are invisible in shadows, but rims at edges are not.
constexpr float casterScale = 0.7f;

bool finite(const Vec3f& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Copies of valid surfels.
struct DrawnSurfels {
  std::vector<Vec3f> positions, normals;
  std::vector<float> radii;
  std::vector<Light> colours;
  std::vector<std::uint32_t> components;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::size_t casting = 0;            // faces that cast shadows; those of solids follow
  std::vector<std::uint8_t> corner;   // corner of a face: no disc of its own; empty without faces
  std::vector<std::uint8_t> cutAxes;  // axes, as bits, at whose sides it ends
  std::array<Vec3f, 2> sides;         // lower and upper
  /// Calls use(normal, height of the side over the centre) for each side where a surfel ends.
  template<class Use> void forCuts(std::size_t i, Use use) const {
    for (int a = 0; a < 3; a++) {
      if (!(cutAxes[i] >> a & 1)) continue;
      Vec3f normal{};
      normal[a] = 1;
      use(normal, sides[1][a] - positions[i][a]);
      use(-normal, positions[i][a] - sides[0][a]);
    }
  }
  /// Returns the radius of the part of a disc that casts shadows, which ends at the sides; below 0: none.
  float castingRadius(std::size_t i) const {
    float radius = casterScale * radii[i];
    forCuts(i, [&](const Vec3f&, float height) { radius = std::min(radius, height); });
    return radius;
  }
  bool isDisc(std::size_t i) const { return corner.empty() || !corner[i]; }
  Discs discs() const { return {positions, radii, normals}; }
};

class Painter {
 public:
  Painter(const SurfelInput& in, const RenderStyle& style, SurfelPaint paint)
      : in_(in), scale_(style.colours), paint_(paint) {
    const Palette palette = paletteOf(scale_.map);
    for (std::size_t i = 0; i < palette.size(); i++) palette_[i] = toLinear(palette[i]);
  }
  Light operator()(std::size_t i) const {
    switch (paint_) {
      case SurfelPaint::Values:
        return palette_[static_cast<std::size_t>(paletteIndex(scale_, in_.values[i]))];
      case SurfelPaint::Mixed:
        if (std::isfinite(in_.values[i]))
          return palette_[static_cast<std::size_t>(paletteIndex(scale_, in_.values[i]))];
        return decode_(in_.colours[i]);
      case SurfelPaint::Surface: return decode_(in_.colours[i]);
      case SurfelPaint::Glow: {
        if (std::isnan(in_.values[i])) return decode_(in_.colours[i]);
        const int at = paletteIndex(scale_, in_.values[i]);
        return mixed(decode_(in_.colours[i]), palette_[static_cast<std::size_t>(at)],
                     ramp(0, 1, static_cast<float>(at) / 255));
      }
      default: return plain_;
    }
  }

 private:
  const SurfelInput& in_;
  const ColourScale& scale_;
  SurfelPaint paint_;
  Decoder decode_;
  std::array<Light, 256> palette_;
  const Light plain_ = toLinear(plain);
};

DrawnSurfels drawable(const SurfelInput& in, const RenderStyle& style, const SurfelStyle& how) {
  DrawnSurfels s;
  s.sides = {single(in.sides.min), single(in.sides.min + in.sides.period)};
  constexpr std::uint32_t gone = 0xffffffffu;
  std::vector<std::uint32_t> now(in.faces.empty() ? 0 : in.positions.size(), gone);
  const Painter paint(in, style, how.paint);
  for (std::size_t i = 0; i < in.positions.size(); i++) {
    const Vec3f &x = in.positions[i], &n = in.normals[i];
    const float l2 = dot(n, n), r = how.discs * in.radii[i];
    if (!finite(x) || !finite(n) || !(l2 > 0) || !(r > 0) || !std::isfinite(r)) continue;
    if (!now.empty()) now[i] = static_cast<std::uint32_t>(s.positions.size());
    s.positions.push_back(x);
    s.normals.push_back(n / std::sqrt(l2));
    s.radii.push_back(r);
    s.colours.push_back(paint(i));
    s.cutAxes.push_back(i < in.cutAxes.size() ? in.cutAxes[i] : std::uint8_t{0});
    if (!in.components.empty()) s.components.push_back(in.components[i]);
  }
  if (!in.faces.empty()) s.corner.assign(s.positions.size(), 0);
  for (std::size_t k = 0; k < in.faces.size(); k++) {
    const auto& f = in.faces[k];
    const std::array<std::uint32_t, 3> rows{now[f[0]], now[f[1]], now[f[2]]};
    for (const std::uint32_t row : rows)
      if (row != gone) s.corner[row] = 1;
    if (std::find(rows.begin(), rows.end(), gone) != rows.end()) continue;
    s.faces.push_back(rows);
    if (k + in.solidFaces < in.faces.size()) s.casting = s.faces.size();
  }
  return s;
}

/// Shadow casters: discs, smaller than drawn, one over each face, and the triangles of solids.
struct Casters {
  std::vector<Vec3f> positions, normals;
  std::vector<float> radii;
  std::span<const std::array<Vec3f, 3>> triangles;
  Discs discs() const { return {positions, radii, normals, triangles}; }
};

Casters castersOf(const DrawnSurfels& s, std::span<const std::array<Vec3f, 3>> solids) {
  Casters all;
  all.triangles = solids;
  const auto add = [&](const Vec3f& x, const Vec3f& n, float radius) {
    all.positions.push_back(x);
    all.normals.push_back(n);
    all.radii.push_back(radius);
  };
  for (std::size_t i = 0; i < s.positions.size(); i++)
    if (const float radius = s.castingRadius(i); s.isDisc(i) && radius > 0)
      add(s.positions[i], s.normals[i], radius);
  for (const auto& f : std::span(s.faces).first(s.casting)) {
    const Vec3f &a = s.positions[f[0]], &b = s.positions[f[1]], &c = s.positions[f[2]],
                n = cross(b - a, c - a), middle = (a + b + c) / 3.0f;
    const float l2 = dot(n, n), r2 = std::max({dot(a - middle, a - middle), dot(b - middle, b - middle),
                                               dot(c - middle, c - middle)});
    if (l2 > 0) add(middle, n / std::sqrt(l2), std::sqrt(r2));
  }
  return all;
}

/// Radius factor of discs on a flat face at a sharp edge, where they are clipped. Surfels keep their distance
/// across the edge too, so a corner of a face may be 1.63 spacings from its nearest surfel.
constexpr float toCorner = 1.4f;
constexpr float flatEnough = 2.5f;  // samples: largest gap between a disc's rim and the surface

/// Discs to splat: surfels, divided where curvature would be visible.
struct SplatDiscs {
  std::vector<Vec3f> positions, normals;
  std::vector<float> radii;
  std::vector<std::uint32_t> components, of;  // `of` is the index of the surfel
  std::vector<float> whole;                   // radii of the surfels, enlarged at edges
  std::vector<std::array<DiscPart::Share, 4>> mix;
  Discs discs() const { return {positions, radii, normals}; }
};
SplatDiscs splatDiscs(const DrawnSurfels& s, const View& view) {
  const std::vector<DiscPart> parts = curvedDiscs(s.discs(), s.components, [&](std::uint32_t i) {
    if (!s.isDisc(i)) return std::numeric_limits<float>::infinity();
    const Vec3f ray = s.positions[i] - view.origin;
    const float depth = dot(ray, view.forward), away = dot(ray, s.normals[i]);
    // faces away from the camera
    if (!(depth > 0) || away > 0.5f * std::sqrt(dot(ray, ray))) return std::numeric_limits<float>::infinity();
    return flatEnough * depth / view.focal;
  });
  SplatDiscs out;
  out.whole = s.radii;
  for (const DiscPart& p : parts) {
    if (!s.isDisc(p.of)) continue;
    if (p.atEdge) out.whole[p.of] *= toCorner;
    out.positions.push_back(p.position);
    out.normals.push_back(p.normal);
    out.radii.push_back(p.atEdge ? out.whole[p.of] : p.radius);
    out.of.push_back(p.of);
    out.mix.push_back(p.mix);
    if (!s.components.empty()) out.components.push_back(s.components[p.of]);
  }
  return out;
}

/// Adds clips at the sides that a part of a disc crosses.
void addCuts(const DrawnSurfels& s, const SplatDiscs& parts, std::size_t part, std::vector<DiscClip>& to) {
  const std::uint32_t i = parts.of[part];
  s.forCuts(i, [&](const Vec3f& normal, float height) {
    const float over = height - dot(parts.positions[part] - s.positions[i], normal);
    if (over < parts.radii[part]) to.push_back({normal, over, {}, std::numeric_limits<float>::infinity()});
  });
}

/// Returns clips at the sides where surfels end, and those of undivided discs, which end at edges. Parts of
/// divided discs lie on the surface and need no clips of edges.
DiscClips clipsOfParts(const DrawnSurfels& s, const SplatDiscs& parts, std::span<const std::uint8_t> seen) {
  std::vector<std::uint8_t> wanted(s.positions.size(), 0);
  const auto whole = [&](std::size_t k) { return parts.radii[k] == parts.whole[parts.of[k]]; };
  for (std::size_t k = 0; k < seen.size(); k++)
    if (whole(k)) wanted[parts.of[k]] = seen[k];
  const DiscClips of = clipDiscs({s.positions, parts.whole, s.normals}, wanted, s.components);
  DiscClips clips;
  for (std::size_t k = 0; k < seen.size(); k++) {
    clips.first.push_back(static_cast<std::uint32_t>(clips.list.size()));
    if (whole(k))
      clips.list.insert(clips.list.end(), of.list.begin() + of.first[parts.of[k]],
                        of.list.begin() + of.first[parts.of[k] + 1]);
    if (seen[k]) addCuts(s, parts, k, clips.list);
  }
  clips.first.push_back(static_cast<std::uint32_t>(clips.list.size()));
  return clips;
}

std::vector<SurfelShade> lightSurfels(const DrawnSurfels& s, std::span<const std::uint8_t> seen,
                                      const SurfelLights& lights, const Backdrop& backdrop, int threads) {
  std::vector<SurfelShade> shades(s.positions.size());
  constexpr std::size_t piece = 4096;
  parallelFor((shades.size() + piece - 1) / piece, threads, [&](std::size_t p) {
    for (std::size_t i = p * piece; i < std::min(shades.size(), (p + 1) * piece); i++) {
      if (!seen[i]) continue;
      const Vec3f& n = s.normals[i];
      const float sky = lights.lights.ambient * skySeen(lights, backdrop, s.positions[i], n, s.radii[i]);
      const Light &c = s.colours[i], &sun = lights.lights.source.colour,
                  more = moreLight(lights.lights, s.positions[i], n, s.radii[i]);
      const Light diffuse{sunTint.x * c.x, sunTint.y * c.y, sunTint.z * c.z};
      shades[i] = {
          n,
          Light{skyTint.x * sky * c.x, skyTint.y * sky * c.y, skyTint.z * sky * c.z} +
              Light{diffuse.x * more.x, diffuse.y * more.y, diffuse.z * more.z},
          lights.lights.glass.empty()
              ? product(diffuse, sun)
              : product(product(diffuse, sun), lights.lights.glass.at(s.positions[i] + s.radii[i] * n)),
          lightSeen(lights.sun, s.positions[i], n, s.radii[i])};
    }
  });
  return shades;
}

/// Returns flags of the surfels that need light: those of visible discs and corners of visible faces.
std::vector<std::uint8_t> visibleSurfels(const DrawnSurfels& s, const SplatDiscs& parts,
                                         std::span<const std::uint8_t> seen, const CameraFaces& faces) {
  std::vector<std::uint8_t> visible(s.positions.size(), 0);
  for (std::size_t k = 0; k < seen.size(); k++)
    for (const DiscPart::Share& m : parts.mix[k]) visible[m.of] |= seen[k] && m.share > 0;
  for (const CameraFaces::Face& f : faces.faces)
    for (const std::uint32_t row : f.shade) visible[row] = 1;
  return visible;
}

/// Returns the shades of disc parts, mixed from those of the surfels.
std::vector<SurfelShade> mixedShades(const SplatDiscs& parts, const std::vector<SurfelShade>& ofSurfels) {
  std::vector<SurfelShade> shades;
  for (std::size_t k = 0; k < parts.mix.size(); k++) {
    SurfelShade s{parts.normals[k], {}, {}, 0};
    for (const DiscPart::Share& m : parts.mix[k]) {
      if (!(m.share > 0)) continue;
      s.fromSky += m.share * ofSurfels[m.of].fromSky;
      s.ofSun += m.share * ofSurfels[m.of].ofSun;
      s.sun += m.share * ofSurfels[m.of].sun;
    }
    shades.push_back(s);
  }
  return shades;
}

constexpr float noDepth = std::numeric_limits<float>::infinity();

/// Light of the samples of a picture. Positions are in samples.
struct SampleLight {
  const View& view;
  const Backdrop& backdrop;
  const LightSource& sun;

  /// Returns the light of floor and sky.
  Light behind(float x, float y) const {
    const Vec3f ray = view.ray(x, y);
    float depth = noDepth;
    const FloorLight* floor = backdrop.floorBefore(ray, depth);
    return floor ? backdrop.floorShade(*floor, ray, depth) : backdrop.sky(ray);
  }
  /// x, y: in the tile.
  Light at(const SurfelTile& tile, int x, int y) const {
    const std::size_t at = static_cast<std::size_t>(y) * tile.width + x;
    const float px = static_cast<float>(tile.x + x) + 0.5f, py = static_cast<float>(tile.y + y) + 0.5f;
    float depth = tile.depth[at];
    if (!(depth < noDepth)) return behind(px, py);
    const Vec3f ray = view.ray(px, py);
    const FloorLight* floor = backdrop.floorBefore(ray, depth);
    return floor ? backdrop.floorShade(*floor, ray, depth) : surfaceLight(tile.shade[at], ray, sun);
  }
};

/// Returns the light of the pixel of side x side samples at x, y of a tile.
Light pixelLight(const SampleLight& light, const SurfelTile& tile, int x, int y, int side) {
  bool empty = true;
  for (int j = 0; j < side; j++)
    for (int i = 0; i < side; i++)
      empty = empty && !(tile.depth[static_cast<std::size_t>(y + j) * tile.width + x + i] < noDepth);
  if (empty) {  // floor and sky are smooth: one sample is enough
    const float middle = 0.5f * static_cast<float>(side);
    return light.behind(static_cast<float>(tile.x + x) + middle, static_cast<float>(tile.y + y) + middle);
  }
  const float part = 1 / static_cast<float>(side * side);
  Light sum{};
  for (int j = 0; j < side; j++)
    for (int i = 0; i < side; i++) sum += part * light.at(tile, x + i, y + j);
  return sum;
}

/// Sums of the samples of each pixel of a picture.
struct PixelSums {
  int samples, width;  ///< samples per pixel and axis; pixels
  std::vector<Light> sums;
  void add(const SampleLight& light, const SurfelTile& tile) {
    const float part = 1 / static_cast<float>(samples * samples);
    for (int y = 0; y < tile.height; y++)
      for (int x = 0; x < tile.width; x++)
        sums[static_cast<std::size_t>((tile.y + y) / samples) * width + (tile.x + x) / samples] +=
            part * light.at(tile, x, y);
  }
};

void storeDepth(const SurfelTile& tile, DepthBuffer& buffer) {
  for (int y = 0; y < tile.height; y++)
    std::copy_n(tile.depth.begin() + static_cast<std::ptrdiff_t>(y) * tile.width, tile.width,
                buffer.depth.begin() + static_cast<std::ptrdiff_t>(tile.y + y) * buffer.width + tile.x);
}

void check(const SurfelInput& in, const RenderStyle& style, const SurfelStyle& how) {
  if (style.width < 1 || style.height < 1 || style.width > 16384 || style.height > 16384)
    throw std::invalid_argument("expected a picture 1 to 16384 pixels wide and high");
  if (style.samples < 1 || style.samples > 4)
    throw std::invalid_argument("expected 1 to 4 samples per pixel and axis");
  const std::size_t n = in.positions.size();
  if (in.normals.size() != n || in.radii.size() != n)
    throw std::invalid_argument("expected as many normals and radii as positions to draw");
  const bool values = how.paint == SurfelPaint::Values || how.paint == SurfelPaint::Glow,
             colours = how.paint == SurfelPaint::Surface || how.paint == SurfelPaint::Glow;
  if ((values || !in.values.empty()) && in.values.size() != n)
    throw std::invalid_argument("expected as many values as positions to draw");
  if ((colours || !in.colours.empty()) && in.colours.size() != n)
    throw std::invalid_argument("expected as many colours as positions to draw");
  if (!in.components.empty() && in.components.size() != n)
    throw std::invalid_argument("expected as many components as positions to draw");
  if (!(how.discs > 0)) throw std::invalid_argument("expected a disc size above 0");
}

}  // namespace

Image renderSurfels(const SurfelInput& input, const RenderStyle& style, const SurfelStyle& how) {
  check(input, style, how);
  const int s = style.samples, width = style.width * s, height = style.height * s;
  const View view = viewOf(style.camera, width, height);
  const DrawnSurfels surfels = drawable(input, style, how);
  const SplatDiscs parts = splatDiscs(surfels, view);
  const Discs discs = parts.discs();
  ViewBox stage = style.stage;
  if (stage.empty())
    for (const Vec3f& p : surfels.positions) stage.add({p.x, p.y, p.z});
  const float near = stage.empty() ? 0 : static_cast<float>(1e-4 * length(stage.max - stage.min));
  const Casters casting = castersOf(surfels, input.solids);
  const Discs casters = casting.discs();
  SurfelLights lights = makeSurfelLights(casters, lightSources(style.lighting, view), how.threads);
  lights.lights.ambient = style.lighting.ambient;
  addGlasses(style, lights.lights);
  const Backdrop backdrop(style, view, stage, lights.lights, casters);
  const std::vector<std::uint8_t> seen = facingDiscs(discs, view, width, height, near);
  const CameraFaces faces = facesBefore(surfels.positions, surfels.faces, {view, width, height}, near);
  const std::vector<SurfelShade> light = lightSurfels(surfels, visibleSurfels(surfels, parts, seen, faces),
                                                      lights, backdrop, how.threads);
  const std::vector<SurfelShade> shades = mixedShades(parts, light);
  const DiscClips clips = clipsOfParts(surfels, parts, seen);

  const Encoder encode;
  Image image(style.width, style.height);
  DepthBuffer buffer;
  buffer.width = width, buffer.height = height;
  if (!style.glasses.empty()) buffer.depth.assign(static_cast<std::size_t>(width) * height, noDepth);
  const SampleLight samples{view, backdrop, lights.lights.source};
  // Samples of a pixel lie in one tile, since SurfelTile::side is a multiple of 1, 2 and 4. With 3, tiles are
  // accumulated into a picture of sums.
  PixelSums pixels{s, style.width, std::vector<Light>(s == 3 ? image.pixels.size() : 0)};
  splatSurfels({discs, clips, shades, parts.components, faces, light}, seen, {view, width, height},
               s == 3 ? 1 : how.threads, [&](const SurfelTile& tile) {
                 if (!buffer.depth.empty()) storeDepth(tile, buffer);
                 if (s == 3) return pixels.add(samples, tile);
                 for (int y = 0; y < tile.height; y += s)
                   for (int x = 0; x < tile.width; x += s)
                     image.at((tile.x + x) / s,
                              (tile.y + y) / s) = encode(pixelLight(samples, tile, x, y, s));
               });
  for (std::size_t p = 0; p < pixels.sums.size(); p++) image.pixels[p] = encode(pixels.sums[p]);
  drawGlasses(image, style, view, buffer);
  return image;
}

}  // namespace thaw
