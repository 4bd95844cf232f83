// SPDX-License-Identifier: Apache-2.0
// Surface tension as a force on the particles of the free surface (M00; docs/theory/surface_tension.md):
//   F_i = f_i A_i (-gamma_i kappa_i n_i + grad_s gamma_i)
// with liquid fraction f, area A of the surface element, curvature kappa and outward normal n.
//
// Unlike the surface energy, this force has no potential and no pair form. Its work is recorded like that of
// an external force, and so is its net impulse.
#pragma once
#include "core/flow/curvature/surface_curvature.hpp"
#include "core/terms/outside_forces.hpp"

namespace thaw {

/// Adds the force to Continuum::force of liquid particles that are free to move, and stores it in
/// tensionForceOf. Collective. Requires: surfaceGradient of owned rows, temperatures of ghosts.
void addCurvatureForce(const CurvatureContext& context);

/// Adds the force of the last evaluation to free liquid particles, and clears the stored force of other
/// particles (core/flow/curvature/tension_interval.hpp).
void reuseCurvatureForce(Continuum& particles);

/// Records work and impulse of the force in a half kick over dt / 2 (s). Call it before the kick.
void recordCurvatureKick(const WallView& world, HalfKick kick, double dt);

}  // namespace thaw
