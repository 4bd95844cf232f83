// SPDX-License-Identifier: Apache-2.0
// Area of free surface per particle, for convection and radiation (docs/theory/heat.md).
#pragma once
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Constants of the area, from sums over the lattice with the weight q (1 - q^2), q = r / reach.
struct ExposedAreaLaw {
  double reach = 1;      ///< support radii: two spacings, or the support radius if that is smaller
  double perVolume = 1;  ///< support radius cubed, in spacings^3
  double full = 0;       ///< sum of the weights inside of the lattice
  double face = 0;       ///< weights that a particle of a flat face lacks
  double asymmetry = 0;  ///< length of the sum of weights times directions, for such a particle
  bool fitted = true;    ///< true if the reach is two spacings: the area follows from fitted tables
  double log = 0;        ///< not fitted: chosen such that an edge has two faces
  double thin = 0;       ///< not fitted: chosen such that a plate of one layer has two faces
};
ExposedAreaLaw exposedAreaLaw(const Numerics& numerics);

/// Returns the area in units of spacing^2, 0 for disorder inside a liquid. sum: sum of the neighbours'
/// weights. asymmetry: length of the sum of weights times directions.
double areaOf(const ExposedAreaLaw& law, double sum, double asymmetry);

/// Returns the area that a flat wall covers, at a distance in spacings; 1 at half a spacing.
double coveredArea(const ExposedAreaLaw& law, double distance);

/// Returns 0 below an area of 0.18 and the area itself above 0.38, because disorder at walls gives small
/// values.
double clearArea(double area);

/// Sets `area` of the particles in the lists to areaOf.
void findExposedAreas(const PairSums& sums, const Numerics& numerics, float* area, GroupRange range);

}  // namespace thaw
