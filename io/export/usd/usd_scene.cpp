// SPDX-License-Identifier: Apache-2.0
#include "io/export/usd/usd_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "io/export/texture_seams.hpp"
#include "io/export/usd/prim_maker.hpp"
#include "io/render/light/lights.hpp"

namespace thaw {

namespace {

const UsdAttributeType visibilityType{"visibility", "token", "", false};

/// Returns a colour in linear light, 0 to 1. from: sRGB, 0 to 255.
Vec3f linearColour(const Vec3f& from) {
  Vec3f to;
  for (int c = 0; c < 3; c++) {
    const float v = std::clamp(from[c] / 255, 0.0f, 1.0f);
    to[c] = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
  }
  return to;
}

/// All parts of an object as one mesh.
struct WholeMesh {
  std::vector<Vec3f> points, normals, velocities, colours;
  std::vector<float> temperatures, liquid;
  std::vector<std::int32_t> corners, components;
  std::vector<Vec2f> cornerTexture;  // one for each corner

  explicit WholeMesh(const ExportObject& object) {
    std::int32_t number = 0;
    for (const ComponentMesh& part : object.parts) {
      const auto first = static_cast<std::int32_t>(points.size());
      for (const Vec3d& x : part.mesh.vertices) points.push_back(single(x));
      for (const auto& t : part.mesh.triangles)
        for (const std::uint32_t v : t) corners.push_back(first + static_cast<std::int32_t>(v));
      components.insert(components.end(), part.mesh.triangles.size(), number++);
      append(part.normals, normals);
      append(part.velocities, velocities);
      append(part.colours, colours);
      append(part.temperatures, temperatures);
      append(part.liquid, liquid);
      if (part.uvs.size() == part.mesh.vertices.size())
        for (const auto& triangle : cornerUvs(part.mesh, part.uvs))
          cornerTexture.insert(cornerTexture.end(), triangle.begin(), triangle.end());
    }
  }
  template<class T> static void append(const std::vector<T>& from, std::vector<T>& to) {
    to.insert(to.end(), from.begin(), from.end());
  }
  /// Fields that some parts lack are left out.
  template<class T> bool has(const std::vector<T>& field) const { return field.size() == points.size(); }
};

UsdMatrix matrixOf(const Pose& pose) {
  UsdMatrix m{};
  for (std::size_t c = 0; c < 3; c++) {
    const int axis = static_cast<int>(c);
    for (std::size_t r = 0; r < 3; r++) m[4 * c + r] = pose.rotation.row[r][axis];
    m[12 + c] = pose.move[axis];
  }
  m[15] = 1;
  return m;
}

void addTransform(PrimMaker& maker, const UsdMatrix& matrix, bool moves) {
  maker.add({"xformOp:transform", "matrix4d", "", false}, matrix, !moves);
  maker.addUniform("token[]", "xformOpOrder", std::vector<UsdToken>{{"xformOp:transform"}});
}

UsdPrimSample meshPrim(const ExportObject& object, const UsdFile& file) {
  const WholeMesh mesh(object);
  PrimMaker maker{file, {usdName(object.name), "Mesh", {}}, object.pose.has_value()};
  maker.add("float3[]", "extent", extentOf(mesh.points, 0));
  maker.add("point3f[]", "points", mesh.points);
  maker.add("int[]", "faceVertexCounts", std::vector<std::int32_t>(mesh.corners.size() / 3, 3));
  maker.add("int[]", "faceVertexIndices", mesh.corners);
  if (mesh.has(mesh.normals)) maker.add("normal3f[]", "normals", mesh.normals, "vertex");
  if (mesh.has(mesh.velocities)) maker.add("vector3f[]", "velocities", mesh.velocities);
  if (mesh.has(mesh.colours))
    maker.add("color3f[]", "primvars:displayColor", linearColours(mesh.colours), "vertex");
  if (object.opacity < 1)
    maker.add("float[]", "primvars:displayOpacity", std::vector<float>{object.opacity}, "constant");
  if (mesh.has(mesh.temperatures)) maker.add("float[]", "primvars:temperature", mesh.temperatures, "vertex");
  if (mesh.has(mesh.liquid)) maker.add("float[]", "primvars:liquid", mesh.liquid, "vertex");
  if (!mesh.corners.empty() && mesh.cornerTexture.size() == mesh.corners.size())
    maker.add("texCoord2f[]", "primvars:st", mesh.cornerTexture, "faceVarying");
  if (object.kind == ExportKind::Surface)
    maker.add("int[]", "primvars:component", mesh.components, "uniform");
  maker.addUniform("token", "subdivisionScheme", UsdToken{"none"});
  if (object.kind == ExportKind::Sheet || object.kind == ExportKind::Oriented)
    maker.addUniform("bool", "doubleSided", true);
  if (object.pose && object.moves) addTransform(maker, matrixOf(*object.pose), true);
  return std::move(maker.prim);
}

UsdPrimSample pointsPrim(const ExportPoints& points, const UsdFile& file) {
  PrimMaker maker{file, {usdName(points.name), "Points", {}}, false};
  maker.add("float3[]", "extent", extentOf(points.positions, 0.5f * points.width));
  maker.add("point3f[]", "points", points.positions);
  if (points.widths) maker.add("float[]", "widths", *points.widths, "vertex");
  else maker.add({"widths", "float[]", "constant", false}, std::vector<float>{points.width}, true);
  if (!points.ids.empty())
    maker.add("int64[]", "ids", std::vector<std::int64_t>(points.ids.begin(), points.ids.end()));
  if (!points.velocities.empty()) maker.add("vector3f[]", "velocities", points.velocities);
  if (!points.colours.empty())
    maker.add("color3f[]", "primvars:displayColor", linearColours(points.colours), "vertex");
  if (!points.temperatures.empty())
    maker.add("float[]", "primvars:temperature", points.temperatures, "vertex");
  if (!points.liquid.empty()) maker.add("float[]", "primvars:liquid", points.liquid, "vertex");
  return std::move(maker.prim);
}

/// Adds the background of pictures. USD has no schema for it, so importers show it as user properties.
void addBackground(const Lighting& lighting, PrimMaker& maker) {
  const auto add = [&](const char* name, const std::optional<Rgb>& c) {
    if (!c) return;
    const Vec3f colour{static_cast<float>(c->r), static_cast<float>(c->g), static_cast<float>(c->b)};
    maker.add({name, "color3f", "", false, true}, linearColour(colour), true);
  };
  add("userProperties:background", lighting.background);
  add("userProperties:background_top", lighting.backgroundTop);
}

UsdPrimSample cameraPrim(const RenderStyle& style, const UsdFile& file) {
  const View view = viewOf(style.camera, style.width, style.height);
  const Vec3f back = -view.forward;
  const Vec3d& from = style.camera.from;
  PrimMaker maker{file, {"camera", "Camera", {}}, true};
  const double focal = 50, tall = 2 * focal * std::tan(0.5 * style.camera.fieldOfView);  // mm
  const double away = length(style.camera.at - from);
  maker.add("float", "focalLength", static_cast<float>(focal));
  maker.add("float", "verticalAperture", static_cast<float>(tall));
  maker.add("float", "horizontalAperture", static_cast<float>(tall * style.width / style.height));
  maker.add("float2", "clippingRange",
            Vec2f{static_cast<float>(1e-3 * away), static_cast<float>(1e3 * away)});
  addBackground(style.lighting, maker);
  addTransform(maker,
               {view.right.x, view.right.y, view.right.z, 0, view.up.x, view.up.y, view.up.z, 0, back.x,
                back.y, back.z, 0, from.x, from.y, from.z, 1},
               false);
  return std::move(maker.prim);
}

/// Adds a light of this radiance or irradiance as a colour, whose largest component is 1, and an intensity.
void addIntensity(PrimMaker& maker, const Light& light) {
  const float most = std::max({light.x, light.y, light.z});
  maker.add("color3f", "inputs:color", most > 0 ? light / most : Light{1, 1, 1});
  maker.add("float", "inputs:intensity", most);
}

/// Returns a light that shines along its -z axis. White surfaces that reflect diffusely are then as bright as
/// in pictures: the irradiance is pi times their radiance.
UsdPrimSample lightPrim(const LightSource& source, const UsdFile& file) {
  PrimMaker maker{file, {"light", "DistantLight", {}}, true};
  const Light& c = source.colour;
  addIntensity(
      maker, static_cast<float>(std::numbers::pi) * Light{sunTint.x * c.x, sunTint.y * c.y, sunTint.z * c.z});
  maker.add("bool", "inputs:normalize", true);  // the intensity is an irradiance
  maker.add("float", "inputs:angle", static_cast<float>(2 * source.radius * 180 / std::numbers::pi));
  const Vec3d z = normalized(wide(source.toLight)),
              x = normalized(cross(std::abs(z.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}, z)),
              y = cross(z, x);
  addTransform(maker, {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1}, false);
  return std::move(maker.prim);
}

void addLights(const RenderStyle& style, const UsdFile& file, std::vector<UsdPrimSample>& prims) {
  const View view = viewOf(style.camera, style.width, style.height);
  for (const LightSource& source : lightSources(style.lighting, view))
    prims.push_back(lightPrim(source, file));
  if (!(style.lighting.ambient > 0)) return;
  PrimMaker sky{file, {"sky", "DomeLight", {}}, true};
  addIntensity(sky, style.lighting.ambient * skyTint);
  prims.push_back(std::move(sky.prim));
}

/// Adds the mesh of an object, and its lines as curves.
void addObject(const ExportObject& object, double spacing, const UsdFile& file,
               std::vector<UsdPrimSample>& prims) {
  const auto isCurve = [](const ComponentMesh& part) { return !part.lines.empty(); };
  const auto curves = std::count_if(object.parts.begin(), object.parts.end(), isCurve);
  if (curves == 0) return prims.push_back(meshPrim(object, file));
  ExportObject rest = object;
  std::erase_if(rest.parts, isCurve);
  if (!rest.parts.empty()) prims.push_back(meshPrim(rest, file));
  prims.push_back(curvesPrim(object, static_cast<float>(spacing), file));
}

/// Gives prims different names.
void separateNames(std::vector<UsdPrimSample>& prims) {
  std::set<std::string> used;
  for (UsdPrimSample& p : prims) {
    const std::string name = p.name;
    for (int k = 2; !used.insert(p.name).second; k++) p.name = name + "_" + std::to_string(k);
  }
}

}  // namespace

std::vector<Vec3f> linearColours(const std::vector<Vec3f>& from) {
  std::vector<Vec3f> to(from.size());
  std::transform(from.begin(), from.end(), to.begin(), linearColour);
  return to;
}

std::vector<Vec3f> extentOf(const std::vector<Vec3f>& points, float margin) {
  if (points.empty()) return {};
  Vec3f low = points[0], high = points[0];
  for (const Vec3f& x : points)
    for (int a = 0; a < 3; a++) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  for (int a = 0; a < 3; a++) low[a] -= margin, high[a] += margin;
  return {low, high};
}

UsdFrame usdFrameOf(const ExportScene& scene, const UsdFile& file) {
  UsdFrame frame{scene.time, {}};
  frame.prims.push_back(cameraPrim(scene.style, file));
  addLights(scene.style, file, frame.prims);
  for (const ExportObject& object : scene.objects) addObject(object, scene.spacing, file, frame.prims);
  if (scene.points) frame.prims.push_back(pointsPrim(*scene.points, file));
  separateNames(frame.prims);
  return frame;
}

UsdSequence::UsdSequence(std::unique_ptr<UsdFile> file, const std::string& name, double interval)
    : file_(std::move(file)) {
  layer_.root = {usdName(name), "Xform", {}, {}};
  layer_.timeCodesPerSecond = interval > 0 ? 1 / interval : 24;
  const double whole = std::round(layer_.timeCodesPerSecond);
  if (std::abs(layer_.timeCodesPerSecond - whole) < 1e-6 * whole) layer_.timeCodesPerSecond = whole;
}

UsdPrim& UsdSequence::primOf(const UsdPrimSample& sample) {
  for (UsdPrim& prim : layer_.root.children)
    if (prim.name == sample.name) return prim;
  return layer_.root.children.emplace_back(UsdPrim{sample.name, sample.type, {}, {}});
}

void UsdSequence::add(const UsdFrame& frame) {
  const double code = std::round(1e4 * frame.time * layer_.timeCodesPerSecond) / 1e4;
  times_.push_back(code);
  for (const UsdPrimSample& sample : frame.prims) {
    UsdPrim& prim = primOf(sample);
    std::vector<bool>& present = present_[sample.name];
    present.resize(times_.size(), false);
    present.back() = true;
    for (const UsdSample& s : sample.attributes) {
      const auto same = std::find_if(prim.attributes.begin(), prim.attributes.end(),
                                     [&](const UsdAttribute& a) { return a.type.name == s.type.name; });
      UsdAttribute& a = same != prim.attributes.end()
                            ? *same
                            : prim.attributes.emplace_back(UsdAttribute{s.type, {}, {}});
      if (!s.isConstant) a.samples.emplace_back(code, file_->store(s.value));
      else if (!a.value) a.value = file_->store(s.value);
    }
  }
}

/// Hides prims in the frames that lack them.
void UsdSequence::addVisibility() {
  for (UsdPrim& prim : layer_.root.children) {
    std::vector<bool>& present = present_[prim.name];
    present.resize(times_.size(), false);
    if (std::find(present.begin(), present.end(), false) == present.end()) continue;
    UsdAttribute visibility{visibilityType, {}, {}};
    for (std::size_t k = 0; k < times_.size(); k++) {
      if (k > 0 && present[k] == present[k - 1]) continue;
      const UsdToken token{present[k] ? "inherited" : "invisible"};
      visibility.samples.emplace_back(times_[k], file_->store(file_->encode(token)));
    }
    prim.attributes.push_back(std::move(visibility));
  }
}

void UsdSequence::finish(const std::string& comment) {
  addVisibility();
  layer_.comment = comment;
  if (!times_.empty()) layer_.start = times_.front(), layer_.end = times_.back();
  file_->finish(layer_);
}

}  // namespace thaw
