// SPDX-License-Identifier: Apache-2.0
// Properties of the scene's sheets: meshes, coefficients, components. Every rank computes them from the scene
// only.
#pragma once
#include <span>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/scene.hpp"
#include "core/sheet/data/exact_step.hpp"
#include "core/sheet/data/shrink_wrap_target.hpp"
#include "core/sheet/data/topology.hpp"

namespace thaw {

/// Initial coefficients of the vertices of a sheet or region. Time-dependent ones are multiplied by the
/// sheet's factor.
struct SheetLaw {
  std::uint16_t sheet = 0;
  SpringLaw law;
  double contactMass = 0;  ///< kg/m^2, mass for contact stiffness: the law's mass, unless it is 0
  std::array<double, sheetFactors> factor{};  ///< factors of its region; springs between two vertices use
                                              ///< their mean
};

/// Connected component of a sheet.
struct SheetPart {
  std::uint16_t sheet = 0;
  bool closed = false;
  Vec3d origin{};             ///< m, position of the first vertex, the origin of volumes
  double area = 0;            ///< m^2
  double volume = 0;          ///< m^3, at the start
  std::int64_t vertices = 0;  ///< at the start
  double stiffness = 0;       ///< Pa, volume stiffness at a time factor of 1: mean over its area, with the
                              ///< factors of its regions
  double now = 0;             ///< m^3, volume at the last evaluation, the same on all ranks; 0 if unused
};

/// Vertices on both sides of an edge, connected by a bond.
struct SheetHinge {
  std::uint32_t from, to;
  double length, stiffness;  ///< m, N/m
  SheetFactor kind;          ///< Bending, or an edge type for the second diagonal of a square
};

/// Elements of a mesh file that a sheet cannot use and drops.
struct DroppedElements {
  std::size_t triangles = 0;  ///< triangles without area, and duplicate triangles
  std::size_t vertices = 0;   ///< vertices without a triangle
};

struct SheetPlan {
  TriangleMesh mesh;  ///< in scene coordinates
  DroppedElements droppedElements;
  SheetTopology topology;
  std::vector<std::uint16_t> law;                 ///< per vertex
  std::vector<double> edgeLength, edgeStiffness;  ///< m, N/m, parallel to SheetTopology::ring: rest lengths
  std::vector<SheetFactor> edgeKind;              ///< parallel to it: Warp, Weft or Shear
  std::vector<SheetHinge> hinges;                 ///< in both directions, sorted by `from`
  std::uint32_t firstPart = 0;
  double spacing = 0;      ///< m, mean edge length
  double longestEdge = 0;  ///< m, maximum over start and rest state
  double thickness = 0;    ///< m, contact distance
  double contactRate = 0;  ///< 1/s
  /// 1/s, per material of the continuum: rate of the barrier (particle_contact.hpp); 0 where the scene gives
  /// contactRate.
  std::vector<double> particleRate;
  // contact by triangles: with the continuum (face_contact.hpp), and between sheets (mesh_contact.hpp)
  bool byFaces = false;
  double faceReach = 0;  ///< m, contact distance of a particle's centre
  double faceRate = 0;   ///< 1/s, as contactRate
  double faceArea = 0;   ///< m^2, mean area of a vertex. Its product with SheetLaw::contactMass is the mass
                         ///< for contact stiffness
  std::vector<std::uint32_t> faceFirst, faceOf;  ///< triangles whose first corner is vertex v:
                                                 ///< faceOf[faceFirst[v]] ..
  ShrinkWrapTarget shrinkWrapTarget;
  bool edgeForces = false;  ///< springs along edges or across them
  bool normals = false;     ///< a force needs normals
  bool touches = false;     ///< the scene has an object that the sheet can touch
};

/// Largest stretch of an edge for which mesh contact finds the edge. Cells are large enough for it.
inline constexpr double stretchedEdges = 1.3;

struct SheetPlans {
  std::vector<SheetPlan> plans;
  std::vector<SheetLaw> laws;
  std::vector<SheetPart> parts;
};

/// Throws ShapeError for meshes that cannot be a sheet.
SheetPlans planSheets(const Scene& scene, const MeshLoader& load);

/// Returns the mesh of a sheet in scene coordinates.
TriangleMesh sheetMesh(const Scene& scene, const SheetBody& body, const MeshLoader& load,
                       DroppedElements* droppedElements = nullptr);

/// Returns Warp, Weft or Shear for an edge along this direction: warp within 25 degrees of the warp
/// direction, weft beyond 72.
SheetFactor edgeKind(const SheetBody& body, const Vec3d& edge);

/// Returns the spring types of a vertex by bond number (from 0): first its ring, then the vertices across
/// edges.
std::vector<SheetFactor> springKinds(const SheetPlan& plan, std::uint32_t vertex);
/// Returns the hinges of a vertex.
std::span<const SheetHinge> hingesAt(const SheetPlan& plan, std::uint32_t vertex);

/// Returns the stiffness (N/m) of an edge along this direction with adjacent triangle area (m^2). It is
/// stiffness * area / length^2 (VG98), so the stiffness of a strip is proportional to its width.
double edgeStiffness(const SheetBody& body, const Vec3d& edge, double area);

/// Returns the interaction radius (m) of the scene's sheets.
double sheetReach(const Scene& scene);

/// Returns the largest speed (m/s) of sheets due to external forces or initial motion, as a scale of energy.
/// Returns 0 without sheets.
double expectedSheetSpeed(const Scene& scene);

/// Returns the thickness (m) of a sheet: the scene's, or 0.8 of its spacing.
double sheetThickness(const Scene& scene, const SheetBody& body);

}  // namespace thaw
