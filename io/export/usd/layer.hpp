// SPDX-License-Identifier: Apache-2.0
// A USD layer: prims with attributes whose values are stored in its file. Text (.usda) and crate (.usdc)
// files share this structure.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct UsdToken {
  std::string text;
};

using Vec2f = std::array<float, 2>;
/// Rows of a matrix that multiplies row vectors.
using UsdMatrix = std::array<double, 16>;

using UsdValue = std::variant<bool, float, double, UsdToken, std::string, Vec2f, Vec3f, UsdMatrix,
                              std::vector<UsdToken>, std::vector<std::int32_t>, std::vector<std::int64_t>,
                              std::vector<float>, std::vector<Vec3f>, std::vector<Vec2f>>;

/// A value as the bytes that a file stores. rep: what the file needs to refer to it.
struct UsdBytes {
  std::vector<char> bytes;
  std::uint64_t rep = 0;
  bool isInlined = false;  ///< rep holds the value; nothing is stored
};

/// Position of a stored value, in the units of its file.
using UsdPlace = std::uint64_t;

struct UsdAttributeType {
  std::string name, type;     ///< "primvars:displayColor", "color3f[]"
  std::string interpolation;  ///< "vertex", "constant", or empty
  bool isUniform = false;     ///< it cannot change in time
  bool isCustom = false;      ///< it is not part of the prim's schema
};

struct UsdAttribute {
  UsdAttributeType type;
  std::optional<UsdPlace> value;                     ///< the same at all times
  std::vector<std::pair<double, UsdPlace>> samples;  ///< by time code, ascending
};

struct UsdPrim {
  std::string name, type;  ///< "surface", "Mesh"
  std::vector<UsdAttribute> attributes;
  std::vector<UsdPrim> children;
};

/// The layer's own properties and its only root prim.
struct UsdLayer {
  UsdPrim root;
  std::string comment;
  double timeCodesPerSecond = 24, start = 0, end = 0;
};

/// Writes the values of a layer at once and its structure at the end, so memory holds one frame. All
/// functions throw IoError if the file cannot be written.
class UsdFile {
 public:
  virtual ~UsdFile() = default;
  /// Thread-safe.
  virtual UsdBytes encode(const UsdValue& value) const = 0;
  virtual UsdPlace store(const UsdBytes& value) = 0;
  virtual void finish(const UsdLayer& layer) = 0;
};

std::unique_ptr<UsdFile> openUsda(const std::filesystem::path& file);
std::unique_ptr<UsdFile> openUsdc(const std::filesystem::path& file);

/// Returns a name that USD accepts: letters, digits and "_", no digit first.
std::string usdName(const std::string& name);

}  // namespace thaw
