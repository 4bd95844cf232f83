// An oriented body as the scene says it ([[oriented]]): where its particles come from, how they act on each
// other, what happens to them.
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
enum class OrientedGrowth { None, Gaps, Borders };  // where particles are made
enum class OrientedEventKind { Weld, Cut, Crease, Smooth };
enum class CutTool { Plane, Stroke, Box };

/// Holds the particles that lie in a region at the start.
struct OrientedAnchor {
  SourcePlace where;
  Shape region;
  bool position = true, normal = false;
  std::vector<Keyframe> motion;  // of what it holds
  double until = never;          // s, lets go then
};

/// What acts from outside on particles that are in a region, over a time: a push, a pull to a point, a
/// pressure, or more than one of them.
struct OrientedField {
  SourcePlace where;
  bool everywhere = true;
  Shape region;         // where not
  Vec3d push{};         // N/kg, the same for all
  Vec3d point{};        // m
  double pull = 0;      // N/kg, toward the point, below 0 away from it: the largest, at radius / sqrt(5)
  double radius = 0.1;  // m, where it ends
  double pressure = 0;  // Pa, along the normals
  double from = 0, until = never;  // s
  FactorInTime inTime;             // of all three
};

struct OrientedEvent {
  SourcePlace where;
  OrientedEventKind kind = OrientedEventKind::Cut;
  double time = 0;  // s
  CutTool tool = CutTool::Plane;
  Vec3d point{}, normal{1, 0, 0};  // m; of the plane
  std::vector<Vec3d> path;         // m; of a stroke or a crease
  Vec3d direction{0, 0, -1};       // of the stroke's cut
  Shape region;                    // of the box, and of smoothing
  double radius = 0;  // m, of the crease, and how far from a stroke it cuts; 0: a spacing, a support radius
  std::string other;  // the body that is welded to this one
  int otherIndex = -1;
};

struct OrientedBody {
  std::string name;
  SourcePlace where;
  // what it is made of
  OrientedSource source = OrientedSource::Surface;
  Shape shape;                                // its surface; for other sources only the placement counts
  double width = 1, depth = 1, radius = 0.5;  // m, of a patch or a disc in z = 0, normals along z
  std::vector<Vec3d> points, normals;         // m; of points, control points; normals may be missing
  Vec3d from{}, to{1, 0, 0};                  // m, ends of a curve in y = 0
  double bulge = 0;                           // m, height of the curve's middle
  double thin = 1;  // 1, share of the samples that is kept, held where they are; the rest grows again
  std::optional<std::uint32_t> colour;  // red | green << 8 | blue << 16; none: orientedColours by its number
  double spacing = 0;                   // m, wanted distance of its particles; 0: the scene's
  double cellShare = 1;  // 1, area of a particle over that of the cell of a hexagonal lattice; set at set-up,
                         // of patches and discs
  double jitter = 0;   // 1, spacings and rad by which places and normals are off at the start, at most along
                       // each axis
  Vec3d velocity{};    // m/s
  double density = 1;  // kg/m^2
  double inertia = 0.25;  // 1, of a particle, over its mass and the square of the spacing
  // potentials (ST92)
  double stiffness = 10;  // N/m, energies are weights times this times the square of the spacing
  double attract = 1, plane = 1, normal = 0.5, circle = 1;  // 1, weights of the four potentials
  std::int64_t repelPower = 12, attractPower = 6;           // n, m of Lennard-Jones
  double core = 0.7;               // 1, spacings below which Lennard-Jones goes on as a straight line (B33)
  double across = 1, along = 0.5;  // 1, a and b of the weighting function, spacings
  double support = 3;              // 1, radius of the pair forces, spacings
  bool facing = true;   // particles whose normals stand against each other do not act on each other (B33)
  bool planar = false;  // moves and turns in y = constant only
  // what else acts
  double damping = 1, spinDamping = 1;  // 1/s
  double pressure = 0;                  // Pa, along the normals
  Vec3d push{};                         // N/kg
  double contact = 2;                   // 1, stiffness of contacts over `stiffness`
  double thickness = 0.5;               // 1, spacings that it keeps from obstacles
  double friction = 0.2;                // 1
  OrientedIntegrator integrator = OrientedIntegrator::SymplecticEuler;
  double cfl = 0.25;       // 1, step over the longest stable one of the integrator
  std::int64_t relax = 0;  // iterations of relaxation before the start, at most
  // births and deaths
  OrientedGrowth growth = OrientedGrowth::None;
  double gap = 1.5;             // 1, spacings between neighbours from which a particle is put between them
  double crowd = 0;             // 1, spacings below which one of two goes; 0: never
  std::int64_t every = 10;      // steps between looks at that
  std::int64_t most = 1000000;  // particles
  std::vector<OrientedField> fields;
  std::vector<OrientedAnchor> anchors;
  std::vector<OrientedEvent> events;
};

/// Colours of bodies that are given none, by their number in the scene, over and over: first what the scale
/// of temperatures (ember) has not.
inline constexpr std::uint32_t orientedColours[] = {0xd6a46e, 0x78be96, 0xbebe78,
                                                    0xc88caa, 0x60aae0, 0x7878ce};

/// Colour of a body: red | green << 8 | blue << 16.
inline std::uint32_t colourOf(const OrientedBody& b, std::size_t number) {
  return b.colour ? *b.colour : orientedColours[number % std::size(orientedColours)];
}

/// m^2, of a particle: its share of the surface is the cell of a hexagonal lattice; of patches and discs,
/// whose rims are half cells, a little less.
inline double orientedArea(const OrientedBody& b, double spacing) {
  return b.cellShare * 0.86602540378443865 * spacing * spacing;
}

/// kg, of a particle.
inline double orientedMass(const OrientedBody& b, double spacing) {
  return b.density * orientedArea(b, spacing);
}

}  // namespace thaw
