// SPDX-License-Identifier: Apache-2.0
#include "io/commands/check/frontier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/scene/expected_speeds.hpp"
#include "core/terms/find_modules.hpp"
#include "io/commands/check/chosen_numerics.hpp"

namespace thaw {
namespace {

/// Reference case of a part of the model; frontier.py has the same list. has: whether the scene uses this
/// part. fits: whether its motion is also like that of the case, so that the case's settings may be advised.
struct ReferenceCase {
  const char* part;
  std::string cases;
  bool (*has)(const Scene&, const Modules&);
  bool (*fits)(const Scene&) = [](const Scene&) { return true; };
};

bool viscous(const Scene& s, const Modules& m) {
  for (const Material& x : s.materials)
    if (m.fluid && (x.viscosity.liquid > 0 || !x.viscosityTable.empty() || m.flowLaw)) return true;
  return false;
}

bool isLiquid(const Scene& s, const Body& b) {
  const Material& m = s.materials[static_cast<std::size_t>(b.material)];
  return !m.canBeSolid() || m.liquidAtStart;
}

/// Returns whether all liquid is at most as fast as a fall through the domain. The suite has no liquid that
/// is torn or spun from the start.
bool isGentle(const Scene& s) {
  const double size = length(s.domain.max - s.domain.min), most = fallSpeed(s.domain);
  double fastest = 0;
  for (const Body& b : s.bodies)
    if (isLiquid(s, b)) fastest = std::max(fastest, length(b.velocity) + 0.5 * length(b.spin) * size);
  for (const Emitter& e : s.emitters) fastest = std::max(fastest, e.speed);
  for (const Obstacle& o : s.obstacles) fastest = std::max(fastest, fastestMove(o.motion));
  return fastest <= most;
}

/// Returns whether a box of liquid ends at walls or periodic sides across gravity, so that it stays in place.
bool isConfined(const Scene& s, const Body& b) {
  if (b.shape.kind != ShapeKind::Box || !(b.shape.rotate == Vec3d{}) || b.shape.fitHeight || b.shape.bottom)
    return false;
  for (int a = 0; a < 3; a++) {
    if (std::abs(s.domain.gravity[a]) > 0) continue;
    const double half = 0.5 * b.shape.scale * b.shape.size[a];
    const auto& sides = s.domain.side[static_cast<std::size_t>(a)];
    if (sides[0] == Side::Open || b.shape.move[a] - half > s.domain.min[a] + s.spacing) return false;
    if (sides[1] == Side::Open || b.shape.move[a] + half < s.domain.max[a] - s.spacing) return false;
  }
  return true;
}

/// Returns whether there is liquid under gravity.
bool isHeavy(const Scene& s, const Modules& m) { return m.fluid && length(s.domain.gravity) > 0; }

bool isAtRest(const Scene& s) {
  if (!s.emitters.empty()) return false;
  for (const Obstacle& o : s.obstacles)
    if (fastestMove(o.motion) > 0) return false;
  return std::ranges::all_of(s.bodies, [&](const Body& b) {
    return !isLiquid(s, b) || (b.velocity == Vec3d{} && b.spin == Vec3d{} && isConfined(s, b));
  });
}

bool hasElastic(const Scene& s, const Modules& m) {
  return m.solid && std::any_of(s.materials.begin(), s.materials.end(),
                                [](const Material& x) { return x.canBeSolid() && !x.isRigid(); });
}

const std::vector<ReferenceCase>& referenceCases() {
  static const std::vector<ReferenceCase> all{
      {"liquid at rest", "hydrostatic", isHeavy, isAtRest},
      {"liquid that falls", "martin_moyce", isHeavy, isGentle},
      {"viscosity", "poiseuille", viscous, isGentle},
      {"surface tension", "drop_laplace", [](const Scene&, const Modules& m) { return m.tension; }},
      {"solids", "cantilever", hasElastic},
      {"waves in solids", "p_wave", hasElastic},
      {"a solid in a liquid", "stiff_in_soft",
       [](const Scene& s, const Modules& m) { return hasElastic(s, m) && m.fluid; }},
      {"heat", "conductivity_ratio", [](const Scene&, const Modules& m) { return m.heat; }},
      {"melting", "stefan_two_phase", [](const Scene&, const Modules& m) { return m.melting; }},
  };
  return all;
}

std::string keyOf(const std::string& setting) { return setting.substr(0, setting.find('=')); }

double valueOf(const std::string& setting) { return std::stod(setting.substr(setting.find('=') + 1)); }

/// Returns whether contact of solids limits all steps, so that substeps gain nothing.
bool contactLimits(Scene s, const Modules& m) {
  s.numerics.elasticSubsteps = 2;
  return m.contact && !modulesOf(s).rareContact;
}

/// Returns whether the scene can use this setting. With many substeps, liquids pump energy into solids
/// unlike those of the reference case.
bool usable(const std::string& setting, const Scene& s, const Modules& m) {
  constexpr double mostSubsteps = 4;
  if (keyOf(setting) == "numerics.elastic_substeps")
    return (!m.fluid || valueOf(setting) <= mostSubsteps) && !contactLimits(s, m);
  if (keyOf(setting) == "body.0.packing") return false;  // the scene determines the packing
  if (keyOf(setting) == "numerics.support")
    return valueOf(setting) >= (m.surfaceHeat ? 2 : m.solid ? s.numerics.bondSupport : 0);
  return true;
}

/// Replaces the * of a setting by the name of each material that can be solid.
std::vector<std::string> ofScene(const std::string& setting, const Scene& s) {
  const std::size_t star = setting.find('*');
  if (star == std::string::npos) return {setting};
  std::vector<std::string> all;
  for (const Material& m : s.materials)
    if (m.canBeSolid() && !m.isRigid())
      all.push_back(setting.substr(0, star) + m.name + setting.substr(star + 1));
  return all;
}

/// Error and cost of a setting in one case, over those of the defaults.
struct Gain {
  const char* part = "";
  double error = never, cost = never;
};

/// Errors and costs of a setting over the cases that the scene resembles.
struct Record {
  double worst = 0, product = 1, slowest = 0, time = 1;
  Gain closest, fastest;  // cases with the largest gain
  void add(const Gain& g) {
    worst = std::max(worst, g.error), product *= g.error;
    slowest = std::max(slowest, g.cost), time *= g.cost;
    if (g.error < closest.error) closest = g;
    if (g.cost < fastest.cost) fastest = g;
  }
};
using Records = std::map<std::string, Record>;

/// Returns whether two settings can be combined. Keys of the equation of state have no effect with the
/// incompressible solver.
bool together(const std::string& a, const std::string& b) {
  const auto solver = [](const std::string& s) { return s == "numerics.pressure_solver=incompressible"; };
  const auto ofState = [](const std::string& s) {
    const std::string k = keyOf(s);
    return k == "numerics.density" || k == "numerics.cfl_sound" || k == "numerics.tensile_limit" ||
           k == "numerics.shifting" || k == "numerics.pressure";
  };
  return keyOf(a) != keyOf(b) && !(solver(a) && ofState(b)) && !(solver(b) && ofState(a));
}

/// Returns compatible settings of ascending score, one per key. Only scores below 1 count.
template<class Score> std::vector<std::string> choose(const Records& records, Score score) {
  std::vector<std::pair<double, std::string>> ranked;
  for (const auto& [setting, r] : records)
    if (const double x = score(r); x < 1) ranked.push_back({x, setting});
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> chosen;
  for (const auto& [x, setting] : ranked)
    if (std::all_of(chosen.begin(), chosen.end(),
                    [&, &setting = setting](const std::string& c) { return together(c, setting); }))
      chosen.push_back(setting);
  return chosen;
}

/// Returns the settings of the cases that the scene resembles.
Records recordsOf(FrontierPoints points, const Scene& s, const Modules& m) {
  Records records;
  for (const ReferenceCase& like : referenceCases()) {
    if (!like.has(s, m) || !like.fits(s)) continue;
    double usual = 0;
    for (const FrontierPoint& p : points) {
      if (like.cases != p.cases) continue;
      const std::string& set = p.settings;
      if (set.empty()) usual = p.error;  // the defaults are the first point of a case
      else if (usable(set, s, m) && keyOf(set) != "quality" && !isChosen(keyOf(set), s.numerics))
        records[set].add({like.part, p.error < 0 ? never : usual > 0 ? p.error / usual : 1, p.cost});
    }
  }
  return records;
}

/// Returns "the same error", "0.69 of the time" or "1.2 times the time".
std::string ratioText(double ratio, const char* of) {
  const std::string digits = fmt::format("{:.2g}", ratio);
  if (digits == "1") return std::string("the same ") + of;
  return digits + (ratio < 1 ? " of the " : " times the ") + of;
}

}  // namespace

std::string settingList(const std::vector<std::string>& settings, const char* before) {
  std::string text;
  for (const std::string& s : settings)
    text += (text.empty() ? "" : " ") + (before + (s.find(' ') == std::string::npos ? s : "'" + s + "'"));
  return text;
}

std::vector<std::string> frontierLines(FrontierPoints points, const Scene& s, const Modules& m) {
  std::vector<std::string> lines;
  for (const ReferenceCase& like : referenceCases()) {
    if (!like.has(s, m)) continue;
    std::string line;
    for (const FrontierPoint& p : points) {
      const std::string& set = p.settings;
      if (like.cases != p.cases || !p.best || !usable(set, s, m)) continue;
      line += fmt::format("{}{} {:.2g} % ({})", line.empty() ? "" : "; ",
                          set.empty() ? "defaults" : settingList(ofScene(set, s), ""), 100 * p.error,
                          ratioText(p.cost, "time"));
    }
    if (!line.empty()) lines.push_back(fmt::format("{} ({}): {}", like.part, like.cases, line));
  }
  return lines;
}

std::vector<Suggestion> frontierAdvice(FrontierPoints points, const Scene& s, const Modules& m) {
  const Records records = recordsOf(points, s, m);
  std::vector<Suggestion> all;
  const auto suggest = [&](const char* what, const std::vector<std::string>& settings, Gain Record::*gain) {
    for (const std::string& set : settings) {
      const std::vector<std::string> ofThis = ofScene(set, s);
      if (std::any_of(all.begin(), all.end(), [&](const Suggestion& a) { return a.settings == ofThis; }))
        continue;  // both more accurate and faster
      const Gain& g = records.at(set).*gain;
      all.push_back({ofThis, fmt::format("{} {} ({}: {}, {})", what, settingList(ofThis, "--set "), g.part,
                                         ratioText(g.error, "error"), ratioText(g.cost, "time"))});
    }
  };
  // No case may lose more than 2 % of accuracy, or 5 % of time for "faster". One case must gain 10 %.
  suggest(
      "more accurate:",
      choose(records,
             [](const Record& r) { return r.worst <= 1.02 && r.closest.error < 0.9 ? r.product : never; }),
      &Record::closest);
  suggest("faster:       ",
          choose(records,
                 [](const Record& r) {
                   return r.worst <= 1.02 && r.slowest <= 1.05 && r.fastest.cost < 0.9 ? r.time : never;
                 }),
          &Record::fastest);
  return all;
}

}  // namespace thaw
