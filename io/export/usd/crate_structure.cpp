// SPDX-License-Identifier: Apache-2.0
#include "io/export/usd/crate_structure.hpp"

#include <span>

#include "io/export/usd/lz4_block.hpp"

namespace thaw {

namespace {

void addBytes(std::vector<char>& out, std::span<const char> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void addInteger(std::vector<char>& out, std::uint64_t value) {
  const char* bytes = reinterpret_cast<const char*>(&value);
  out.insert(out.end(), bytes, bytes + sizeof(value));
}

void addPacked(std::vector<char>& out, const std::vector<char>& packed) {
  addInteger(out, packed.size());
  addBytes(out, packed);
}

template<class T> std::span<const char> bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

CrateStructure::CrateStructure() {
  token(";-)");  // paths store properties by negative token indices, so index 0 is not used
}

std::uint32_t CrateStructure::token(const std::string& text) {
  const auto [place, isNew] = tokenOf_.try_emplace(text, static_cast<std::uint32_t>(tokens_.size()));
  if (isNew) tokens_.push_back(text);
  return place->second;
}

std::uint32_t CrateStructure::string(const std::string& text) {
  strings_.push_back(token(text));
  return static_cast<std::uint32_t>(strings_.size() - 1);
}

CrateNode& CrateStructure::addNode(CrateNode& parent, const std::string& name, bool isProperty) {
  return parent.children.emplace_back(
      CrateNode{paths_++, static_cast<std::int32_t>(token(name)), isProperty, {}});
}

void CrateStructure::addSpec(const CrateNode& node, CrateSpec type, const std::vector<CrateField>& fields) {
  std::vector<std::int32_t> set;
  for (const auto& [name, rep] : fields) {
    const std::uint32_t number = token(name);
    const auto [place, isNew] = fieldOf_.try_emplace({number, rep},
                                                     static_cast<std::int32_t>(fieldTokens_.size()));
    if (isNew) fieldTokens_.push_back(static_cast<std::int32_t>(number)), fieldReps_.push_back(rep);
    set.push_back(place->second);
  }
  set.push_back(-1);  // the end
  const auto [place, isNew] = setOf_.try_emplace(set, static_cast<std::int32_t>(sets_.size()));
  if (isNew) sets_.insert(sets_.end(), set.begin(), set.end());
  specPaths_.push_back(node.path);
  specSets_.push_back(place->second);
  specTypes_.push_back(static_cast<std::int32_t>(type));
}

// The jump of a path is 0 if only a sibling follows, -1 if only a child does, -2 if neither does. Else it is
// the distance to the sibling, which comes after all children.
void CrateStructure::addPaths(const CrateNode& node, bool hasSibling, Paths& to) {
  const std::size_t at = to.paths.size();
  to.paths.push_back(node.path);
  to.tokens.push_back(node.isProperty ? -node.token : node.token);
  to.jumps.push_back(node.children.empty() ? (hasSibling ? 0 : -2) : -1);
  std::size_t left = node.children.size();
  for (const CrateNode& child : node.children) addPaths(child, --left > 0, to);
  if (hasSibling && !node.children.empty()) to.jumps[at] = static_cast<std::int32_t>(to.paths.size() - at);
}

std::vector<CrateSection> CrateStructure::sections() const {
  std::vector<CrateSection> all{{"TOKENS", {}},    {"STRINGS", {}}, {"FIELDS", {}},
                                {"FIELDSETS", {}}, {"PATHS", {}},   {"SPECS", {}}};
  std::vector<char> text;
  for (const std::string& t : tokens_) addBytes(text, {t.c_str(), t.size() + 1});
  addInteger(all[0].bytes, tokens_.size());
  addInteger(all[0].bytes, text.size());
  addPacked(all[0].bytes, crateCompressed(text));
  addInteger(all[1].bytes, strings_.size());
  addBytes(all[1].bytes, bytesOf(strings_));
  addInteger(all[2].bytes, fieldTokens_.size());
  addPacked(all[2].bytes, crateIntegers(fieldTokens_));
  addPacked(all[2].bytes, crateCompressed(bytesOf(fieldReps_)));
  addInteger(all[3].bytes, sets_.size());
  addPacked(all[3].bytes, crateIntegers(sets_));
  Paths paths;
  addPaths(root_, false, paths);
  addInteger(all[4].bytes, paths.paths.size());
  addInteger(all[4].bytes, paths.paths.size());
  for (const auto* column : {&paths.paths, &paths.tokens, &paths.jumps})
    addPacked(all[4].bytes, crateIntegers(*column));
  addInteger(all[5].bytes, specPaths_.size());
  for (const auto* column : {&specPaths_, &specSets_, &specTypes_})
    addPacked(all[5].bytes, crateIntegers(*column));
  return all;
}

}  // namespace thaw
