// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/chosen_numerics.hpp"

#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

std::string valueOf(const std::string& key, const Numerics& n) {
  Scene s;
  s.numerics = n;
  for (const KeyDescription& k : sceneValues(s))
    if (k.table + "." + k.key == key) return k.standard;
  return "";
}

}  // namespace

bool isChosen(const std::string& key, const Numerics& n) { return valueOf(key, n) != valueOf(key, {}); }

}  // namespace thaw
