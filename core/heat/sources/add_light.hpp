// SPDX-License-Identifier: Apache-2.0
// Light that particles receive from lamps and lasers.
#pragma once
#include <vector>

#include "core/heat/sources/heat_sources.hpp"

namespace thaw {

/// Light (W) that each owned particle receives, before reflection. A list is empty without sources of its
/// type.
struct LightReceived {
  std::vector<double> lamps, lasers;
};

/// Distributes the light of the step of dt (s) that begins now. Records the emitted energy in the ledger.
/// Collective.
LightReceived receiveLight(const LightTarget& view, double dt, Reducer& all);

}  // namespace thaw
