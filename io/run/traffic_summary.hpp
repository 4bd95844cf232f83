// Messages, bytes, collectives and waiting of all ranks: for summary.json and for the table of `thaw run
// --profile`.
#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>

#include "core/halo/halo.hpp"
#include "parallel/traffic.hpp"

namespace thaw {

/// Least, mean and most of a rank.
struct RankSpread {
  double least = 0, mean = 0, most = 0;
};

struct TrafficSummary {
  struct Of {
    RankSpread messages, bytes, waited;
  };  ///< of a rank; waited in s
  std::array<Of, purposes> of{};
  RankSpread messages, bytes, waited;          ///< the same of all purposes together
  std::int64_t allMessages = 0, allBytes = 0;  ///< of all ranks
  std::int64_t collectives = 0;                ///< most of a rank
};

/// What was done since `before`, of each rank. Collective.
TrafficSummary gatherTraffic(const Traffic& now, const Traffic& before, Reducer& all);

nlohmann::ordered_json trafficJson(const TrafficSummary& traffic);

}  // namespace thaw
