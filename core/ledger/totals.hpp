// The exact sums of a ledger and the counters of a world as lists: what reductions, checkpoints and
// comparisons walk. A new member needs a line in totals.cpp, where a static_assert asks for it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/world.hpp"

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
std::vector<NamedReal> realsOf(WatchState& watch);
std::vector<NamedCount> countsOf(WatchState& watch);

struct NamedValue {
  const char* name;
  const char* unit;
  double* value;
};
std::vector<NamedValue> valuesOf(Balance& balance);

/// Sums over ranks, exact: the same on any number of ranks, with every digit in [0, 2^32) but the last.
/// `initial` is global already. Collective.
Ledger globalLedger(const Ledger& mine, Reducer& all);
Counters globalCounters(const Counters& mine, Reducer& all);

}  // namespace thaw
