// SPDX-License-Identifier: Apache-2.0
// An oriented body as the scene defines it ([[oriented]]): source of its particles, their interaction, and
// events.
#pragma once
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include "core/scene/factor_in_time.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

enum class OrientedSource { Surface, Patch, Disc, Points, Control, Curve };
enum class OrientedIntegrator { SymplecticEuler, RungeKutta, SemiImplicit };
enum class OrientedGrowth { None, Gaps, Borders };  // where new particles are created
enum class OrientedEventKind { Weld, Cut, Crease, Smooth };
enum class CutTool { Plane, Line, Box };

/// Constrains the particles that lie in a region at the start.
struct OrientedConstraint {
  SourcePlace where;
  Shape region;
  bool position = true, normal = false;
  std::vector<Keyframe> motion;  // prescribed motion of the constrained particles
  double until = never;          // s, end of the constraint
};

/// External load on the particles in a region over a time interval. It is a uniform force, an attraction to a
/// point, a pressure, or several of them.
struct OrientedField {
  SourcePlace where;
  bool everywhere = true;
  Shape region;           // used if not everywhere
  Vec3d acceleration{};   // N/kg, uniform
  Vec3d point{};          // m
  double attraction = 0;  // N/kg, maximum of the attraction, at radius / sqrt(5); negative: repulsion
  double radius = 0.1;    // m, radius beyond which the attraction is zero
  double pressure = 0;    // Pa, along the normals
  double from = 0, until = never;  // s
  FactorInTime inTime;             // 1, factor of all three loads
};

struct OrientedEvent {
  SourcePlace where;
  OrientedEventKind kind = OrientedEventKind::Cut;
  double time = 0;  // s
  CutTool tool = CutTool::Plane;
  Vec3d point{}, normal{1, 0, 0};  // m; plane
  std::vector<Vec3d> path;         // m, line of a cut or crease
  Vec3d direction{0, 0, -1};       // direction of the cut along a line
  Shape region;                    // box, and smoothing
  double radius = 0;  // m, radius of a crease (0: one spacing) or reach of a cut along a line (0: one support
                      // radius)
  std::string other;  // name of the body welded to this one
  int otherIndex = -1;
};

struct OrientedBody {
  std::string name;
  SourcePlace where;
  // Source of its particles.
  OrientedSource source = OrientedSource::Surface;
  Shape shape;                                // surface of the shape; other sources use only the placement
  double width = 1, depth = 1, radius = 0.5;  // m, patch or disc in z = 0, normals along z
  std::vector<Vec3d> points, normals;         // m; points or control points; normals are optional
  Vec3d from{}, to{1, 0, 0};                  // m, ends of a curve in y = 0
  double bulge = 0;                           // m, height of the curve's middle
  double thin = 1;  // 1, fraction of the samples that are kept and fixed in place; growth fills the rest
  std::optional<std::uint32_t> colour;  // red | green << 8 | blue << 16; none: orientedColours by body number
  double spacing = 0;                   // m, target distance between its particles; 0: the scene's spacing
  double cellShare = 1;  // 1, area of a particle over that of a cell of a hexagonal lattice. Set at set-up
                         // for patches and discs
  double jitter = 0;   // 1, largest initial offset of positions (in spacings) and normals (in rad) along each
                       // axis
  Vec3d velocity{};    // m/s
  double density = 1;  // kg/m^2
  double inertia = 0.25;  // 1, moment of inertia of a particle, over its mass times the squared spacing
  // Potentials (ST92).
  double stiffness = 10;  // N/m; an energy is a weight times stiffness times the squared spacing
  double attract = 1, plane = 1, normal = 0.5, circle = 1;  // 1, weights of the four potentials
  std::int64_t repelPower = 12, attractPower = 6;           // 1, exponents n, m of Lennard-Jones
  double core = 0.7;  // 1, distance in spacings below which Lennard-Jones is linear (stability row 33)
  double across = 1, along = 0.5;  // spacings, a and b of the weighting function
  double support = 3;              // spacings, radius of the pair forces
  bool facing = true;              // particles with opposing normals do not interact (stability row 33)
  bool planar = false;             // moves and rotates in y = constant only
  // Loads, contact and time integration.
  double damping = 1, spinDamping = 1;  // 1/s
  double pressure = 0;                  // Pa, along the normals
  Vec3d acceleration{};                 // N/kg
  double contact = 2;                   // 1, contact stiffness, over `stiffness`
  double thickness = 0.5;               // spacings, distance kept from obstacles
  double friction = 0.2;                // 1
  OrientedIntegrator integrator = OrientedIntegrator::SymplecticEuler;
  double cfl = 0.25;       // 1, time step over the longest stable step of the integrator
  std::int64_t relax = 0;  // largest number of relaxation iterations before the start
  // Births and deaths.
  OrientedGrowth growth = OrientedGrowth::None;
  double gap = 1.5;             // spacings, distance between neighbours above which a particle is inserted
  double removalDistance = 0;   // spacings, distance below which one of two particles is removed; 0: never
  std::int64_t every = 10;      // steps between checks for births and deaths
  std::int64_t most = 1000000;  // largest number of particles
  std::vector<OrientedField> fields;
  std::vector<OrientedConstraint> constraints;
  std::vector<OrientedEvent> events;
};

/// Default colours of bodies, cycled by body number. The first ones do not occur in the temperature colour
/// map (ember).
inline constexpr std::uint32_t orientedColours[] = {0xd6a46e, 0x78be96, 0xbebe78,
                                                    0xc88caa, 0x60aae0, 0x7878ce};

/// Returns the colour of a body: red | green << 8 | blue << 16.
inline std::uint32_t colourOf(const OrientedBody& b, std::size_t number) {
  return b.colour ? *b.colour : orientedColours[number % std::size(orientedColours)];
}

/// Returns the area of a particle (m^2): the cell of a hexagonal lattice. It is slightly smaller for patches
/// and discs, because their rims consist of half cells.
inline double orientedArea(const OrientedBody& b, double spacing) {
  return b.cellShare * 0.86602540378443865 * spacing * spacing;
}

/// Returns the mass of a particle (kg).
inline double orientedMass(const OrientedBody& b, double spacing) {
  return b.density * orientedArea(b, spacing);
}

}  // namespace thaw
