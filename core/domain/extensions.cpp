// SPDX-License-Identifier: Apache-2.0
#include "core/domain/extensions.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

namespace thaw {
namespace {

std::map<std::string, Extension>& registered() {
  static std::map<std::string, Extension> all;
  return all;
}

bool isName(const std::string& s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  });
}

}  // namespace

void registerExtension(Extension e) {
  if (!isName(e.name))
    throw std::invalid_argument("extension '" + e.name +
                                "': expected a name of letters, digits and underscores");
  if (!e.load) throw std::invalid_argument("extension '" + e.name + "' has no load");
  for (const ExtensionKey& key : e.keys)
    if (!isName(key.name) || !(key.least <= key.standard && key.standard <= key.most))
      throw std::invalid_argument("extension '" + e.name + "': key '" + key.name +
                                  "' needs a name, and a default within its range");
  const std::string name = e.name;
  if (!registered().emplace(name, std::move(e)).second)
    throw std::invalid_argument("extension '" + name + "' is registered already");
}

const Extension* findExtension(const std::string& name) {
  const auto at = registered().find(name);
  return at == registered().end() ? nullptr : &at->second;
}

std::vector<std::string> extensionNames() {
  std::vector<std::string> names;
  for (const auto& [name, extension] : registered()) names.push_back(name);
  return names;
}

}  // namespace thaw
