// How many particles and vertices the further kinds of body will have, before they are made.
#pragma once
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

inline constexpr double mostRowsOfKind = 2e9;  ///< of a body: numbers of its points and vertices have 32 bits
                                               ///< while it is made

struct ExpectedRows {
  std::string name;  ///< "oriented body 'skin'"
  SourcePlace where;
  double rows = 0;             ///< particles or vertices, to a third
  double bytesEverywhere = 0;  ///< least memory (bytes) on each rank: all of them sample the body whole
  double bytesShared = 0;      ///< of all rows on their owners
  double spacing = 0;          ///< m, of the body
  bool ownSpacing = false;     ///< and not the scene's
  bool spread = false;  ///< its points make room for each other, in passes: some tenths of a millisecond each
  const char* word = "particles";  ///< or "vertices"
};

/// Of every oriented body and sheet of the scene, in 64-bit floating point, so that no spacing overflows. A
/// body whose shape or mesh cannot be made counts as empty: setting it up says what is wrong.
std::vector<ExpectedRows> expectedRows(const Scene& scene, const MeshLoader& load);

}  // namespace thaw
