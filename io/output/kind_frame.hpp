// Frames of the further kinds, beside those of the particles: NAME_oriented_000120.hdf,
// NAME_sheet_000120.hdf, each kind with an index of its own.
#pragma once
#include "core/halo/halo.hpp"
#include "core/kinds/kinds.hpp"
#include "io/output/surface_frame.hpp"

namespace thaw {

/// The name under which a scene's frames of a kind are numbered and indexed.
inline std::string kindFrameName(const std::string& scene, std::size_t kind) {
  return scene + "_" + kindNames[kind];
}

/// The owned rows of a kind: position, id, velocity, its body as <kind>_body, and what is the kind's own. In
/// single precision.
Frame kindFrameOf(const World& world, std::size_t kind);

/// What a kind adds (io/output/oriented_frame.cpp, io/output/sheet_frame.cpp).
void addOrientedFields(const World& world, Frame& frame);
void addSheetFields(const World& world, Frame& frame);

/// The triangles of the sheets; firstRow: number over all ranks of this rank's first row. Collective.
void addSheetTriangles(World& world, BondHalo& edges, std::uint64_t firstRow, Frame& frame);

/// What the points of a frame are: "particles", "surfels", "oriented" or "sheet". A frame of a kind has a
/// field "<kind>_body".
std::string titleOfFrame(const H5File& file);

}  // namespace thaw
