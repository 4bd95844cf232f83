// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/speed_text.hpp"
#include "parallel/balance.hpp"

namespace thaw {
namespace {

RankSpread over(double mine, Reducer& all) {
  double most[2] = {mine, -mine};
  std::int64_t sum = std::llround(mine * 1e9);
  all.maximum(most);
  all.sum({&sum, 1});
  return {-most[1], static_cast<double>(sum) * 1e-9 / all.size(), most[0]};
}

}  // namespace

void beginProfile(Profile& p, PhaseTimes& times, const Communicator& comm) {
  p.times = times;
  p.statistics = comm.statistics();
  p.start = std::chrono::steady_clock::now();
  times.trace = &p.trace;
  comm.setTrace(&p.trace);
}

void endProfile(PhaseTimes& times, const Communicator& comm) {
  times.trace = nullptr;
  comm.setTrace(nullptr);
}

std::vector<std::string> profileLines(const Profile& p, const PhaseTimes& times, std::int64_t stepsDone,
                                      std::int64_t particles, const Communicator& comm) {
  const double wallHere = std::chrono::duration<double>(std::chrono::steady_clock::now() - p.start).count();
  MpiReducer all(comm);
  const CommunicationSummary t = gatherCommunication(comm.statistics(), p.statistics, all);
  const double steps = static_cast<double>(std::max<std::int64_t>(1, stepsDone)),
               wall = over(wallHere, all).mean;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("profile of {} steps of {} particles on {} rank{}; ms per step and rank",
                              stepsDone, particles, comm.size(), comm.size() == 1 ? "" : "s"));
  lines.push_back(fmt::format("  {:<14}{:>10}{:>10}{:>10}{:>9}", "phase", "min", "mean", "max", "share"));
  const auto row = [&](const char* name, const RankSpread& s) {
    lines.push_back(fmt::format("  {:<14}{:>10.3f}{:>10.3f}{:>10.3f}{:>8.1f}%", name, 1e3 * s.least / steps,
                                1e3 * s.mean / steps, 1e3 * s.most / steps,
                                wall > 0 ? 100 * s.mean / wall : 0));
  };
  PhaseTimes here;
  for (std::size_t k = 0; k < stepPhases; k++) here.seconds[k] = times.seconds[k] - p.times.seconds[k];
  for (std::size_t k = 0; k < stepPhases; k++)
    if (const RankSpread s = over(here.seconds[k], all); s.most > 0)
      row(phaseName(static_cast<StepPhase>(k)), s);
  row("in no phase", over(std::max(0.0, wallHere - here.total()), all));
  const RankSpread work = over(workOf(here), all);
  row("all work", work);
  row("waiting", t.waited);
  lines.push_back(fmt::format("  imbalance of work {:.3f} (largest over mean); {}",
                              work.mean > 0 ? work.most / work.mean : 1,
                              speedText(wall > 0 ? static_cast<double>(particles) * steps / wall : 0)));
  if (comm.size() == 1) return lines;
  lines.push_back(fmt::format("  {:<14}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}   per step and rank",
                              "messages for", "number", "most", "KiB", "most", "wait ms", "most"));
  const auto sent = [&](const char* name, const RankSpread& messages, const RankSpread& bytes,
                        const RankSpread& waited) {
    lines.push_back(fmt::format("  {:<14}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.3f}{:>10.3f}", name,
                                messages.mean / steps, messages.most / steps, bytes.mean / steps / 1024,
                                bytes.most / steps / 1024, 1e3 * waited.mean / steps,
                                1e3 * waited.most / steps));
  };
  for (std::size_t k = 0; k < purposes; k++)
    if (const CommunicationSummary::Of& of = t.of[k]; of.messages.most > 0 || of.waited.most > 0)
      sent(purposeName(static_cast<MessagesFor>(k)), of.messages, of.bytes, of.waited);
  sent("all", t.messages, t.bytes, t.waited);
  lines.push_back(fmt::format("  {:.2f} collectives per step", static_cast<double>(t.collectives) / steps));
  return lines;
}

}  // namespace thaw
