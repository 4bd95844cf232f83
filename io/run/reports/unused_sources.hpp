// SPDX-License-Identifier: Apache-2.0
// Warnings about lamps, lasers and heated regions of which nothing was absorbed.
#pragma once
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/ledger/ledger.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Returns a warning for each source that has given energy since the start of the run, if no particle
/// absorbed any of it. The same on any number of ranks. Collective.
std::vector<std::string> unusedSourceWarnings(const Ledger& ledger, const Scene& scene, Reducer& all);

}  // namespace thaw
