// SPDX-License-Identifier: Apache-2.0
// Meshes of surfaces of frames, for the reader of runs.
#pragma once
#include <string>

namespace thaw::python {

/// Writes the closed meshes of a frame of surfels as `thaw export FRAME --as ply --cell CELL` does, without
/// fields of particles. Throws IoError, and std::invalid_argument for a cell outside of 0.2 to 10. Called
/// without the interpreter's lock.
void writeSurfaceFile(const std::string& frame, const std::string& file, double cell);

}  // namespace thaw::python
