// SPDX-License-Identifier: Apache-2.0
// Data of a step that is used and changed to select rigid parts.
#pragma once
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/rigid/rigid_view.hpp"
#include "core/solid/elasticity/elastic.hpp"
#include "core/time/clock.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

struct RigidifyView {
  RigidView rigid;
  Solids& solids;
  const Bonds& bonds;
  ElasticWork& elastic;
  const WallContacts& wallContacts;
  const ClosePairs& closePairs;
  const Clock& clock;
};

}  // namespace thaw
