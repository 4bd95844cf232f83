// SPDX-License-Identifier: Apache-2.0
// USD crate files, version 0.7.0: a header, values, six sections of structure, and their table of contents.
#include <bit>
#include <cstring>
#include <map>
#include <type_traits>

#include "io/export/out_file.hpp"
#include "io/export/usd/crate_structure.hpp"
#include "io/export/usd/layer.hpp"
#include "io/export/usd/lz4_block.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

constexpr std::uint64_t headerBytes = 88, tocPlace = 16;

template<class T> constexpr CrateType typeOf() {
  if constexpr (std::is_same_v<T, bool>) return CrateType::Bool;
  else if constexpr (std::is_same_v<T, std::int32_t>) return CrateType::Int;
  else if constexpr (std::is_same_v<T, std::int64_t>) return CrateType::Int64;
  else if constexpr (std::is_same_v<T, float>) return CrateType::Float;
  else if constexpr (std::is_same_v<T, double>) return CrateType::Double;
  else if constexpr (std::is_same_v<T, UsdToken>) return CrateType::Token;
  else if constexpr (std::is_same_v<T, std::string>) return CrateType::String;
  else if constexpr (std::is_same_v<T, Vec2f>) return CrateType::Vec2f;
  else if constexpr (std::is_same_v<T, Vec3f>) return CrateType::Vec3f;
  else return CrateType::Matrix4d;
}

void addBytes(std::vector<char>& out, const void* data, std::size_t count) {
  if (count == 0) return;
  const std::size_t before = out.size();
  out.resize(before + count);
  std::memcpy(out.data() + before, data, count);
}

template<class T> void addNumber(std::vector<char>& out, const T& value) { addBytes(out, &value, sizeof(T)); }

template<class T> UsdBytes encoded(const std::vector<T>& values) {
  constexpr std::size_t leastCompressed = 16;
  UsdBytes out;
  out.rep = crateRep(typeOf<T>()) | crateArray;
  if (values.empty()) {
    out.isInlined = true;  // an array with offset 0 is empty
    return out;
  }
  if constexpr (std::is_same_v<T, UsdToken>) {
    for (const UsdToken& t : values) addBytes(out.bytes, t.text.c_str(), t.text.size() + 1);
  } else {
    addNumber(out.bytes, static_cast<std::uint64_t>(values.size()));
    if constexpr (std::is_same_v<T, std::int32_t>)
      if (values.size() >= leastCompressed) {
        const std::vector<char> packed = crateIntegers(values);
        addNumber(out.bytes, static_cast<std::uint64_t>(packed.size()));
        addBytes(out.bytes, packed.data(), packed.size());
        out.rep |= crateIsCompressed;
        return out;
      }
    addBytes(out.bytes, values.data(), values.size() * sizeof(T));
  }
  return out;
}

template<class T> UsdBytes encoded(const T& value) {
  UsdBytes out;
  out.rep = crateRep(typeOf<T>());
  if constexpr (std::is_same_v<T, UsdToken>) {
    out.bytes.assign(value.text.begin(), value.text.end());
  } else if constexpr (std::is_same_v<T, std::string>) {
    out.bytes.assign(value.begin(), value.end());
  } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, float>) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    out.rep |= crateIsInlined | bits;
    out.isInlined = true;
  } else {
    addNumber(out.bytes, value);
  }
  return out;
}

class Usdc : public UsdFile {
 public:
  explicit Usdc(const std::filesystem::path& file) : out_(file) {
    if (std::endian::native != std::endian::little)
      throw IoError(file.string(), "usdc is written on little-endian machines only; use usda");
    const char header[headerBytes] = {'P', 'X', 'R', '-', 'U', 'S', 'D', 'C', 0, 7, 0};
    out_.bytes(header, headerBytes);
  }

  UsdBytes encode(const UsdValue& value) const override {
    return std::visit([](const auto& v) { return encoded(v); }, value);
  }

  UsdPlace store(const UsdBytes& value) override {
    if (value.isInlined) return value.rep;
    const std::string_view text(value.bytes.data(), value.bytes.size());
    const CrateType type = crateTypeOf(value.rep);
    if (type == CrateType::String) return value.rep | crateIsInlined | structure_.string(std::string(text));
    if (type != CrateType::Token) return value.rep | placed(value.bytes);
    if (!(value.rep & crateArray)) return value.rep | crateIsInlined | structure_.token(std::string(text));
    std::vector<std::uint32_t> tokens;
    for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1)
      tokens.push_back(structure_.token(std::string(text.data() + at)));
    return value.rep | placedList(tokens);
  }

  void finish(const UsdLayer& layer) override {
    addRoot(layer);
    addPrim(layer.root, structure_.root());
    std::vector<CrateSection> sections = structure_.sections();
    std::vector<char> toc;
    addNumber(toc, static_cast<std::uint64_t>(sections.size()));
    for (const CrateSection& s : sections) {
      std::string name = s.name;
      name.resize(16);  // filled with zeros
      addBytes(toc, name.data(), name.size());
      addNumber(toc, out_.size());
      addNumber(toc, static_cast<std::uint64_t>(s.bytes.size()));
      out_.array(s.bytes);
    }
    const std::uint64_t place = out_.size();
    out_.array(toc);
    out_.overwrite(tocPlace, &place, sizeof(place));
    out_.finish();
  }

 private:
  /// Writes bytes at a multiple of eight and returns their offset.
  std::uint64_t placed(const std::vector<char>& bytes) {
    static constexpr char zeros[8] = {};
    out_.bytes(zeros, (8 - out_.size() % 8) % 8);
    const std::uint64_t place = out_.size();
    out_.array(bytes);
    return place;
  }
  template<class T> std::uint64_t placedList(const std::vector<T>& values) {
    std::vector<char> bytes;
    addNumber(bytes, static_cast<std::uint64_t>(values.size()));
    addBytes(bytes, values.data(), values.size() * sizeof(T));
    return placed(bytes);
  }
  template<class T> std::uint64_t rep(const T& value) { return store(encoded(value)); }

  std::uint64_t namesRep(const std::vector<std::string>& names) {
    std::vector<std::uint32_t> tokens;
    for (const std::string& name : names) tokens.push_back(structure_.token(name));
    return crateRep(CrateType::TokenVector) | placedList(tokens);
  }

  /// Returns the rep of samples: times, then the reps of the values. An offset precedes each list.
  std::uint64_t samplesRep(const UsdAttribute& a) {
    std::vector<double> times;
    std::vector<char> bytes;
    for (const auto& s : a.samples) times.push_back(s.first);
    std::uint64_t& timesRep = times_[times];
    if (timesRep == 0) timesRep = crateRep(CrateType::DoubleVector) | placedList(times);
    addNumber(bytes, std::int64_t{8});
    addNumber(bytes, timesRep);
    addNumber(bytes, std::int64_t{8});
    addNumber(bytes, static_cast<std::uint64_t>(a.samples.size()));
    for (const auto& s : a.samples) addNumber(bytes, s.second);
    return crateRep(CrateType::TimeSamples) | placed(bytes);
  }

  void addRoot(const UsdLayer& layer) {
    structure_.addSpec(structure_.root(), CrateSpec::PseudoRoot,
                       {{"defaultPrim", rep(UsdToken{layer.root.name})},
                        {"documentation", rep(layer.comment)},
                        {"endTimeCode", rep(layer.end)},
                        {"framesPerSecond", rep(layer.timeCodesPerSecond)},
                        {"metersPerUnit", rep(1.0)},
                        {"startTimeCode", rep(layer.start)},
                        {"timeCodesPerSecond", rep(layer.timeCodesPerSecond)},
                        {"upAxis", rep(UsdToken{"Z"})},
                        {"primChildren", namesRep({layer.root.name})}});
  }

  void addPrim(const UsdPrim& prim, CrateNode& parent) {
    CrateNode& node = structure_.addNode(parent, prim.name, false);
    std::vector<std::string> properties, children;
    for (const UsdAttribute& a : prim.attributes) properties.push_back(a.type.name);
    for (const UsdPrim& c : prim.children) children.push_back(c.name);
    std::vector<CrateField> fields{{"specifier", crateRep(CrateType::Specifier) | crateIsInlined},  // "def"
                                   {"typeName", rep(UsdToken{prim.type})}};
    if (!properties.empty()) fields.push_back({"properties", namesRep(properties)});
    if (!children.empty()) fields.push_back({"primChildren", namesRep(children)});
    structure_.addSpec(node, CrateSpec::Prim, fields);
    for (const UsdAttribute& a : prim.attributes) addAttribute(a, node);
    for (const UsdPrim& c : prim.children) addPrim(c, node);
  }

  void addAttribute(const UsdAttribute& a, CrateNode& parent) {
    CrateNode& node = structure_.addNode(parent, a.type.name, true);
    std::vector<CrateField> fields{{"typeName", rep(UsdToken{a.type.type})}};
    if (a.type.isCustom) fields.push_back({"custom", rep(true)});
    if (a.type.isUniform)
      fields.push_back({"variability", crateRep(CrateType::Variability) | crateIsInlined | 1});
    if (!a.type.interpolation.empty())
      fields.push_back({"interpolation", rep(UsdToken{a.type.interpolation})});
    if (a.value) fields.push_back({"default", *a.value});
    if (!a.samples.empty()) fields.push_back({"timeSamples", samplesRep(a)});
    structure_.addSpec(node, CrateSpec::Attribute, fields);
  }

  OutFile out_;
  CrateStructure structure_;
  std::map<std::vector<double>, std::uint64_t> times_;  // reps of lists of times
};

}  // namespace

std::unique_ptr<UsdFile> openUsdc(const std::filesystem::path& file) { return std::make_unique<Usdc>(file); }

}  // namespace thaw
