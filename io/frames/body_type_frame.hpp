// SPDX-License-Identifier: Apache-2.0
// Frames of oriented bodies and sheets: NAME_oriented_000120.hdf, NAME_sheet_000120.hdf, each type with its
// own index.
#pragma once
#include "core/halo/halo.hpp"
#include "core/simulation/world/body_types.hpp"
#include "io/frames/surface_frame.hpp"

namespace thaw {

/// Returns the name of the frames and the index of a body type.
inline std::string bodyTypeFrameName(const std::string& scene, std::size_t kind) {
  return scene + "_" + bodyTypeNames[kind];
}

/// Returns a frame of the owned rows of a body type: position, id, velocity, body as <type>_body, and its own
/// fields. In single precision.
Frame bodyTypeFrameOf(const World& world, std::size_t kind);

/// Add the fields of a body type (io/frames/oriented_frame.cpp, io/frames/sheet_frame.cpp).
void addOrientedFields(const World& world, Frame& frame);
void addSheetFields(const World& world, Frame& frame);

/// Adds the triangles of the sheets. firstRow: number over all ranks of the first row of this rank.
/// Collective.
void addSheetTriangles(SheetBodies& sheets, BondHalo& edges, std::uint64_t firstRow, Frame& frame);

/// Returns the type of the points of a frame: "particles", "surfels", "oriented" or "sheet". Frames of the
/// last two have a field "<type>_body".
std::string pointTypeOf(const H5File& file);

}  // namespace thaw
