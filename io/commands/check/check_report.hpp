// SPDX-License-Identifier: Apache-2.0
// The results of `thaw check`, for people and for programs.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/commands/check/coarse_run.hpp"

namespace thaw {

/// A continuum body at the start.
struct CheckedBody {
  std::string name, material;
  std::int64_t particles = 0, clamped = 0;
  double mass = 0;                    ///< kg
  std::optional<double> shapeMass{};  ///< kg: density times volume of the shape; none after overlaps
  bool hasClamps = false;
};

struct CheckedEmitter {
  std::string name, material;
  double rate = 0;           ///< kg/s
  std::size_t perLayer = 0;  ///< particles
};

/// Sound speed of a liquid, m/s, and its reason.
struct CheckedSound {
  std::string material;
  double speed = 0;
  std::string reason;
};

/// Estimates for the whole run.
struct CheckedCost {
  int ranks = 1;
  double memoryPerRank = 0, bytesPerParticle = 0, surfaceBytesPerRank = 0;
  double steps = 0;
  double stepping = 0;                       ///< s
  double surfaceLeast = 0, surfaceMost = 0;  ///< s: if the liquid stays together, if it splashes
  double particleStepsPerSecond = 0;         ///< rate of one rank
  int measuredSteps = 0;
  std::optional<RunGrowth> growth{};  ///< after the measured steps; included in steps and stepping
  bool surface = false;
};

struct CheckReport {
  std::string path, title;
  double spacing = 0, support = 0, end = 0, every = 0;  ///< m, m, s, s
  int cells[3] = {0, 0, 0};
  std::vector<std::string> warnings;
  std::vector<CheckedBody> bodies;
  /// Names, and numbers of particles or vertices.
  std::vector<std::pair<std::string, std::int64_t>> oriented, sheets;
  std::string relaxation;  ///< note on a relaxation that the check omits, or ""
  std::vector<CheckedEmitter> emitters;
  double emitted = 0;  ///< particles of the emitters until the end
  std::vector<std::string> overlaps;
  std::int64_t removed = 0;  ///< particles left out of overlaps
  std::vector<std::string> modules;
  std::optional<double> step{};  ///< s; none: no limit at the start
  double longestStep = 0;        ///< s
  std::string limitedBy;
  std::int64_t substeps = 1;
  std::vector<std::pair<std::string, double>> limits;  ///< limits by the materials alone, s
  std::vector<CheckedSound> sounds;
  std::vector<std::string> flows;  ///< lines on flow laws
  bool allSettings = false;
  std::vector<std::string> advice, surface;  ///< lines
  CheckedCost cost;
};

void printReport(const CheckReport& report);

/// Returns the report as JSON, with SI units. docs/reference/files.md describes it.
std::string jsonReport(const CheckReport& report);

/// Returns the errors of an unusable scene as JSON: {"errors": [...]}.
std::string jsonErrors(const std::string& path, const std::string& lines);

}  // namespace thaw
