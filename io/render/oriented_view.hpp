// SPDX-License-Identifier: Apache-2.0
// Oriented particles and continuum spheres as small discs, so they share light, shadow and depth with
// surfels.
#pragma once
#include <filesystem>

#include "io/render/render_frames.hpp"

namespace thaw {

/// Styles of oriented particles (ST92): shaded triangulation, wireframe, one disc per particle, or three axes
/// per particle.
enum class OrientedLook { Mesh, Wire, Discs, Axes };
OrientedLook orientedLookNamed(const std::string& name);  ///< throws std::invalid_argument for an unknown
                                                          ///< name

/// Turns a view of particles into one of surfels: every sphere (radius m) becomes discs with its value.
void spheresToDiscs(FrameView& view, float radius);

/// Adds discs to a view of surfels; twoSided for open surfaces. Value NaN: own colour.
void addDisc(FrameView& view, const Vec3f& place, const Vec3f& normal, float radius, Rgb colour,
             std::uint32_t component, bool twoSided);
void addBall(FrameView& view, const Vec3f& place, float radius, Rgb colour, std::uint32_t component);

/// Adds a frame of oriented particles.
void addOriented(FrameView& view, const std::filesystem::path& frame, OrientedLook look);

/// Adds a frame of oriented particles to a view of other body types.
void addOrientedBeside(FrameView& view, const std::filesystem::path& oriented, OrientedLook look,
                       float spacing);

}  // namespace thaw
