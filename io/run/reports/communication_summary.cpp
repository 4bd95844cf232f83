// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/communication_summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace thaw {
namespace {

nlohmann::ordered_json json(const RankSpread& s) {
  return {{"min", s.least}, {"mean", s.mean}, {"max", s.most}};
}

}  // namespace

CommunicationSummary gatherCommunication(const CommunicationStatistics& now,
                                         const CommunicationStatistics& before, Reducer& all) {
  std::vector<double> mine;
  const auto add = [&](const CommunicationStatistics::Sum& a, const CommunicationStatistics::Sum& b) {
    mine.push_back(static_cast<double>(a.messages - b.messages));
    mine.push_back(static_cast<double>(a.bytes - b.bytes));
    mine.push_back(a.waited - b.waited);
  };
  for (std::size_t p = 0; p < purposes; p++) add(now.of[p], before.of[p]);
  add(now.total(), before.total());
  std::vector<double> most = mine, least;
  most.push_back(static_cast<double>(now.collectives - before.collectives));
  std::vector<std::int64_t> sum;
  for (double v : mine) least.push_back(-v);
  for (std::size_t k = 0; k < mine.size(); k++) sum.push_back(std::llround(mine[k] * (k % 3 == 2 ? 1e9 : 1)));
  all.maximum(most);
  all.maximum(least);
  all.sum(sum);
  const auto spread = [&](std::size_t k) {
    return RankSpread{-least[k], static_cast<double>(sum[k]) * (k % 3 == 2 ? 1e-9 : 1) / all.size(), most[k]};
  };
  CommunicationSummary t;
  for (std::size_t p = 0; p < purposes; p++) t.of[p] = {spread(3 * p), spread(3 * p + 1), spread(3 * p + 2)};
  const std::size_t total = 3 * purposes;
  t.messages = spread(total);
  t.bytes = spread(total + 1);
  t.waited = spread(total + 2);
  t.allMessages = sum[total];
  t.allBytes = sum[total + 1];
  t.collectives = static_cast<std::int64_t>(most.back());
  return t;
}

nlohmann::ordered_json communicationJson(const CommunicationSummary& t) {
  nlohmann::ordered_json j;
  j["collectives"] = t.collectives;
  j["messages_per_rank"] = json(t.messages);
  j["bytes_per_rank"] = json(t.bytes);
  j["waited_s_per_rank"] = json(t.waited);
  for (std::size_t p = 0; p < purposes; p++) {
    const CommunicationSummary::Of& of = t.of[p];
    if (of.messages.most > 0 || of.waited.most > 0)
      j["of"][purposeName(static_cast<MessagesFor>(p))] = {{"messages_per_rank", of.messages.mean},
                                                           {"bytes_per_rank", of.bytes.mean},
                                                           {"waited_s_per_rank", json(of.waited)}};
  }
  return j;
}

}  // namespace thaw
