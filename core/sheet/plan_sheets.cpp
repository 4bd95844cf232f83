// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/plan_sheets.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/builtin_meshes.hpp"
#include "core/geometry/builtin/sheet_meshes.hpp"
#include "core/geometry/meshes/weld_vertices.hpp"
#include "core/geometry/shapes/placed_mesh.hpp"
#include "core/geometry/shapes/pose.hpp"
#include "core/scene/expected_speeds.hpp"
#include "core/sheet/contact/face_contact.hpp"
#include "core/sheet/contact/mesh_contact.hpp"
#include "core/sheet/contact/sheet_contact.hpp"
#include "core/sheet/data/touching_sheets.hpp"

namespace thaw {

double largestFactor(const SheetBody& b, SheetFactor f, double from) {
  double region = 1;
  for (const SheetRegion& r : b.regions) region = std::max(region, std::abs(r.factor[placeOf(f)]));
  return region * b.inTime[placeOf(f)].most(from, never);
}

namespace {

/// Returns the largest contact speed (m/s) of a vertex, from its own motion, a fall through the domain, and
/// obstacles.
double speedOf(const Scene& s, const SheetBody& b) {
  double fastest = length(b.velocity) + length(b.wind);
  for (const Obstacle& o : s.obstacles)
    fastest = std::max(fastest, fastestMove(o.motion) + length(b.velocity));
  for (const Body& body : s.bodies) fastest = std::max(fastest, length(body.velocity) + length(b.velocity));
  for (const SheetBody& other : s.sheets) fastest = std::max(fastest, length(other.velocity - b.velocity));
  return fastest + fallSpeed(s.domain);
}

/// Returns the contact rate (1/s). With it, a vertex penetrates at most half of the thickness (m) at the
/// scene's speeds, and at most a tenth under its pressures.
double contactRateOf(const Scene& s, const SheetBody& b, double thickness) {
  const auto most = [&](SheetFactor f) {
    return std::abs(b.*sheetCoefficients[placeOf(f)].value) * largestFactor(b, f);
  };
  double pressure = b.mass * length(s.domain.gravity) + most(SheetFactor::ShrinkWrap) +
                    most(SheetFactor::Wind) * dot(b.wind, b.wind);
  for (const PressureBrush& brush : b.pressureBrushes)
    pressure += length(brush.pressure) * brush.inTime.most(0, never);
  const double mass = b.mass > 0 ? b.mass : 1;
  return std::max({2 * speedOf(s, b) / thickness, std::sqrt(10 * pressure / (mass * thickness)),
                   2 * std::sqrt(most(SheetFactor::Stiffness) / mass), 1.0});
}

/// Computes the mean factor of a spring's two vertices.
struct SpringFactors {
  const std::vector<SheetLaw>& laws;
  const std::vector<std::uint16_t>& law;  // per vertex
  double operator()(SheetFactor f, std::uint32_t a, std::uint32_t b) const {
    return 0.5 * (laws[law[a]].factor[placeOf(f)] + laws[law[b]].factor[placeOf(f)]);
  }
};

std::vector<SheetHinge> hingesOf(const SheetBody& b, const SheetPlan& plan, const SpringFactors& factor) {
  std::vector<SheetHinge> all;
  if (b.bending <= 0 && b.shear <= 0) return all;
  const auto& x = plan.mesh.vertices;
  const SheetTopology& t = plan.topology;
  for (const auto& [a, c, across, beyond] : t.hinges) {
    double area = 0;
    for (std::uint32_t k = t.first[a]; k < t.first[a + 1]; k++)
      if (t.ring[k].to == c) area = t.ring[k].area;
    const double span = length(x[beyond] - x[across]), edge = length(x[c] - x[a]);
    const bool second = span < 1.2 * edge;  // second diagonal of a square
    const SheetFactor kind = second ? edgeKind(b, x[beyond] - x[across]) : SheetFactor::Bending;
    const double stiffness = (second ? edgeStiffness(b, x[beyond] - x[across], area)
                                     : b.bending * area / (span * span)) *
                             factor(kind, across, beyond);
    if (!(stiffness > 0) || !(span > 0)) continue;
    all.push_back({across, beyond, b.restLength * span, stiffness, kind});
    all.push_back({beyond, across, b.restLength * span, stiffness, kind});
  }
  std::sort(all.begin(), all.end(), [](const SheetHinge& p, const SheetHinge& q) {
    return p.from != q.from ? p.from < q.from : p.to < q.to;
  });
  // two edges of a very coarse mesh may share the vertices across: one bond is kept
  all.erase(
      std::unique(all.begin(), all.end(),
                  [](const SheetHinge& p, const SheetHinge& q) { return p.from == q.from && p.to == q.to; }),
      all.end());
  std::erase_if(all, [&](const SheetHinge& h) {  // no hinge coincides with an edge
    for (std::uint32_t k = t.first[h.from]; k < t.first[h.from + 1]; k++)
      if (t.ring[k].to == h.to) return true;
    return false;
  });
  return all;
}

/// Sets reach, rate and area of contact by triangles. Particles count as spheres with a diameter of one
/// spacing.
/// The sheet is 0.8 spacings thick unless the scene gives its thickness.
void planFaces(const Scene& s, const SheetBody& b, SheetPlan& plan) {
  const double thickness = b.thickness > 0 ? b.thickness : 0.8 * s.spacing;
  plan.faceReach = 0.5 * (thickness + s.spacing);
  plan.faceRate = b.contactRate > 0 ? b.contactRate : contactRateOf(s, b, plan.faceReach);
  double area = 0;
  for (const double a : plan.topology.area) area += a;
  plan.faceArea = area / static_cast<double>(plan.topology.area.size());
}

/// Returns the contact mass (kg/m^2). Without mass, it is equivalent to damping or stiffness at this rate
/// (1/s).
double contactMassOf(const SpringLaw& l, double rate) {
  return l.mass > 0 ? l.mass : l.damping > 0 ? l.damping / rate : l.stiffness / (rate * rate);
}

/// Lists triangles by their first corners.
void listFaces(SheetPlan& plan) {
  plan.faceFirst.assign(plan.mesh.vertices.size() + 1, 0);
  for (const auto& t : plan.mesh.triangles) plan.faceFirst[t[0] + 1]++;
  for (std::size_t v = 0; v + 1 < plan.faceFirst.size(); v++) plan.faceFirst[v + 1] += plan.faceFirst[v];
  plan.faceOf.resize(plan.mesh.triangles.size());
  std::vector<std::uint32_t> next(plan.faceFirst.begin(), plan.faceFirst.end() - 1);
  for (std::uint32_t k = 0; k < plan.mesh.triangles.size(); k++)
    plan.faceOf[next[plan.mesh.triangles[k][0]]++] = k;
}

SheetLaw lawOf(std::size_t sheet, const SheetBody& b, const SheetRegion& r) {
  const auto& f = r.factor;
  return {static_cast<std::uint16_t>(sheet),
          {b.mass * f[placeOf(SheetFactor::Mass)], b.damping * f[placeOf(SheetFactor::Damping)],
           b.stiffness * f[placeOf(SheetFactor::Stiffness)]},
          0,
          f};
}

void checkLaw(const SheetLaw& l, const SourcePlace& where) {
  if (l.law.mass == 0 && l.law.damping == 0 && l.law.stiffness == 0)
    throw ShapeError("mass, damping and stiffness of a sheet are all 0; expected at least one above 0",
                     where);
}

}  // namespace

double sheetThickness(const Scene& s, const SheetBody& b) {
  return b.thickness > 0 ? b.thickness : 0.8 * spacingOf(s, b);
}

double expectedSheetSpeed(const Scene& s) {
  double most = 0;
  for (const SheetBody& b : s.sheets) {
    // speed that a pressure causes over a distance
    const auto pushed = [&](double pressure, double over) {
      return b.mass > 0 ? std::sqrt(2 * pressure * over / b.mass) : b.damping > 0 ? pressure / b.damping : 0;
    };
    most = std::max(
        {most, speedOf(s, b), b.windDensity > 0 ? length(b.wind) : 0,
         pushed(std::abs(b.shrinkWrap) * largestFactor(b, SheetFactor::ShrinkWrap), spacingOf(s, b))});
    for (const PressureBrush& brush : b.pressureBrushes)
      most = std::max(most, pushed(length(brush.pressure) * brush.inTime.most(0, never), brush.radius));
  }
  return most;
}

double sheetReach(const Scene& s) {
  double reach = 0;
  for (const SheetBody& b : s.sheets) {
    const double own = sheetThickness(s, b);
    reach = std::max({reach, own, own + (b.attraction > 0 ? b.attractionRange : 0), 0.5 * (own + s.spacing)});
    // without neighbour search, cells only partition sums, so each has some vertices
    if (!hasContinuum(s) && s.oriented.empty() && !sheetsInteract(s))
      reach = std::max(reach, 4 * spacingOf(s, b));
  }
  return reach;
}

SheetFactor edgeKind(const SheetBody& b, const Vec3d& edge) {
  const Pose pose = poseOf({}, b.shape.rotate);
  const double along = std::abs(dot(edge, directionFromRest(pose, normalized(b.warpDirection)))) /
                       length(edge);
  return along > warpCosine ? SheetFactor::Warp : along < weftCosine ? SheetFactor::Weft : SheetFactor::Shear;
}

double edgeStiffness(const SheetBody& b, const Vec3d& edge, double area) {
  return b.*sheetCoefficients[placeOf(edgeKind(b, edge))].value * area / dot(edge, edge);
}

std::span<const SheetHinge> hingesAt(const SheetPlan& plan, std::uint32_t vertex) {
  const auto first = std::lower_bound(plan.hinges.begin(), plan.hinges.end(), vertex,
                                      [](const SheetHinge& h, std::uint32_t x) { return h.from < x; });
  auto last = first;
  while (last != plan.hinges.end() && last->from == vertex) ++last;
  return {first, last};
}

std::vector<SheetFactor> springKinds(const SheetPlan& plan, std::uint32_t vertex) {
  const SheetTopology& t = plan.topology;
  std::vector<SheetFactor> kinds(plan.edgeKind.begin() + t.first[vertex],
                                 plan.edgeKind.begin() + t.first[vertex + 1]);
  for (const SheetHinge& h : hingesAt(plan, vertex)) kinds.push_back(h.kind);
  return kinds;
}

namespace {

DroppedElements droppedFrom(const TriangleMesh& file, const TriangleMesh& kept) {
  std::vector<std::uint8_t> used(file.vertices.size(), 0);
  for (const auto& t : file.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  return {file.triangles.size() - kept.triangles.size(),
          static_cast<std::size_t>(std::count(used.begin(), used.end(), 0))};
}

}  // namespace

TriangleMesh sheetMesh(const Scene& s, const SheetBody& b, const MeshLoader& load,
                       DroppedElements* droppedElements) {
  TriangleMesh m;
  const double spacing = spacingOf(s, b);
  switch (b.mesh) {
    case SheetMesh::Grid: m = gridSheet(b.width, b.depth, spacing); break;
    case SheetMesh::Sphere: m = sphereSheet(b.radius, spacing); break;
    case SheetMesh::Head: m = headSheet(b.height, spacing); break;
    case SheetMesh::Dome: m = domeSheet(b.radius, b.height, spacing, b.ribs, b.ribHeight); break;
    case SheetMesh::Forehead:
      m = foreheadSheet(b.radius, b.width, b.height, spacing, b.wrinkleHeight, b.wrinkles);
      break;
    case SheetMesh::File: {
      if (!load && !isBuiltin(b.shape.mesh))
        throw ShapeError(
            "mesh '" + b.shape.mesh + "': no mesh loader was given; expected one for a mesh file", b.where);
      const TriangleMesh file = isBuiltin(b.shape.mesh) ? builtinMesh(b.shape.mesh) : load(b.shape.mesh);
      m = weldVertices(file, 0);
      if (droppedElements) *droppedElements = droppedFrom(file, m);
    }
  }
  placeMesh(b.shape, m);
  return m;
}

namespace {

void refusePeriodicSides(const Scene& s, SceneProblems& problems) {
  if (s.sheets.empty()) return;
  for (const auto& axis : s.domain.side)
    if (axis[0] == Side::Periodic)
      problems.add(s.sheets[0].where,
                   "sheets with periodic sides are not supported; expected open sides or walls");
}

/// Appends the laws of a sheet and its regions. Sets the law of each vertex, from the last region that
/// contains it. Throws ShapeError.
void planLaws(const Scene& s, std::size_t n, const MeshLoader& load, SheetPlan& plan,
              std::vector<SheetLaw>& laws) {
  const SheetBody& b = s.sheets[n];
  const std::size_t base = laws.size();
  laws.push_back(lawOf(n, b, {}));
  checkLaw(laws.back(), b.where);
  plan.law.assign(plan.mesh.vertices.size(), static_cast<std::uint16_t>(base));
  for (const SheetRegion& r : b.regions) {
    const SheetLaw law = lawOf(n, b, r);
    checkLaw(law, r.where);
    const auto shape = makeSignedDistance(r.shape, load);
    bool has = false;
    for (std::size_t v = 0; v < plan.law.size(); v++)
      if (shape->inside(plan.mesh.vertices[v]))
        plan.law[v] = static_cast<std::uint16_t>(laws.size()), has = true;
    if (!has) throw ShapeError("no vertex lies in this region at the start; expected at least one", r.where);
    laws.push_back(law);
  }
}

/// Sets the springs along edges, and the mean and longest edge.
void planEdges(const SheetBody& b, const SpringFactors& factor, SheetPlan& plan) {
  const SheetTopology& t = plan.topology;
  double edges = 0;
  for (std::uint32_t v = 0; v + 1 < t.first.size(); v++)
    for (std::uint32_t k = t.first[v]; k < t.first[v + 1]; k++) {
      // the order gives the same bits at both ends
      const std::uint32_t a = std::min(v, t.ring[k].to), c = std::max(v, t.ring[k].to);
      const Vec3d d = plan.mesh.vertices[c] - plan.mesh.vertices[a];
      edges += length(d);
      plan.longestEdge = std::max(plan.longestEdge, std::max(1.0, b.restLength) * length(d));
      plan.edgeLength.push_back(b.restLength * length(d));
      plan.edgeKind.push_back(edgeKind(b, d));
      plan.edgeStiffness.push_back(edgeStiffness(b, d, t.ring[k].area) * factor(plan.edgeKind.back(), a, c));
    }
  plan.spacing = edges / static_cast<double>(t.ring.size());
  plan.edgeForces = b.warp > 0 || b.weft > 0 || b.shear > 0 || b.bending > 0;
}

/// Returns whether the scene has anything that a sheet can touch.
bool canTouch(const Scene& s, const SheetBody& b) {
  bool touches = b.selfContact || s.sheets.size() > 1 || !s.obstacles.empty() || !s.bodies.empty() ||
                 !s.emitters.empty() || !s.oriented.empty() || b.repulsion > 0 || b.attraction > 0;
  for (const auto& axis : s.domain.side)
    for (const Side side : axis) touches = touches || side == Side::Wall;
  return touches;
}

/// Sets contact distances, rates and masses. Requires: edges. laws: laws of this sheet.
void planContact(const Scene& s, std::size_t n, SheetPlan& plan, std::span<SheetLaw> laws) {
  const SheetBody& b = s.sheets[n];
  plan.thickness = sheetThickness(s, b);
  plan.contactRate = b.contactRate > 0 ? b.contactRate : contactRateOf(s, b, plan.thickness);
  for (SheetLaw& l : laws) l.contactMass = contactMassOf(l.law, plan.contactRate);
  plan.byFaces = coarserThanParticles(s, plan);
  if (plan.byFaces) planFaces(s, b, plan);
  if (plan.byFaces || meshTouches(s, n)) listFaces(plan);
  plan.touches = canTouch(s, b);
}

/// Appends the components of sheet n, with the volume stiffness of their regions. Throws ShapeError for a
/// volume stiffness without a closed mesh.
void planParts(const SheetBody& b, std::size_t n, SheetPlan& plan, const std::vector<SheetLaw>& laws,
               std::vector<SheetPart>& parts) {
  const SheetTopology& t = plan.topology;
  plan.firstPart = static_cast<std::uint32_t>(parts.size());
  for (std::size_t c = 0; c < t.closed.size(); c++) {
    SheetPart part;
    part.sheet = static_cast<std::uint16_t>(n);
    part.closed = t.closed[c];
    part.volume = t.volume[c];
    parts.push_back(part);
  }
  std::vector<std::uint8_t> seen(t.closed.size(), 0);
  for (std::size_t v = 0; v < plan.mesh.vertices.size(); v++) {
    SheetPart& part = parts[plan.firstPart + t.component[v]];
    if (!seen[t.component[v]]) part.origin = plan.mesh.vertices[v];
    seen[t.component[v]] = 1;
    part.area += t.area[v];
    part.stiffness += b.volumeStiffness * laws[plan.law[v]].factor[placeOf(SheetFactor::Volume)] * t.area[v];
    part.vertices++;
  }
  for (std::size_t p = plan.firstPart; p < parts.size(); p++) parts[p].stiffness /= parts[p].area;
  if (!(b.volumeStiffness > 0)) return;
  for (std::size_t c = 0; c < t.closed.size(); c++)
    if (!(t.volume[c] > 0))
      throw ShapeError(t.closed[c] ? "volume_stiffness: the mesh's triangles face inward; expected outward"
                                   : "volume_stiffness: the mesh has a border; expected a closed mesh",
                       b.where);
}

/// Appends the plan of sheet n with its laws and components. Throws ShapeError, std::runtime_error.
void addPlan(const Scene& s, std::size_t n, const MeshLoader& load, SheetPlans& all) {
  const SheetBody& b = s.sheets[n];
  SheetPlan plan;
  plan.mesh = sheetMesh(s, b, load, &plan.droppedElements);
  plan.topology = sheetTopology(plan.mesh);
  const std::size_t firstLaw = all.laws.size();
  planLaws(s, n, load, plan, all.laws);
  const SpringFactors factor{all.laws, plan.law};
  planEdges(b, factor, plan);
  planContact(s, n, plan, std::span(all.laws).subspan(firstLaw));
  plan.normals = b.volumeStiffness > 0 || (b.shrinkWrap != 0 && b.shrinkWrapTo.empty()) || b.windDensity > 0;
  if (b.shrinkWrap != 0) plan.shrinkWrapTarget = shrinkWrapTarget(s, n);
  planParts(b, n, plan, all.laws, all.parts);
  plan.hinges = hingesOf(b, plan, factor);
  all.plans.push_back(std::move(plan));
}

}  // namespace

SheetPlans planSheets(const Scene& s, const MeshLoader& load) {
  SheetPlans all;
  SceneProblems problems;
  refusePeriodicSides(s, problems);
  for (std::size_t n = 0; n < s.sheets.size(); n++) {
    const SheetBody& b = s.sheets[n];
    try {
      addPlan(s, n, load, all);
    } catch (const ShapeError& e) {
      problems.add(e.where.line > 0 ? e.where : b.where, "sheet '" + b.name + "': " + e.what());
    } catch (const std::runtime_error& e) {  // mesh that cannot be read
      problems.add(b.where, "sheet '" + b.name + "': " + e.what());
    }
  }
  problems.raise();
  return all;
}

}  // namespace thaw
