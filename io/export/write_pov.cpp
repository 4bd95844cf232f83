// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/export/export_surface.hpp"
#include "io/export/out_file.hpp"
#include "io/render/light/lights.hpp"

namespace thaw {

namespace {

std::string vector(const Vec3d& a) { return fmt::format("<{:.7g},{:.7g},{:.7g}>", a.x, a.y, a.z); }
std::string colour(Rgb c) {
  return fmt::format("srgb <{:.4g},{:.4g},{:.4g}>", c.r / 255.0, c.g / 255.0, c.b / 255.0);
}

}  // namespace

void writePov(const std::filesystem::path& file, const SurfaceFrame& frame, const std::vector<Rgb>& colours,
              const RenderStyle& style, double discs) {
  ViewBox stage = style.stage;
  if (stage.empty())
    for (const Vec3d& x : frame.positions) stage.add(x);
  const double across = stage.empty() ? 1 : std::max(1e-12, length(stage.max - stage.min)),
               scale = 10 / across;
  const Vec3d middle = stage.empty() ? Vec3d{} : stage.centre();
  const auto placed = [&](const Vec3d& x) { return scale * (x - middle); };
  const View view = viewOf(style.camera, style.width, style.height);
  const double tall = 2 * std::tan(0.5 * style.camera.fieldOfView), broad = tall * style.width / style.height;
  OutFile out(file);
  out.text(
      fmt::format("// Surfels of thaw, t = {} s. povray +W{} +H{} +A0.2 {}\n#version 3.7;\nglobal_settings "
                  "{{ assumed_gamma 1.0 }}\n",
                  frame.time, style.width, style.height, file.filename().string()));
  out.text(fmt::format("// {:.7g} units are a metre; the origin is {} m\n", scale, vector(middle)));
  out.text(fmt::format("camera {{ perspective location {} right {} up {} direction {} }}\n",
                       vector(placed(style.camera.from)), vector(broad * wide(view.right)),
                       vector(tall * wide(view.up)), vector(wide(view.forward))));
  const Rgb sky = style.lighting.background.value_or(Rgb{209, 217, 224});
  out.text(fmt::format("background {{ srgb <{:.2f},{:.2f},{:.2f}> }}\n", sky.r / 255.0, sky.g / 255.0,
                       sky.b / 255.0));
  for (const LightSource& light : lightSources(style.lighting, view)) {
    const double width = 12 * light.radius / 0.07f;
    out.text(fmt::format(
        "light_source {{ {} rgb {} area_light {} {} 5, 5 adaptive 1 circular orient jitter parallel point_at "
        "<0,0,0> }}\n",
        vector(100.0 * wide(light.toLight)), vector(0.95 * wide(light.colour)),
        vector(width * wide(view.right)), vector(width * wide(view.up))));
  }
  out.text(fmt::format("light_source {{ {} rgb 0.25 shadowless parallel point_at <0,0,0> }}\n",
                       vector(100.0 * (wide(view.up) - wide(view.forward)))));
  for (const FloorHint& f : style.floors)
    out.text(fmt::format(
        "plane {{ {}, {:.7g} pigment {{ srgb <0.81,0.81,0.80> }} finish {{ ambient 0.3 diffuse 0.6 }} }}\n",
        vector(f.normal), dot(f.normal, placed(f.point))));
  out.text("#default { finish { ambient 0.25 diffuse 0.75 specular 0.12 roughness 0.02 } }\nunion {\n");
  for (std::size_t i = 0; i < frame.positions.size(); i++)
    out.text(fmt::format("disc{{{},{},{:.5g} pigment{{{}}}}}\n", vector(placed(frame.positions[i])),
                         vector(wide(frame.normals[i])), scale * discs * frame.radii[i], colour(colours[i])));
  out.text("}\n");
  out.finish();
}

}  // namespace thaw
