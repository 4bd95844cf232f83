// SPDX-License-Identifier: Apache-2.0
// Collects the attributes of prims.
#pragma once
#include <utility>
#include <vector>

#include "io/export/export_scene.hpp"
#include "io/export/usd/usd_scene.hpp"

namespace thaw {

struct PrimMaker {
  const UsdFile& file;
  UsdPrimSample prim;
  bool isConstant = false;

  void add(UsdAttributeType type, const UsdValue& value, bool constant) {
    prim.attributes.push_back({std::move(type), file.encode(value), constant});
  }
  void add(const char* type, const char* name, const UsdValue& value, const char* interpolation = "") {
    add({name, type, interpolation, false}, value, isConstant);
  }
  void addUniform(const char* type, const char* name, const UsdValue& value) {
    add({name, type, "", true}, value, true);
  }
};

/// Returns colours in linear light, 0 to 1. from: sRGB, 0 to 255.
std::vector<Vec3f> linearColours(const std::vector<Vec3f>& from);

/// Returns the corners of the box around points, or nothing without points.
std::vector<Vec3f> extentOf(const std::vector<Vec3f>& points, float margin);

/// Returns the lines of an object's parts as curves of constant width (m; 0: none is written).
UsdPrimSample curvesPrim(const ExportObject& object, float width, const UsdFile& file);

}  // namespace thaw
