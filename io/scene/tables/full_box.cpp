// SPDX-License-Identifier: Apache-2.0
#include "io/scene/tables/full_box.hpp"

#include <algorithm>
#include <cmath>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/kernels/lattice.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/scene/full_box.hpp"
#include "core/scene/material_use.hpp"

namespace thaw {

void chooseForFullBox(Scene& s, const OpenChoices& open) {
  Numerics& n = s.numerics;
  const bool everywhere = liquidFillsTheBox(s), closed = n.buoyancy == Buoyancy::Boussinesq;
  if (n.pressure != PairForm::Consistent || !(everywhere || closed)) return;
  const bool mayRelax = everywhere && open.packing && length(s.bodies[0].temperatureGradient) == 0;
  if (n.solver == PressureSolver::Incompressible) {
    if (mayRelax) s.bodies[0].packing = Packing::Relaxed;
    return;
  }
  if (open.density) n.density = DensityForm::Continuity;
  if (open.tensileLimit) n.tensileLimit = 1;
  if (n.density != DensityForm::Continuity) return;
  if (open.shifting) n.shifting = 0.2;
  if (mayRelax) s.bodies[0].packing = Packing::Relaxed;
}

namespace {

/// Adds artificial viscosity, so that the viscosity of a liquid corresponds to an alpha of at least 0.02, the
/// usual value for inviscid liquids (ACM12). An alpha corresponds to a viscosity of alpha c h rho / 10. The
/// value is lower in scenes with solids, since it drags coarse bodies.
void chooseArtificialViscosity(Scene& s, const OpenChoices& open) {
  const bool solids = std::any_of(s.materials.begin(), s.materials.end(),
                                  [](const Material& m) { return m.canBeSolid(); });
  const double least = solids ? 0.005 : 0.02;
  const std::vector<LiquidMaterial> liquids = liquidMaterials(s);
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    Material& m = s.materials[k];
    if (!canBeLiquid(m) || !open.artificialViscosity[k]) continue;
    const auto lowest = std::min_element(m.viscosityTable.begin(), m.viscosityTable.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const double viscosity = hasFlowLaw(m)                      ? leastFlowViscosity(s, m)
                             : lowest == m.viscosityTable.end() ? m.viscosity.liquid
                                                                : lowest->second;
    const double unit = liquids[k].soundSpeed * s.numerics.support * s.spacing * m.density / 10;
    m.artificialViscosity = std::max(0.0, least - viscosity / unit);
  }
}

/// Damps the sound in liquids that the disorder of moving particles excites. Flow without compression keeps
/// its energy.
void chooseBulkDamping(Scene& s, const OpenChoices& open) {
  constexpr double enough = 0.02;
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (canBeLiquid(s.materials[k]) && open.bulkDamping[k]) s.materials[k].bulkDamping = enough;
}

}  // namespace

namespace {

/// Returns whether the settings of the scene permit tension by curvature.
bool mayActByCurvature(const Scene& s, const OpenChoices& open) {
  const Numerics& n = s.numerics;
  const bool carried = open.density || n.density == DensityForm::Continuity,
             shifted = open.shifting || n.shifting > 0;
  return carried && shifted && n.support >= leastCurvatureSupport;
}

}  // namespace

void chooseForLiquids(Scene& s, const OpenChoices& open) {
  Numerics& n = s.numerics;
  if (n.pressure != PairForm::Consistent || s.quality == Quality::Preview || liquidFillsTheBox(s)) return;
  if (n.solver == PressureSolver::Incompressible) return chooseArtificialViscosity(s, open);
  const bool tension = someSurfaceTension(s);
  if (tension && open.tension && mayActByCurvature(s, open)) n.tension = TensionForm::Curvature;
  if (tension && n.tension != TensionForm::Curvature) return;
  if (open.density) n.density = DensityForm::Continuity;
  if (n.density != DensityForm::Continuity) return;
  if (open.shifting) n.shifting = length(s.domain.gravity) > 0 ? 0.07 : 0.2;
  if (open.tensileLimit && n.shifting > 0)
    n.tensileLimit = 1;  // tension without shifting makes particles clump
  chooseArtificialViscosity(s, open);
  chooseBulkDamping(s, open);
}

namespace {

double largestViscosity(const Scene& s, const Material& m) {
  if (hasFlowLaw(m)) return largestFlowViscosity(s, m);
  double largest = m.viscosity.liquid;
  for (const auto& point : m.viscosityTable) largest = std::max(largest, point.second);
  return largest;
}

}  // namespace

void chooseForThickLiquids(Scene& s, const OpenChoices& open) {
  Numerics& n = s.numerics;
  if (!open.viscosityCorrection || s.quality == Quality::Preview || n.viscosity != ViscosityForm::Pairwise ||
      n.pressure != PairForm::Consistent)
    return;
  const std::vector<LiquidMaterial> liquids = liquidMaterials(s);
  const double h = n.support * s.spacing, stable = n.cflViscous * stableViscousStep(n) * h * h;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& m = s.materials[k];
    const double bySound = n.cflSound * std::min(h, 2 * s.spacing) / liquids[k].soundSpeed;
    if (canBeLiquid(m) && inUse(s, k) && stable * m.density < largestViscosity(s, m) * bySound)
      n.viscosityCorrection = true;
  }
}

}  // namespace thaw
