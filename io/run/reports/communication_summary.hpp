// SPDX-License-Identifier: Apache-2.0
// Messages, bytes, collectives and waiting time over ranks, for summary.json and `thaw run --profile`.
#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>

#include "core/halo/halo.hpp"
#include "parallel/communication_statistics.hpp"

namespace thaw {

/// Smallest, mean and largest value over ranks.
struct RankSpread {
  double least = 0, mean = 0, most = 0;
};

struct CommunicationSummary {
  struct Of {
    RankSpread messages, bytes, waited;
  };  ///< per rank; waited in s
  std::array<Of, purposes> of{};
  RankSpread messages, bytes, waited;          ///< totals over all purposes
  std::int64_t allMessages = 0, allBytes = 0;  ///< sums over ranks
  std::int64_t collectives = 0;                ///< largest over ranks
};

/// Returns the communication statistics since `before`. Collective.
CommunicationSummary gatherCommunication(const CommunicationStatistics& now,
                                         const CommunicationStatistics& before, Reducer& all);

nlohmann::ordered_json communicationJson(const CommunicationSummary& summary);

}  // namespace thaw
