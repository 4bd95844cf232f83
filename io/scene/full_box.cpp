#include "io/scene/full_box.hpp"

#include "core/scene/full_box.hpp"

namespace thaw {

void chooseForFullBox(Scene& s, const OpenChoices& open) {
  Numerics& n = s.numerics;
  if (n.pressure != PairForm::Consistent || !liquidFillsTheBox(s)) return;
  const bool mayRelax = open.packing && length(s.bodies[0].temperatureGradient) == 0;
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

void chooseForLiquids(Scene& s, const OpenChoices& open) {
  Numerics& n = s.numerics;
  const bool equation = n.pressure == PairForm::Consistent && n.solver == PressureSolver::StateEquation;
  if (!equation || s.quality == Quality::Preview || liquidFillsTheBox(s) || someSurfaceTension(s)) return;
  if (open.density) n.density = DensityForm::Continuity;
  if (n.density != DensityForm::Continuity) return;
  if (open.shifting) n.shifting = length(s.domain.gravity) > 0 ? 0.07 : 0.2;
  if (open.tensileLimit && n.shifting > 0) n.tensileLimit = 1;  // which alone makes particles clump
}

}  // namespace thaw
