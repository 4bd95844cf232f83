// The further kinds of body in a picture: drawn with small discs, so that they share light, shadow and depth
// with particles and surfels.
#pragma once
#include <filesystem>

#include "io/render/render_frames.hpp"

namespace thaw {

/// How oriented particles are drawn (ST92): a shaded triangulation, its wireframe, a disc for each, or its
/// three axes.
enum class OrientedLook { Mesh, Wire, Discs, Axes };
OrientedLook orientedLookNamed(const std::string& name);  ///< std::invalid_argument where there is none

/// Turns a view of particles into one of surfels: every sphere (radius m) becomes discs on it. Values go
/// along.
void spheresToDiscs(FrameView& view, float radius);

/// Adds discs to a view of surfels: from each side, as an open surface has two. value NaN: it shows its own
/// colour.
void addDisc(FrameView& view, const Vec3f& place, const Vec3f& normal, float radius, Rgb colour,
             std::uint32_t component, bool twoSided);
void addBall(FrameView& view, const Vec3f& place, float radius, Rgb colour, std::uint32_t component);

/// Adds a frame of oriented particles.
void addOriented(FrameView& view, const std::filesystem::path& frame, OrientedLook look);

/// The same, to a view of what else there is.
void addKindBeside(FrameView& view, const std::filesystem::path& oriented, OrientedLook look, float spacing);

}  // namespace thaw
