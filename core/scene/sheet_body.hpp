// SPDX-License-Identifier: Apache-2.0
// A sheet body as the scene defines it ([[sheet]]). Its vertices move on damped springs, integrated exactly
// (docs/theory/sheets.md).
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

/// Coefficients of a sheet that regions may scale. All except the mass may also vary in time. The values are
/// indices into lists of factors and into sheetCoefficients.
enum class SheetFactor : std::uint8_t {
  Mass,
  Damping,
  Stiffness,
  Warp,
  Weft,
  Shear,
  Bending,
  Volume,
  Repulsion,
  Attraction,
  ShrinkWrap,
  Wind
};
inline constexpr std::size_t sheetFactors = 12;
constexpr std::size_t placeOf(SheetFactor f) { return static_cast<std::size_t>(f); }

/// Part of a sheet with other coefficients, selected by the initial positions of its vertices.
struct SheetRegion {
  SourcePlace where;
  Shape shape;
  std::array<double, sheetFactors> factor{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};  // 1, factors of the sheet's
                                                                                // coefficients
};

/// Local pressure: largest at the centre, zero at the radius.
struct PressureBrush {
  SourcePlace where;
  Vec3d centre{};                // m
  double radius = 0.1;           // m
  Vec3d pressure{};              // Pa, force per area of sheet at the centre
  FactorInTime inTime;           // 1
  std::vector<Keyframe> motion;  // motion of the centre
};

/// An edge is warp if the cosine of its angle to the warp direction is at least warpCosine. It is weft if the
/// cosine is at most weftCosine.
inline constexpr double warpCosine = 0.9, weftCosine = 0.3;

struct SheetBody {
  std::string name;
  SourcePlace where;
  SheetMesh mesh = SheetMesh::Grid;
  Shape shape;                                              // placement; File: the path
  double width = 1, depth = 1, height = 0.5, radius = 0.5;  // m, used as the mesh type requires
  double spacing = 0;                                       // m, spacing of vertices; 0: the scene's
  int ribs = 0;                                             // for a dome
  double ribHeight = 0.02;                                  // m
  int wrinkles = 5;                                         // for a forehead
  double wrinkleHeight = 0.01;                              // m
  // Exact step.
  double mass = 0.3;                              // kg/m^2
  SourcePlace massWhere;                          // position of its key, or of the sheet
  double damping = 0;                             // kg/(m^2 s)
  double stiffness = 0;                           // N/m^3, springs to the rest positions
  std::array<FactorInTime, sheetFactors> inTime;  // 1, factors of the coefficients
  std::vector<SheetRegion> regions;
  double plasticity = 0;        // 1, from 0 (elastic) to 1 (plastic)
  double elasticLimit = never;  // m, displacement from rest
  // Internal forces.
  double warp = 0, weft = 0, shear = 0;  // N/m, stiffness of edges along the warp, across it, and in between
  Vec3d warpDirection{1, 0, 0};          // in the axes of the mesh
  double restLength = 1;                 // 1, rest length over initial length of edges
  double bending = 0;                    // N/m, springs between the vertices on both sides of an edge
  double stretchLimit = never;           // 1, stretch beyond which edges are nearly rigid
  double rigid = 50;                     // 1, stiffness factor beyond stretchLimit
  double volumeStiffness = 0;            // Pa
  double repulsion = 0, attraction = 0;  // N/m, repulsion of vertices closer than `thickness`, attraction of
                                         // vertices farther apart
  double attractionRange = 0;            // m, range of the attraction
  // External forces.
  Vec3d wind{};              // m/s
  double windDensity = 0;    // kg/m^3, density of the air times a drag coefficient; 0: no wind
  double shrinkWrap = 0;     // Pa, pressure of the shrink-wrap
  std::string shrinkWrapTo;  // name of the target; empty: along the negative normal of the sheet
  std::vector<PressureBrush> pressureBrushes;
  // Contact.
  double thickness = 0;    // m, contact distance; 0: 0.8 of the spacing
  double contactRate = 0;  // 1/s, rate at which contact reverses a vertex; 0: from the expected speeds of the
                           // scene
  double friction = 0.3, restitution = 0.3;  // 1
  bool selfContact = false;
  // Start and heat.
  Vec3d velocity{};                  // m/s
  std::vector<Shape> clamp;          // vertices inside one of these at the start are fixed in place
  double temperature = 293.15;       // K
  double heatCapacity = 500;         // J/(m^2 K)
  double conductance = 0;            // W/(m^2 K), to touching continuum bodies
  std::uint32_t colour = 0xdfe6ebu;  // red | green << 8 | blue << 16
  double factorAt(SheetFactor f, double time) const { return inTime[placeOf(f)].at(time); }
};

/// Key in scenes and member of SheetBody for a SheetFactor.
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
     {"repulsion", &SheetBody::repulsion},
     {"attraction", &SheetBody::attraction},
     {"shrink_wrap", &SheetBody::shrinkWrap},
     {"wind_density", &SheetBody::windDensity}}};

/// Returns the largest absolute factor of a coefficient, over its regions and all times from `from` (s) on.
double largestFactor(const SheetBody& body, SheetFactor f, double from = 0);

}  // namespace thaw
