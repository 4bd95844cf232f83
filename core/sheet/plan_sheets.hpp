// What the scene's sheets are made of: meshes, coefficients, pieces. Every rank works it out for itself, from
// the scene alone.
#pragma once
#include <span>

#include "core/geometry/signed_distance.hpp"
#include "core/scene/scene.hpp"
#include "core/sheet/exact_step.hpp"
#include "core/sheet/topology.hpp"
#include "core/sheet/wrap_target.hpp"

namespace thaw {

/// Coefficients of the vertices of a sheet, or of a region of it, at the start; those that change in time are
/// times a factor of the sheet.
struct SheetLaw {
  std::uint16_t sheet = 0;
  SpringLaw law;
  double contactMass = 0;  ///< kg/m^2, that contact's stiffness goes by: the law's, unless that is 0
  std::array<double, sheetFactors> factor{};  ///< of its region; what springs between two vertices have is
                                              ///< the mean of both
};

/// A connected piece of a sheet.
struct SheetPart {
  std::uint16_t sheet = 0;
  bool closed = false;
  Vec3d origin{};             ///< m, of its first vertex: volumes are measured from there
  double area = 0;            ///< m^2
  double volume = 0;          ///< m^3, at the start
  std::int64_t vertices = 0;  ///< at the start
  double stiffness = 0;  ///< Pa, of its volume at a factor in time of 1: the mean of its regions over its
                         ///< area
  double now = 0;        ///< m^3, of the last evaluation, the same on all ranks; 0 where nobody asks for it
};

/// Vertices on both sides of an edge, a bond between each two.
struct SheetHinge {
  std::uint32_t from, to;
  double length, stiffness;  ///< m, N/m
  SheetFactor kind;          ///< Bending, or, for the second diagonal of a square, that of an edge
};

/// Of a mesh file what is of no use in a sheet, and is left out.
struct LeftOut {
  std::size_t triangles = 0;  ///< without area, or there a second time
  std::size_t vertices = 0;   ///< of no triangle
};

struct SheetPlan {
  TriangleMesh mesh;  ///< in the scene
  LeftOut leftOut;
  SheetTopology topology;
  std::vector<std::uint16_t> law;                 ///< of each vertex
  std::vector<double> edgeLength, edgeStiffness;  ///< m, N/m, beside SheetTopology::ring: lengths at rest
  std::vector<SheetFactor> edgeKind;              ///< beside them: Warp, Weft or Shear
  std::vector<SheetHinge> hinges;                 ///< both directions, by `from`
  std::uint32_t firstPart = 0;
  double spacing = 0;                ///< m, mean length of edges
  double longestEdge = 0;            ///< m, at the start and at rest
  double thickness = 0;              ///< m, where contact begins
  double contactRate = 0;            ///< 1/s
  std::vector<double> particleRate;  ///< 1/s, of the continuum's materials: of the barrier that holds their
                                     ///< particles (particle_contact.hpp); 0 where the scene gives
                                     ///< contactRate
  // of contact by triangles: with the continuum (face_contact.hpp), and of sheets (mesh_contact.hpp)
  bool byFaces = false;
  double faceReach = 0;  ///< m, distance of a particle's centre at which it begins
  double faceRate = 0;   ///< 1/s, as contactRate
  double faceArea = 0;   ///< m^2, of a vertex in the mean: times SheetLaw::contactMass it is what the
                         ///< stiffness goes by
  std::vector<std::uint32_t> faceFirst, faceOf;  ///< triangles whose first corner is vertex v:
                                                 ///< faceOf[faceFirst[v]] ..
  WrapTarget wrapTarget;
  bool edgeForces = false;  ///< springs along edges or across them
  bool normals = false;     ///< some force needs them
  bool touches = false;     ///< something is in the scene that it can touch
};

/// Part of its length that an edge may be stretched to and still be where contact by triangles looks for it:
/// cells have room for so much.
inline constexpr double stretchedEdges = 1.3;

struct SheetPlans {
  std::vector<SheetPlan> plans;
  std::vector<SheetLaw> laws;
  std::vector<SheetPart> parts;
};

/// Throws SceneProblems' ShapeError for meshes that cannot be a sheet.
SheetPlans planSheets(const Scene& scene, const MeshLoader& load);

/// The mesh of a sheet where the scene puts it.
TriangleMesh sheetMesh(const Scene& scene, const SheetBody& body, const MeshLoader& load,
                       LeftOut* leftOut = nullptr);

/// Warp, Weft or Shear, of an edge along this direction: warp within 25 degrees of its direction, weft
/// beyond 72.
SheetFactor edgeKind(const SheetBody& body, const Vec3d& edge);

/// Springs by the number of their bond of a vertex (from 0): first its ring, then the vertices across edges.
std::vector<SheetFactor> springKinds(const SheetPlan& plan, std::uint32_t vertex);
/// The hinges of a vertex.
std::span<const SheetHinge> hingesAt(const SheetPlan& plan, std::uint32_t vertex);

/// N/m, of an edge along this direction whose triangles have this area (m^2): (van Gelder 1998) stiffness *
/// area / length^2, a strip of cloth is as stiff as its width says.
double edgeStiffness(const SheetBody& body, const Vec3d& edge, double area);

/// Radius (m) within which the scene's sheets act on anything by distance.
double sheetReach(const Scene& scene);

/// m/s, that what pushes on the sheets from outside, or their start, may give them: for what counts as much
/// energy. 0 without any.
double expectedSheetSpeed(const Scene& scene);

/// m, thickness of a sheet: the scene's, or 0.8 of its spacing.
double sheetThickness(const Scene& scene, const SheetBody& body);

}  // namespace thaw
