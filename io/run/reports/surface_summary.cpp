// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/surface_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/domain/emit.hpp"
#include "core/simulation/ledger/totals.hpp"

namespace thaw {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t mostEvents = 1000, mostLines = 8;  // last events in the summary (events.csv has all);
                                                         // components at the end

/// A count of events that a picture may show if they are frequent.
struct Correction {
  double share, visible;  ///< share of surfels or updates, and the share from which it is a warning
  std::string text;
  const char* advice;

  bool isMinor() const { return share < visible; }
};

/// Returns the corrections that occurred. The number of surfels stands for that of all updates.
std::vector<Correction> correctionsOf(const SurfaceSummary& s) {
  const SurfaceCounters& c = s.counters;
  const auto updates = static_cast<double>(std::max<std::int64_t>(1, c.updates));
  const double surfels = updates * static_cast<double>(std::max<std::int64_t>(1, s.surfels));
  const double lost = static_cast<double>(c.lost) / surfels,
               flipped = static_cast<double>(c.flipped) / surfels,
               unfinished = static_cast<double>(c.unfinished) / updates;
  std::vector<Correction> found;
  if (c.lost > 0)
    found.push_back({lost, 0.002,
                     fmt::format("{} surfels ({:.2g} % per update) had no particles nearby and were deleted",
                                 c.lost, 100 * lost),
                     ": pictures may show holes; a finer `spacing` or more frequent updates "
                     "(`surface.every_move`) help"});
  if (c.flipped > 0)
    found.push_back({flipped, 0.02,
                     fmt::format("{} surfel normals ({:.2g} % per update) pointed inward and were reversed",
                                 c.flipped, 100 * flipped),
                     ": pictures may show dents where the material is thin; a finer `spacing` helps"});
  if (c.unfinished > 0)
    found.push_back(
        {unfinished, 0.05,
         fmt::format("{} of {} updates of the surface ended at `surface.iterations` while surfels still "
                     "moved",
                     c.unfinished, c.updates),
         ": if pictures show bumps, set more `surface.iterations`"});
  return found;
}

}  // namespace

Json surfaceJson(const SurfaceSummary& s) {
  Json j = {{"surfels", s.surfels},
            {"spacing_m", s.spacing},
            {"last_update_step", s.lastStep},
            {"updates_of_this_process", s.updatesHere},
            {"seconds_per_update", s.updatesHere > 0 ? s.seconds / static_cast<double>(s.updatesHere) : 0}};
  if (s.updatesHere > 0)
    for (std::size_t k = 0; k < surfacePhases; k++)
      j["seconds_per_update_by_phase"][phaseName(static_cast<SurfacePhase>(k))] = s.phases[k] /
                                                                                  static_cast<double>(
                                                                                      s.updatesHere);
  SurfaceCounters counters = s.counters;
  for (const NamedCount& c : countsOf(counters)) j["counters"][c.name] = *c.count;
  j["volume_errors"] = volumeErrorJson(s.volumeErrors);
  j["components"] = Json::array();
  for (const SurfaceComponent& c : s.components)
    j["components"].push_back({{"component", c.label},
                               {"particles", c.particles},
                               {"surfels", c.surfels},
                               {"mass_kg", c.mass},
                               {"particle_volume_m3", c.particleVolume},
                               {"volume_m3", c.volume},
                               {"target_volume_m3", c.targetVolume},
                               {"area_m2", c.area},
                               {"open", c.open},
                               {"centroid_m", {c.centroid.x, c.centroid.y, c.centroid.z}}});
  j["events"] = Json::array();
  for (std::size_t k = s.events.size() - std::min(s.events.size(), mostEvents); k < s.events.size(); k++) {
    const SurfaceEvent& e = s.events[k];
    j["events"].push_back({{"step", e.step},
                           {"time_s", e.time},
                           {"kind", eventName(e.kind)},
                           {"component", e.label},
                           {"other", e.other}});
  }
  return j;
}

std::vector<std::string> surfaceLines(const SurfaceSummary& s) {
  if (!s.there) return {};
  const SurfaceCounters& c = s.counters;
  std::vector<std::string> lines{
      fmt::format("surface: {} surfels, {} updates with {} iterations, {} births, {} deaths, {} splits, {} "
                  "merges; {:.3g} s per update",
                  s.surfels, c.updates, c.iterations, c.births, c.deaths, c.splits, c.merges,
                  s.updatesHere > 0 ? s.seconds / static_cast<double>(s.updatesHere) : 0)};
  if (s.updatesHere > 0) {
    std::string line = "  per update:";
    for (std::size_t k = 0; k < surfacePhases; k++)
      line += fmt::format("{} {} {:.3g} ms", k > 0 ? "," : "", phaseName(static_cast<SurfacePhase>(k)),
                          1e3 * s.phases[k] / static_cast<double>(s.updatesHere));
    lines.push_back(line);
  }
  for (const Correction& correction : correctionsOf(s))
    if (correction.isMinor()) lines.push_back("  " + correction.text + ": usually not visible");
  for (const std::string& line : volumeErrorLines(s.volumeErrors)) lines.push_back(line);
  std::vector<SurfaceComponent> largest = s.components;
  std::stable_sort(largest.begin(), largest.end(), [](const SurfaceComponent& a, const SurfaceComponent& b) {
    return a.particles > b.particles;
  });
  for (std::size_t k = 0; k < std::min(mostLines, largest.size()); k++)
    lines.push_back(fmt::format(
        "  component {}: {} particles of {:.5g} m^3, {} surfels around {:.5g} m^3, area {:.5g} m^2",
        largest[k].label, largest[k].particles, largest[k].particleVolume, largest[k].surfels,
        largest[k].volume, largest[k].area));
  if (largest.size() > mostLines)
    lines.push_back(fmt::format("  and {} smaller ones (surface.csv)", largest.size() - mostLines));
  return lines;
}

std::vector<std::string> mergedSheetWarnings(const Scene& scene,
                                             const std::vector<std::uint64_t>& mergedSheets) {
  std::vector<std::string> w;
  std::uint64_t last = ~std::uint64_t{0};
  for (const std::uint64_t label : mergedSheets) {  // labels are 1 + the smallest particle id
    const std::uint64_t body = (label - 1) >> idBits;
    if (body == last || body >= scene.bodies.size()) continue;
    last = body;
    w.push_back(fmt::format(
        "the surface of the liquid body '{}' merges its layers where they are closer than about {} spacings: "
        "`surface.particle_support = 1` separates layers of particles at a distance of two spacings",
        scene.bodies[body].name, std::lround(scene.numerics.support * scene.surface.particleSupport) - 1));
  }
  return w;
}

std::vector<std::string> pieceWarnings(const Scene& scene, const std::vector<BodyPieces>& pieces) {
  std::vector<std::string> w;
  for (const BodyPieces& p : pieces)
    if (p.body < scene.bodies.size())
      w.push_back(fmt::format(
          "body '{}' begins in {} pieces: between them its particles are farther apart than "
          "`surface.link_length = {:g}` spacings{}, though less than two; a finer spacing joins them",
          scene.bodies[p.body].name, p.pieces, scene.surface.linkLength,
          scene.numerics.bondSupport < 1.732
              ? fmt::format(" and `numerics.bond_support = {:g}`", scene.numerics.bondSupport)
              : ""));
  return w;
}

std::vector<std::string> surfaceWarnings(const SurfaceSummary& s) {
  std::vector<std::string> w;
  for (const Correction& c : correctionsOf(s))
    if (!c.isMinor()) w.push_back(c.text + c.advice);
  if (s.counters.capped > 0)
    w.push_back(
        fmt::format("{} updates of the surface reached their limit of births and deaths", s.counters.capped));
  if (const std::string line = volumeErrorWarning(s.volumeErrors); s.keepsVolume && !line.empty())
    w.push_back(line);
  return w;
}

}  // namespace thaw
