// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/ledger/stored_parts.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/particles/sleep_stage.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

enum Part : std::size_t { Gravity, Compression, Tension, Contact, parts };
using Sums = std::array<ExactSum, parts>;

double gravityOf(const Domain& domain, double mass, const Vec3d& place) {
  return -mass * dot(domain.gravity, place);
}

/// Adds the energies of particles. The relative density of sleeping particles is unknown, since their sums
/// may be skipped, so all their stored energy counts as contact.
void addParticles(const World& w, const std::vector<LiquidMaterial>& liquids, Sums& sums) {
  const Continuum& p = w.particles;
  const RecordContext context{w.scene, w.modules, w.grid, liquids};
  for (std::size_t i = 0; i < p.owned; i++) {
    sums[Gravity].add(gravityOf(w.scene.domain, p.mass[i], p.position[i]));
    if (!p.interaction.active) continue;
    const bool known = p.relativeDensity.active && !(p.sleep.active && p.sleep[i] != awake);
    const double liquid = liquidFraction(p, i);
    const double compression = known ? compressionOf(context, p, i, liquid) : 0;
    sums[Compression].add(compression);
    sums[p.phase[i] == Liquid ? Tension : Contact].add(p.interaction[i] - compression);
  }
}

}  // namespace

StoredParts storedParts(World& w, const StepTools& t, Reducer& all) {
  findStoredEnergy(w, t);
  Sums sums;
  addParticles(w, t.liquids, sums);
  forEachBodyType(w, [&](std::size_t, const BodyTypeRows& r, const CellTable&) {
    for (std::size_t i = 0; i < r.owned; i++)
      sums[Gravity].add(gravityOf(w.scene.domain, r.mass[i], r.position[i]));
  });
  std::vector<std::int64_t> digits;
  for (ExactSum& s : sums) {
    s.carry();
    digits.insert(digits.end(), s.digit.begin(), s.digit.end());
  }
  all.sum(digits);
  for (std::size_t k = 0; k < parts; k++)
    std::copy_n(digits.data() + k * ExactSum::digits, ExactSum::digits, sums[k].digit.data());
  return {sums[Gravity].value(), sums[Compression].value(), sums[Tension].value(), sums[Contact].value()};
}

}  // namespace thaw
