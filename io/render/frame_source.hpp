// Frames on disk, for pictures: which there are, and what a picture needs of one.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/export/whole_component.hpp"
#include "io/render/kind_view.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// Which frames of a run: of its particles of its surface (surfels), or of its oriented particles. Automatic:
/// of the surface if there are any.
enum class FrameKind { Automatic, Particles, Surface, Oriented, Sheet };

/// The frames that `path` stands for, in the order of time: a frame file (.hdf) itself, those of a series
/// index (.hdf.series), or those of a folder, which may be a run's folder or its frames/. In a folder, the
/// files of an index count; without one, all .hdf files in the order of their names; frames of surfaces
/// without an index of their own always. Throws IoError naming the path if there are none, or none of the
/// kind asked for.
std::vector<std::filesystem::path> findFrames(const std::filesystem::path& path,
                                              FrameKind kind = FrameKind::Automatic);

/// Is it drawn as a surface: are its points surfels, or are there sheets beside it?
bool drawnAsSurface(const std::filesystem::path& frame);

/// Names of the fields that a frame has, and those of the sheets beside it, ascending. Throws IoError naming
/// the file and the cause.
std::vector<std::string> fieldsOf(const std::filesystem::path& frame, bool withSheets = true);

/// ReadFrame for VTKHDF frames. The field "speed" is the length of "velocity". Of surfels, "surface" asks for
/// the surface's own colours and "glow" for those turning into the temperature's. Sheets of the same moment
/// (NAME_sheet_000120.hdf) are drawn with a frame of surfels or particles, these then as balls of discs. What
/// crosses periodic sides of the domain is in one piece, moved by whole periods (whole_component.hpp), but
/// for what goes round. Throws IoError naming the file and the cause: not HDF5, truncated, not a frame, no
/// such field (with those there are).
FrameView readFrameView(const std::filesystem::path& frame, const std::string& field,
                        const PeriodicSides& sides = {});

/// The same with the further kinds of the run that lie beside it in the folder, drawn as discs. spacing: m,
/// of the particles. Of a frame of such a kind itself, that one alone.
FrameView readWholeView(const std::filesystem::path& frame, const std::string& field, OrientedLook look,
                        float spacing, const PeriodicSides& sides = {});

/// The scene as text that the run kept in the frame, and its name; empty if it has none.
struct KeptScene {
  std::string name, text;
};
KeptScene keptSceneOf(const std::filesystem::path& frame);

}  // namespace thaw
