#include "io/commands/frontier.hpp"

#include <fmt/format.h>

#include <cstring>

namespace thaw {
namespace {

/// The case that stands for a part of the model: what a scene with it does most.
struct Likeness { const char *part, *cases, *norm; bool (*has)(const Scene&, const Modules&); };

bool flows(const Scene&, const Modules& m) { return m.fluid; }
bool viscous(const Scene& s, const Modules& m) {
  for (const Material& x : s.materials)
    if (m.fluid && (x.viscosity.liquid > 0 || !x.viscosityTable.empty())) return true;
  return false;
}

constexpr Likeness likenesses[] = {
    {"pressure of liquids", "martin_moyce", "RMS(Z)", flows},
    {"viscosity", "poiseuille", "L2(u)", viscous},
    {"surface tension", "drop_laplace", "pressure jump", [](const Scene&, const Modules& m) { return m.tension; }},
    {"solids", "cantilever", "deflection", [](const Scene&, const Modules& m) { return m.solid; }},
    {"waves in solids", "p_wave", "P speed at 20 dx", [](const Scene&, const Modules& m) { return m.solid; }},
    {"a solid in a liquid", "stiff_in_soft", "energy residual", [](const Scene&, const Modules& m) { return m.solid && m.fluid; }},
    {"heat", "conductivity_ratio", "Linf(T)", [](const Scene&, const Modules& m) { return m.heat; }},
    {"melting", "stefan_two_phase", "front", [](const Scene&, const Modules& m) { return m.melting; }},
};

}  // namespace

std::vector<std::string> frontierLines(const Scene& s, const Modules& m) {
  std::vector<std::string> lines;
  for (const Likeness& like : likenesses) {
    if (!like.has(s, m)) continue;
    std::string line;
    for (const FrontierPoint& p : frontierPoints())
      if (std::strcmp(p.cases, like.cases) == 0 && std::strcmp(p.norm, like.norm) == 0)
        line += fmt::format("{}{} {:.2g} % ({:.2g} times the time)", line.empty() ? "" : "; ", p.settings, 100 * p.error, p.cost);
    if (!line.empty()) lines.push_back(fmt::format("{} ({}): {}", like.part, like.cases, line));
  }
  return lines;
}

}  // namespace thaw
