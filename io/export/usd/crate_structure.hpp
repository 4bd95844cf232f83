// SPDX-License-Identifier: Apache-2.0
// The structure of a USD crate file: tokens, strings, fields, sets of fields, paths and specs.
#pragma once
#include <cstdint>
#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace thaw {

enum class CrateType : std::uint8_t {
  Bool = 1,
  Int = 3,
  Int64 = 5,
  Float = 8,
  Double = 9,
  String = 10,
  Token = 11,
  Matrix4d = 15,
  Vec2f = 20,
  Vec3f = 24,
  TokenVector = 41,
  Specifier = 42,
  Variability = 44,
  TimeSamples = 46,
  DoubleVector = 48
};

/// A rep describes a value in 64 bits: flags, a type, and 48 bits with the value or its offset in the file.
constexpr std::uint64_t crateArray = std::uint64_t{1} << 63, crateIsInlined = std::uint64_t{1} << 62,
                        crateIsCompressed = std::uint64_t{1} << 61;
constexpr std::uint64_t crateRep(CrateType type) { return static_cast<std::uint64_t>(type) << 48; }
constexpr CrateType crateTypeOf(std::uint64_t rep) { return static_cast<CrateType>(rep >> 48 & 255); }

enum class CrateSpec : std::int32_t { Attribute = 1, Prim = 6, PseudoRoot = 7 };

using CrateField = std::pair<std::string, std::uint64_t>;  ///< name and rep

struct CrateSection {
  std::string name;
  std::vector<char> bytes;
};

/// Path of a prim or property.
struct CrateNode {
  std::int32_t path = 0, token = 0;
  bool isProperty = false;
  std::list<CrateNode> children;
};

class CrateStructure {
 public:
  CrateStructure();
  std::uint32_t token(const std::string& text);
  std::uint32_t string(const std::string& text);
  CrateNode& root() { return root_; }
  CrateNode& addNode(CrateNode& parent, const std::string& name, bool isProperty);
  void addSpec(const CrateNode& node, CrateSpec type, const std::vector<CrateField>& fields);
  /// Returns the sections in the order of the file.
  std::vector<CrateSection> sections() const;

 private:
  struct Paths {
    std::vector<std::int32_t> paths, tokens, jumps;
  };
  static void addPaths(const CrateNode& node, bool hasSibling, Paths& to);

  std::map<std::string, std::uint32_t> tokenOf_;
  std::vector<std::string> tokens_;
  std::vector<std::uint32_t> strings_;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::int32_t> fieldOf_;
  std::vector<std::int32_t> fieldTokens_;
  std::vector<std::uint64_t> fieldReps_;
  std::map<std::vector<std::int32_t>, std::int32_t> setOf_;
  std::vector<std::int32_t> sets_;
  std::vector<std::int32_t> specPaths_, specSets_, specTypes_;
  std::int32_t paths_ = 1;
  CrateNode root_;
};

}  // namespace thaw
