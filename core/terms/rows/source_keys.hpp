// SPDX-License-Identifier: Apache-2.0
// Keys and uses that lamps, lasers and heated regions share.
#pragma once
#include <string>
#include <vector>

#include "core/terms/model_part.hpp"

namespace thaw {

/// Declares the times at which a source is on, and its motion.
template<class Source> void readTimes(KeyTable& keys, Source& s) {
  keys.number("start", s.start, "s", notNegative(), "time at which it is switched on");
  keys.number("end", s.end, "s", orNever(notNegative()), "time at which it is switched off");
  keys.motion(s.motion,
              "keyframes; the pose is linear in between, and constant before the first and after the last");
  if (keys.reading() && s.end < s.start) keys.fail("end", "must not be before `start`", {"start"});
}

/// Adds the modules that a scene needs for its named heat sources, if it has bodies that these can heat.
template<class Source>
void addUses(const Scene& s, const std::vector<Source>& sources, const std::string& title,
             std::vector<ModuleUse>& uses) {
  if (!hasContinuum(s)) return;
  for (const Source& one : sources) {
    const std::string who = title + " '" + one.name + "'";
    uses.push_back({&Modules::heat, who + " heats bodies"});
    uses.push_back({&Modules::lamps, who});
  }
}

}  // namespace thaw
