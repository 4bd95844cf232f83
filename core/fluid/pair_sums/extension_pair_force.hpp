// SPDX-License-Identifier: Apache-2.0
// Forces of extensions between pairs of liquid particles (core/terms/extensions.hpp). The pair function is
// written once on lanes (core/fluid/terms/extension_pair_force_term.hpp).
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Values of an extension's keys (SI) in the order of their declaration, and lengths of the run.
struct PairConstants {
  const double* values = nullptr;
  double support = 0, spacing = 0;  ///< m
};

/// Input and output of the sweep of a pair force, besides PairSums::positionVolume and velocityViscosity.
struct PairForceSums {
  const void* records = nullptr;  ///< three values of PairForce::pack, and the liquid fraction
  PairConstants constants;
  double* energy = nullptr;  ///< J, half of each pair's energy; overwritten
};

/// Data of two particles for a single pair energy.
struct PairPoint {
  Vec3d distance{};           ///< m, own - other
  const double *own, *other;  ///< records
};

/// Functions of one pair force, from pairForceKernels<Law>() of each instruction set.
struct PairForceKernels {
  void (*sum)(const PairSums&, const PairForceSums&, GroupRange) = nullptr;
  double (*energy)(const PairConstants&, const PairPoint&) = nullptr;  ///< J, of a pair
};

/// Rows whose values a pair force packs.
struct PairPacking {
  const Scene& scene;
  const ExtensionSettings& settings;
  const Continuum& particles;
  std::size_t begin = 0, end = 0;
  Vec3d* values = nullptr;  ///< out: three values for each row of the range, from its own fields
};

/// A force between liquid particles closer than the support radius. It acts on both particles of a pair with
/// opposite signs, weighted by the product of their liquid fractions.
struct PairForce {
  PairForceKernels kernels;
  /// Packs values of particles that the pair function reads, such as coefficients of materials. Empty: zeros.
  /// It may read only fields with ghosts: position, velocity, mass, material, phase, liquid, temperature, and
  /// added fields with `ghosts`.
  std::function<void(const PairPacking&)> pack = {};
  /// Longest stable step (s). Empty: no limit.
  std::function<double(const ExtensionSettings&, const Scene&)> stepLimit = {};
};

/// A pair force of a scene.
struct PairForceWork {
  const PairForce* force = nullptr;
  const ExtensionSettings* settings = nullptr;
  std::vector<double> values;        ///< values of the keys, in their order
  AlignedVector<std::byte> records;  ///< Record of float or double by row, with the dummy row
  std::vector<Vec3d> packed;         ///< work
  std::vector<double> energy;        ///< J, by owned row
};

/// Returns the constants of a pair force in this scene. support: of the kernel (m).
inline PairConstants constantsOf(const Scene& scene, double support, const PairForceWork& work) {
  return {work.values.data(), support, scene.spacing};
}

/// Packs the records of rows [begin, end).
void packPairForce(const Scene& scene, const Continuum& particles, std::size_t begin, std::size_t end,
                   PairForceWork& work);
/// Makes room for `rows` rows and the dummy row behind them.
void resizePairForce(Precision precision, std::size_t rows, PairForceWork& work);
/// Clears the records of marked rows among the first `rows` rows, so that these rows have no pairs.
void clearPairRecords(Precision precision, const AddedColumn& mark, std::size_t rows, PairForceWork& work);
/// Returns the record of one row.
std::array<double, 4> pairRecordOf(const Scene& scene, const Continuum& particles, std::size_t row,
                                   const PairForceWork& work);

}  // namespace thaw
