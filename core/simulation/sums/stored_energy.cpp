// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sums/stored_energy.hpp"

#include "core/fluid/pair_sums/records.hpp"
#include "core/simulation/sums/solid_step.hpp"

namespace thaw {
namespace {

/// Adds the compression energy of a particle in scenes of one liquid (Modules::uniform).
void addCompression(World& w, const std::vector<LiquidMaterial>& liquids, std::size_t row) {
  w.particles.interaction[row] += compressionOf({w.scene, w.modules, w.grid, liquids}, w.particles, row, 1);
}

}  // namespace

void findStoredEnergy(World& w, const StepTools& t) {
  findElasticEnergy(w.solids, w.bonds, t.solid.elastic);
  if (w.interactionHasCompression) return;
  for (std::size_t i = 0; i < w.particles.owned; i++) addCompression(w, t.liquids, i);
  w.interactionHasCompression = true;
}

void findStoredEnergy(World& w, const StepTools& t, std::span<const std::uint32_t> rows) {
  if (w.modules.solid) findElasticEnergy(w.particles, w.solids, w.bonds, t.solid.elastic, rows);
  if (w.interactionHasCompression) return;
  for (const std::uint32_t i : rows) addCompression(w, t.liquids, i);
}

}  // namespace thaw
