// SPDX-License-Identifier: Apache-2.0
#include "io/export/polylines.hpp"
#include "io/export/usd/prim_maker.hpp"

namespace thaw {

namespace {

/// Points of curves with their fields.
struct CurvePoints {
  std::vector<Vec3f> places, velocities, colours;
  std::vector<std::int32_t> counts;

  void add(const ComponentMesh& part) {
    for (const std::vector<std::uint32_t>& run : polylinesOf(part.lines)) {
      counts.push_back(static_cast<std::int32_t>(run.size()));
      for (const std::uint32_t v : run) {
        places.push_back(single(part.mesh.vertices[v]));
        if (!part.velocities.empty()) velocities.push_back(part.velocities[v]);
        if (!part.colours.empty()) colours.push_back(part.colours[v]);
      }
    }
  }
};

}  // namespace

UsdPrimSample curvesPrim(const ExportObject& object, float width, const UsdFile& file) {
  CurvePoints curves;
  for (const ComponentMesh& part : object.parts) curves.add(part);
  PrimMaker maker{file, {usdName(object.name) + "_curves", "BasisCurves", {}}, false};
  maker.addUniform("token", "type", UsdToken{"linear"});
  maker.addUniform("token", "wrap", UsdToken{"nonperiodic"});
  maker.add("float3[]", "extent", extentOf(curves.places, 0.5f * width));
  maker.add("point3f[]", "points", curves.places);
  maker.add("int[]", "curveVertexCounts", curves.counts);
  if (width > 0) maker.add({"widths", "float[]", "constant", false}, std::vector<float>{width}, true);
  if (curves.velocities.size() == curves.places.size())
    maker.add("vector3f[]", "velocities", curves.velocities);
  if (curves.colours.size() == curves.places.size())
    maker.add("color3f[]", "primvars:displayColor", linearColours(curves.colours), "vertex");
  return std::move(maker.prim);
}

}  // namespace thaw
