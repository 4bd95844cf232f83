// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/basic/extension_shape.hpp"

#include <map>
#include <utility>

namespace thaw {
namespace {

std::map<std::string, ShapeMaker>& knownShapes() {
  static std::map<std::string, ShapeMaker> all;
  return all;
}

}  // namespace

void addExtensionShape(const std::string& name, ShapeMaker make) {
  knownShapes().emplace(name, std::move(make));
}

const ShapeMaker* findExtensionShape(const std::string& name) {
  const auto at = knownShapes().find(name);
  return at == knownShapes().end() ? nullptr : &at->second;
}

}  // namespace thaw
