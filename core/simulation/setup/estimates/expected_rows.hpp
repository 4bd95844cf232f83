// SPDX-License-Identifier: Apache-2.0
// Estimates of the numbers of oriented particles and sheet vertices before they are created.
#pragma once
#include <string>
#include <vector>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

inline constexpr double mostRowsPerBody = 2e9;  ///< maximum per body; points and vertices have 32-bit numbers
                                                ///< during set-up

struct ExpectedRows {
  std::string name;  ///< "oriented body 'skin'"
  SourcePlace where;
  double rows = 0;                 ///< particles or vertices, accurate to a third
  double bytesEverywhere = 0;      ///< minimum memory (bytes) on each rank, since all ranks sample the whole
                                   ///< body
  double bytesShared = 0;          ///< memory (bytes) of all rows on their owners
  double spacing = 0;              ///< m, spacing of the body
  bool ownSpacing = false;         ///< true: the spacing differs from the scene's
  bool spread = false;             ///< true: its points are relaxed in passes of some tenths of a millisecond
                                   ///< each
  const char* word = "particles";  ///< or "vertices"
};

/// Returns the estimates for every oriented body and sheet, in 64-bit floating point so that no spacing
/// overflows. A body whose shape or mesh is unusable counts as empty; its set-up reports the error.
std::vector<ExpectedRows> expectedRows(const Scene& scene, const MeshLoader& load);

}  // namespace thaw
