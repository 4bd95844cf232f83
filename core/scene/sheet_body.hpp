// A sheet body as the scene says it ([[sheet]]): vertices on exact damped springs (docs/theory/sheets.md).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/factor_in_time.hpp"
#include "core/scene/motion.hpp"
#include "core/scene/shape.hpp"

namespace thaw {

enum class SheetMesh { Grid, Sphere, Head, Dome, Forehead, File };

/// Coefficients of a sheet that regions may change, and all but the mass also time: places in lists of
/// factors, and in sheetCoefficients.
enum class SheetFactor : std::uint8_t {
  Mass,
  Damping,
  Stiffness,
  Warp,
  Weft,
  Shear,
  Bending,
  Volume,
  Push,
  Pull,
  Wrap,
  Wind
};
inline constexpr std::size_t sheetFactors = 12;
constexpr std::size_t placeOf(SheetFactor f) { return static_cast<std::size_t>(f); }

/// Part of a sheet, by where its vertices are at the start, with other coefficients.
struct SheetRegion {
  SourcePlace where;
  Shape shape;
  std::array<double, sheetFactors> factor{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};  // 1, times the sheet's
};

/// Pushes at a place: a pressure that is largest there and falls to nothing at a radius.
struct SheetBrush {
  SourcePlace where;
  Vec3d centre{};                // m
  double radius = 0.1;           // m
  Vec3d pressure{};              // Pa, force per area of sheet at the centre
  FactorInTime inTime;           // 1
  std::vector<Keyframe> motion;  // of the centre
};

/// Cosines of the angles to the warp's direction up to which an edge is warp, and from which it is weft.
inline constexpr double warpCosine = 0.9, weftCosine = 0.3;

struct SheetBody {
  std::string name;
  SourcePlace where;
  SheetMesh mesh = SheetMesh::Grid;
  Shape shape;                                              // placement; File: the path
  double width = 1, depth = 1, height = 0.5, radius = 0.5;  // m, of what the mesh needs
  double spacing = 0;                                       // m, distance of vertices; 0: the scene's
  int ribs = 0;                                             // of a dome
  double ribHeight = 0.02;                                  // m
  int wrinkles = 5;                                         // of a forehead
  double wrinkleHeight = 0.01;                              // m
  // of the exact step
  double mass = 0.3;                              // kg/m^2
  SourcePlace massWhere;                          // of its key, or of the sheet
  double damping = 0;                             // kg/(m^2 s)
  double stiffness = 0;                           // N/m^3, of the springs to the places of rest
  std::array<FactorInTime, sheetFactors> inTime;  // of coefficients
  std::vector<SheetRegion> regions;
  double plasticity = 0;        // 1, 0 elastic to 1 plastic
  double elasticLimit = never;  // m, displacement from rest
  // internal
  double warp = 0, weft = 0, shear = 0;  // N/m, along edges in the direction of the warp, across it, between
  Vec3d warpDirection{1, 0, 0};          // in the mesh's own axes
  double restLength = 1;                 // 1, of edges over their length at the start
  double bending = 0;                    // N/m, between the vertices on both sides of an edge
  double stretchLimit = never;           // 1, beyond it edges are nearly rigid
  double rigid = 50;                     // 1, by how much
  double volumeStiffness = 0;            // Pa
  double push = 0, pull = 0;             // N/m, between vertices nearer than, further than `thickness`
  double pullReach = 0;                  // m
  // external
  Vec3d wind{};            // m/s
  double windDensity = 0;  // kg/m^3, of the air times a coefficient of drag; 0: no wind
  double wrap = 0;         // Pa
  std::string wrapTo;      // name of an obstacle; empty: against the sheet's own normal
  std::vector<SheetBrush> brushes;
  // contact
  double thickness = 0;    // m, distance at which contact begins; 0: 0.8 of the spacing
  double contactRate = 0;  // 1/s, how fast contact turns a vertex round; 0: from the speeds of the scene
  double friction = 0.3, restitution = 0.3;  // 1
  bool selfContact = false;
  // start and heat
  Vec3d velocity{};                  // m/s
  std::vector<Shape> clamp;          // vertices in one of these at the start are held where they are
  double temperature = 293.15;       // K
  double heatCapacity = 500;         // J/(m^2 K)
  double conductance = 0;            // W/(m^2 K), to continuum bodies that it touches
  std::uint32_t colour = 0xdfe6ebu;  // red | green << 8 | blue << 16
  double factorAt(SheetFactor f, double time) const { return inTime[placeOf(f)].at(time); }
};

/// What SheetFactor names: its key in scenes, and its value in a sheet.
struct SheetCoefficient {
  const char* key;
  double SheetBody::*value;
};
inline constexpr std::array<SheetCoefficient, sheetFactors> sheetCoefficients{
    {{"mass", &SheetBody::mass},
     {"damping", &SheetBody::damping},
     {"stiffness", &SheetBody::stiffness},
     {"warp", &SheetBody::warp},
     {"weft", &SheetBody::weft},
     {"shear", &SheetBody::shear},
     {"bending", &SheetBody::bending},
     {"volume_stiffness", &SheetBody::volumeStiffness},
     {"push", &SheetBody::push},
     {"pull", &SheetBody::pull},
     {"wrap", &SheetBody::wrap},
     {"wind_density", &SheetBody::windDensity}}};

/// The largest factor, without its sign, that time and some region give a coefficient from a time on.
double largestFactor(const SheetBody& body, SheetFactor f, double from = 0);

}  // namespace thaw
