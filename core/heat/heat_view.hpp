// SPDX-License-Identifier: Apache-2.0
// Data of a run that the heat model reads and changes.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/time/clock.hpp"

namespace thaw {

struct HeatView {
  const Scene& scene;
  const Modules& modules;
  Continuum& particles;
  Solids& solids;
  const Clock& clock;
  Ledger& ledger;
};

}  // namespace thaw
