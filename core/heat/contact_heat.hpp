// SPDX-License-Identifier: Apache-2.0
// Heat between bodies whose contact has a given conductance (docs/theory/heat.md). The conduction sum
// (core/fluid/terms/conduction.hpp) treats all pairs as one body. For pairs across a contact, these sums
// replace that flow by the flow through resistances in series. These are z/k of the bodies and 1/h of the
// contact. z is the distance along the contact normal.
#pragma once
#include <cstddef>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Records of all rows and of the dummy row after them, in the precision of the pair sums (float or double).
struct ContactHeatWork {
  AlignedVector<std::byte> ends;   ///< body index; 1 if liquid, else 0
  AlignedVector<std::byte> faces;  ///< Continuum::contactNormal; resistance of its material (m^2 K/W)
  double spacing = 1;              ///< m
};

/// Input and output of the sums besides PairSums.
struct ContactHeatSums {
  const void *ends = nullptr, *faces = nullptr;
  Vec3f* normal = nullptr;  ///< 1, overwritten
  double spacing = 1;       ///< m
};

struct ContactHeatKernels {
  const char* name;                                                      ///< "avx512", "avx2", "base"
  void (*normals)(const PairSums&, const ContactHeatSums&, GroupRange);  ///< sets `normal`
  void (*heat)(const PairSums&, const ContactHeatSums&, GroupRange);     ///< adds to PairSums::heatFlow
};

/// Returns the set of that name, or the best one for this processor if the name is empty. Returns nullptr for
/// unknown or unsupported names.
const ContactHeatKernels* contactHeatKernels(const char* name = "");

/// Sets Continuum::contactNormal of the particles in the lists. Particles are in contact if their bodies
/// differ and at most one of them is liquid.
/// Requires: packed positions of all rows. rows: number of rows before the dummy row.
void findContactNormals(const PairSums& sums, std::size_t rows, Continuum& particles, ContactHeatWork& work);

/// Packs the normals and resistances of rows [begin, end).
void packContactFaces(const Scene& scene, const Continuum& particles, std::size_t begin, std::size_t end,
                      ContactHeatWork& work);

/// Distances along the normal, in spacings. Pairs closer than `touching` are in contact. Pairs farther than
/// `apart` exchange no heat. Touching particles have a distance of one spacing; mechanical contact starts at
/// 1.1.
inline constexpr double touching = 1.2, apart = 1.5;

/// Corrects heatFlow (W) for the contacts of these groups, after the conduction sum. A pair has the larger of
/// its materials' contact resistances. Both particles compute the same flow with opposite sign.
void addContactHeat(const PairSums& sums, const ContactHeatWork& work, GroupRange range);

}  // namespace thaw
