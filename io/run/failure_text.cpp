// SPDX-License-Identifier: Apache-2.0
#include "io/run/failure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/domain/emit.hpp"
#include "core/simulation/monitor/force_terms.hpp"
#include "core/simulation/time/integrate.hpp"

namespace thaw {

std::string shortVectorText(const Vec3d& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

namespace {

/// Returns a value above a limit, with so many digits that they differ.
std::string above(double limit, double value) {
  int digits = 3;
  while (digits < 17 && fmt::format("{:.{}g}", value, digits) == fmt::format("{:.{}g}", limit, digits))
    digits++;
  return fmt::format("{:.{}g}", value, digits);
}

std::string seen(const World& w, const StepTools& t, const StepOutcome& o, const FailingParticle& s) {
  const MonitorLimits& b = t.limits.monitor;
  switch (o.failure) {
    case Failure::NotFinite:
      return s.value < never
                 ? fmt::format("a speed of {:.4g} m/s, more than a support radius in a step", s.value)
                 : "a value that is not a finite number";
    case Failure::Speed:
      return fmt::format(
          "a speed of {} m/s exceeds the limit of {:.6g} m/s (factor `numerics.watch_speed = {:g}`, with "
          "{:.3g} m/s expected)",
          above(b.speed, s.value), b.speed, w.scene.numerics.watchSpeed, b.expected);
    case Failure::Density:
      return fmt::format("a density of {} times the rest density exceeds `numerics.watch_density` ({})",
                         above(b.relativeDensity, s.value), b.relativeDensity);
    case Failure::Inverted:
      return fmt::format(
          "the fraction of inverted solid particles exceeds `numerics.watch_inverted` ({:.3g}), with det F "
          "down "
          "to {:.3g}",
          b.inverted, s.value);
    case Failure::Energy:
    case Failure::Growth:
      return fmt::format("{}; the particle with the largest gain has {:.4g} J/kg", failedCheck(w, t, o),
                         s.value);
    case Failure::Step:
    case Failure::None: break;
  }
  return failedCheck(w, t, o);
}

}  // namespace

std::string failedCheck(const World& w, const StepTools& t, const StepOutcome& o) {
  const MonitorLimits& b = t.limits.monitor;
  switch (o.failure) {
    case Failure::NotFinite:
      return "a value is not a finite number, or a particle moved beyond the reach of its forces in a step";
    case Failure::Speed:
      return fmt::format("a speed exceeds the limit of {:.6g} m/s (factor `numerics.watch_speed = {:g}`)",
                         b.speed, w.scene.numerics.watchSpeed);
    case Failure::Density:
      return fmt::format("a density exceeds `numerics.watch_density` ({} times the rest density)",
                         b.relativeDensity);
    case Failure::Step:
      return fmt::format(
          "the time step, limited by {}, fell to {:.3g} s{}, below `numerics.watch_step` ({:.3g} s)",
          limitNames[static_cast<std::size_t>(o.limitedBy)], w.clock.dt,
          w.monitor.backoff > 0 ? fmt::format(", halved {} times", w.monitor.backoff) : "", b.step);
    case Failure::Inverted:
      return fmt::format(
          "the fraction of inverted solid particles exceeds `numerics.watch_inverted` ({:.3g})", b.inverted);
    case Failure::Energy:
      return fmt::format(
          "unexplained gain of mechanical energy since step {}, more than {:.3g} times the largest term of "
          "the ledger (`numerics.watch_energy`)",
          w.monitor.snapshotStep, b.energy);
    case Failure::Growth:
      return fmt::format(
          "unexplained gain of mechanical energy since the run began, more than {:.3g} times the largest "
          "term of the ledger (`numerics.watch_energy`), gained gradually",
          b.energy);
    case Failure::None: break;
  }
  return "nothing";
}

std::string failureText(World& w, StepTools& t, const StepOutcome& o, const FailingParticle& s) {
  const Continuum& p = w.particles;
  const std::size_t i = s.row, source = sourceOf(p.id[i]), bodies = w.scene.bodies.size();
  const std::string name = source < bodies ? "body '" + w.scene.bodies[source].name
                                           : "emitter '" + w.scene.emitters[source - bodies].name;
  std::string line = fmt::format(
      "{}: particle {} of {}' at {} m has a velocity of {} m/s and a force of {} N", seen(w, t, o, s),
      numberOf(p.id[i]), name, shortVectorText(p.position[i]), shortVectorText(p.velocity[i]),
      shortVectorText(forceOf(w.particles, w.scene, i)));
  const ForceTerms f = forceTerms(w, t, i);
  std::vector<std::pair<double, std::string>> terms;
  const auto add = [&](bool has, const char* term, double size) {
    if (has) terms.push_back({std::isnan(size) ? never : size, fmt::format("{} {:.3g} N", term, size)});
  };
  const Modules& m = w.modules;
  add(m.fluid, m.tension ? "pressure and surface tension" : "pressure", f.pressure);
  add(m.fluid, "viscosity", f.viscosity);
  add(m.solid, "elastic", f.elastic);
  add(m.contact, "contact", f.contact);
  add(!w.walls.list.empty(), "walls", f.walls);
  add(w.particles.outsideForce.active, "outside", f.outside);
  add(true, "weight", f.weight);
  std::stable_sort(terms.begin(), terms.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  line += " (";
  for (std::size_t k = 0; k < terms.size(); k++) line += (k ? ", " : "") + terms[k].second;
  line += f.atWall ? "; it is at a wall)" : ")";
  if (p.phase[i] == Liquid && p.relativeDensity.active)
    line += fmt::format(", density {:.3g} of that at rest", static_cast<double>(p.relativeDensity[i]));
  if (p.solidIndex.active && p.solidIndex[i] != noSolid && p.solidIndex[i] < w.solids.owned)
    line += fmt::format(", det F {:.3g}", determinant(w.solids.deformation[p.solidIndex[i]]));
  return line;
}

std::string broadcastFromOwner(const Communicator& comm, const std::string& mine) {
  int owner = mine.empty() ? -1 : comm.rank(), length = static_cast<int>(mine.size());
  MPI_Allreduce(MPI_IN_PLACE, &owner, 1, MPI_INT, MPI_MAX, comm.handle());
  if (owner < 0) return {};
  MPI_Bcast(&length, 1, MPI_INT, owner, comm.handle());
  std::string text = mine;
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, owner, comm.handle());
  return text;
}

}  // namespace thaw
