// SPDX-License-Identifier: Apache-2.0
// The exact sums of a ledger and the counters of a world as lists, for reductions, checkpoints and
// comparisons. A new member needs a line in totals.cpp; a static_assert enforces that.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct NamedSum {
  const char* name;
  const char* unit;
  ExactSum* sum;
};
std::vector<NamedSum> sumsOf(Ledger& ledger);

struct NamedCount {
  const char* name;
  std::int64_t* count;
};
std::vector<NamedCount> countsOf(Counters& counters);
std::vector<NamedCount> countsOf(SurfaceCounters& counters);

struct NamedReal {
  const char* name;
  double* value;
};
std::vector<NamedReal> realsOf(MonitorState& monitor);
std::vector<NamedCount> countsOf(MonitorState& monitor);

struct NamedValue {
  const char* name;
  const char* unit;
  double* value;
};
std::vector<NamedValue> valuesOf(Balance& balance);

/// Returns the exact sums over ranks, the same on any number of ranks, with every digit except the last in
/// [0, 2^32). `initial` is already global. Collective.
Ledger globalLedger(const Ledger& mine, Reducer& all);
Counters globalCounters(const Counters& mine, Reducer& all);

}  // namespace thaw
