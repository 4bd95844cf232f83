// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/totals.hpp"

namespace thaw {
namespace {

constexpr std::size_t balanceSums = 11, ledgerSums = 2 * balanceSums + 25,
                      worldCounts = sizeof(Counters) / sizeof(std::int64_t);
static_assert(sizeof(ExactBalance) == balanceSums * sizeof(ExactSum),
              "list the new sum in addBalance, and in valuesOf");
static_assert(sizeof(Ledger) ==
                  ledgerSums * sizeof(ExactSum) + sizeof(std::vector<SourceUse>) + sizeof(Balance),
              "list the new sum in sumsOf");
static_assert(worldCounts == 36, "list the new counter in countsOf");
static_assert(sizeof(SurfaceCounters) == 11 * sizeof(std::int64_t), "list the new counter in countsOf");
static_assert(sizeof(MonitorState) == 11 * sizeof(double), "list the new member in realsOf or countsOf");

void addBalance(std::vector<NamedSum>& list, ExactBalance& b, const char* const (&names)[balanceSums]) {
  ExactSum* const sums[balanceSums] = {&b.mass,
                                       &b.momentum[0],
                                       &b.momentum[1],
                                       &b.momentum[2],
                                       &b.angularMomentum[0],
                                       &b.angularMomentum[1],
                                       &b.angularMomentum[2],
                                       &b.kinetic,
                                       &b.elastic,
                                       &b.potential,
                                       &b.internal};
  constexpr const char* units[balanceSums] = {
      "kg", "kg m/s", "kg m/s", "kg m/s", "kg m^2/s", "kg m^2/s", "kg m^2/s", "J", "J", "J", "J"};
  for (std::size_t k = 0; k < balanceSums; k++) list.push_back({names[k], units[k], sums[k]});
}

}  // namespace

std::vector<NamedSum> sumsOf(Ledger& l) {
  std::vector<NamedSum> list;
  addBalance(list, l.entered,
             {"entered_mass", "entered_momentum_x", "entered_momentum_y", "entered_momentum_z",
              "entered_angular_momentum_x", "entered_angular_momentum_y", "entered_angular_momentum_z",
              "entered_kinetic", "entered_elastic", "entered_potential", "entered_internal"});
  addBalance(list, l.left,
             {"left_mass", "left_momentum_x", "left_momentum_y", "left_momentum_z", "left_angular_momentum_x",
              "left_angular_momentum_y", "left_angular_momentum_z", "left_kinetic", "left_elastic",
              "left_potential", "left_internal"});
  const NamedSum others[] = {{"dissipated", "J", &l.dissipated},
                             {"wall_work", "J", &l.wallWork},
                             {"wall_impulse_x", "N s", &l.wallImpulse[0]},
                             {"wall_impulse_y", "N s", &l.wallImpulse[1]},
                             {"wall_impulse_z", "N s", &l.wallImpulse[2]},
                             {"wall_force_x", "N", &l.wallForce[0]},
                             {"wall_force_y", "N", &l.wallForce[1]},
                             {"wall_force_z", "N", &l.wallForce[2]},
                             {"gravity_impulse_x", "N s", &l.gravityImpulse[0]},
                             {"gravity_impulse_y", "N s", &l.gravityImpulse[1]},
                             {"gravity_impulse_z", "N s", &l.gravityImpulse[2]},
                             {"heat_in", "J", &l.heatIn},
                             {"phase_jump", "J", &l.phaseJump},
                             {"restart_jump", "J", &l.restartJump},
                             {"lamps_given", "J", &l.lamps.given},
                             {"lamps_absorbed", "J", &l.lamps.absorbed},
                             {"lamps_reflected", "J", &l.lamps.reflected},
                             {"lasers_given", "J", &l.lasers.given},
                             {"lasers_absorbed", "J", &l.lasers.absorbed},
                             {"lasers_reflected", "J", &l.lasers.reflected},
                             {"regions_given", "J", &l.regions.given},
                             {"regions_absorbed", "J", &l.regions.absorbed},
                             {"regions_reflected", "J", &l.regions.reflected},
                             {"evaporated_mass", "kg", &l.evaporated},
                             {"vapour_heat", "J", &l.vapourHeat}};
  list.insert(list.end(), std::begin(others), std::end(others));
  return list;
}

std::vector<NamedCount> countsOf(Counters& c) {
  return {{"singular_neighbourhoods", &c.singularNeighbourhoods},
          {"broken_bonds", &c.brokenBonds},
          {"inverted", &c.inverted},
          {"softenedParticles", &c.softenedParticles},
          {"coincident_pairs", &c.coincidentPairs},
          {"crowded", &c.crowded},
          {"connected", &c.connected},
          {"connected_density", &c.connectedDensity},
          {"melted", &c.melted},
          {"frozen", &c.frozen},
          {"welds", &c.welds},
          {"rereferenced", &c.rereferenced},
          {"wall_projections", &c.wallProjections},
          {"left", &c.left},
          {"emitted", &c.emitted},
          {"evaporated", &c.evaporated},
          {"left_x_low", &c.leftThrough[0][0]},
          {"left_x_high", &c.leftThrough[0][1]},
          {"left_y_low", &c.leftThrough[1][0]},
          {"left_y_high", &c.leftThrough[1][1]},
          {"left_z_low", &c.leftThrough[2][0]},
          {"left_z_high", &c.leftThrough[2][1]},
          {"viscous_iterations", &c.viscousIterations},
          {"viscous_unfinished", &c.viscousUnfinished},
          {"density_iterations", &c.densityIterations},
          {"divergence_iterations", &c.divergenceIterations},
          {"oriented_births", &c.orientedBirths},
          {"oriented_deaths", &c.orientedDeaths},
          {"asleep", &c.sleeping},
          {"unsolved_pressures", &c.unsolvedPressures},
          {"contact_iterations", &c.contactIterations},
          {"contact_unfinished", &c.contactUnfinished},
          {"impacts_unfinished", &c.impactsUnfinished},
          {"broken_pieces", &c.brokenPieces},
          {"welded_pieces", &c.weldedPieces},
          {"retries", &c.retries}};
}

std::vector<NamedCount> countsOf(SurfaceCounters& c) {
  return {{"updates", &c.updates}, {"iterations", &c.iterations}, {"births", &c.births},
          {"deaths", &c.deaths},   {"splits", &c.splits},         {"merges", &c.merges},
          {"lost", &c.lost},       {"flipped", &c.flipped},       {"kept_normals", &c.keptNormals},
          {"capped", &c.capped},   {"unfinished", &c.unfinished}};
}

std::vector<NamedReal> realsOf(MonitorState& s) {
  return {{"factor", &s.factor},   {"residual", &s.residual},  {"scale", &s.scale},
          {"largest", &s.largest}, {"full_step", &s.fullStep}, {"passed", &s.passed}};
}

std::vector<NamedCount> countsOf(MonitorState& s) {
  return {{"backoff", &s.backoff},
          {"failures", &s.failures},
          {"required_snapshots", &s.requiredSnapshots},
          {"snapshots_since_change", &s.snapshotsSinceChange},
          {"good_step", &s.snapshotStep}};
}

std::vector<NamedValue> valuesOf(Balance& b) {
  return {{"mass", "kg", &b.mass},
          {"momentum_x", "kg m/s", &b.momentum.x},
          {"momentum_y", "kg m/s", &b.momentum.y},
          {"momentum_z", "kg m/s", &b.momentum.z},
          {"angular_momentum_x", "kg m^2/s", &b.angularMomentum.x},
          {"angular_momentum_y", "kg m^2/s", &b.angularMomentum.y},
          {"angular_momentum_z", "kg m^2/s", &b.angularMomentum.z},
          {"kinetic", "J", &b.kinetic},
          {"elastic", "J", &b.elastic},
          {"potential", "J", &b.potential},
          {"internal", "J", &b.internal}};
}

Ledger globalLedger(const Ledger& mine, Reducer& all) {
  Ledger sum = mine;
  const std::vector<NamedSum> list = sumsOf(sum);
  std::vector<std::int64_t> digits;
  digits.reserve(list.size() * ExactSum::digits);
  for (const NamedSum& s : list) {
    s.sum->carry();  // digits below 2^32 can be added over up to 2^31 ranks
    digits.insert(digits.end(), s.sum->digit.begin(), s.sum->digit.end());
  }
  for (const SourceUse& use : sum.sourceUse) digits.push_back(use.absorbed);
  all.sum(digits);
  for (std::size_t k = 0; k < sum.sourceUse.size(); k++)
    sum.sourceUse[k].absorbed = digits[list.size() * ExactSum::digits + k] > 0;
  for (std::size_t k = 0; k < list.size(); k++) {
    std::copy_n(digits.begin() + static_cast<std::ptrdiff_t>(k * ExactSum::digits), ExactSum::digits,
                list[k].sum->digit.begin());
    list[k].sum->carry();
  }
  return sum;
}

Counters globalCounters(const Counters& mine, Reducer& all) {
  Counters sum = mine;
  const std::vector<NamedCount> list = countsOf(sum);
  std::vector<std::int64_t> counts;
  for (const NamedCount& c : list) counts.push_back(*c.count);
  all.sum(counts);
  for (std::size_t k = 0; k < list.size(); k++) *list[k].count = counts[k];
  return sum;
}

}  // namespace thaw
