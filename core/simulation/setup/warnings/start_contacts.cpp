// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/start_contacts.hpp"

#include <cstdio>
#include <memory>

#include "core/geometry/trees/point_tree.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

constexpr double within = 1 - 1e-9;  // factor of the contact distance, so that rows at exactly this distance
                                     // do not count

struct ContactWarnings {
  const World& w;
  const ReportedPairs& reported;
  Reducer& all;
  std::vector<SceneWarning>& warnings;

  std::string name(std::size_t sheet) const { return "sheet '" + w.scene.sheets[sheet].name + "'"; }

  /// Appends a warning; `what`: "12 of its 81 vertices" or the like.
  void warn(std::size_t sheet, const std::string& what, double reach, const std::string& other) {
    char text[80];
    std::snprintf(text, sizeof text, " start within its contact distance, %.3g m, of ", reach);
    warnings.push_back({w.scene.sheets[sheet].where,
                        name(sheet) + ": " + what + text + other + ": contact will push them apart"});
  }

  /// Returns the number of a sheet's vertices for which `is(place, clamped)`, and their total, over all
  /// ranks.
  template<class Is> std::pair<std::int64_t, std::int64_t> count(std::size_t sheet, Is&& is) {
    const Sheets& s = w.sheets.rows;
    std::int64_t n[2] = {0, 0};
    for (std::size_t i = 0; i < s.owned; i++)
      if (s.body[i] == sheet) n[0] += is(s.position[i], s.clamped.active && s.clamped[i]), n[1]++;
    all.sum(n);
    return {n[0], n[1]};
  }

  template<class Is> bool warnOfVertices(std::size_t sheet, double reach, const std::string& other, Is&& is) {
    const auto [n, of] = count(sheet, is);
    if (n > 0) warn(sheet, std::to_string(n) + " of its " + std::to_string(of) + " vertices", reach, other);
    return n > 0;
  }

  void walls(std::size_t sheet) {
    const double reach = within * w.sheets.plans[sheet].thickness;
    for (const Wall& wall : w.walls.list) {
      const std::string other = "obstacle '" + wall.properties.name + "'";
      if (!wall.present || reported.count({name(sheet), other})) continue;
      warnOfVertices(sheet, reach, other, [&](const Vec3d& x, bool clamped) {
        return !clamped && wall.shape->distanceWithin(toRest(wall.pose, x), reach) < reach;
      });
    }
  }

  /// Warns about particles of bodies near the vertices of a fine sheet, or near the triangles of a coarse
  /// sheet.
  void bodies(std::size_t sheet) {
    if (w.scene.bodies.empty()) return;
    const SheetPlan& plan = w.sheets.plans[sheet];
    const double reach = within * (plan.byFaces ? plan.faceReach : 0.5 * (plan.thickness + w.scene.spacing));
    const auto points = plan.byFaces ? nullptr : std::make_unique<PointTree>(plan.mesh.vertices);
    const auto faces = plan.byFaces ? std::make_unique<TriangleBvh>(plan.mesh) : nullptr;
    std::vector<std::int64_t> n(w.scene.bodies.size(), 0);
    const Continuum& p = w.particles;
    for (std::size_t j = 0; j < p.owned; j++)
      if (p.body[j] < n.size())
        n[p.body[j]] += faces ? faces->closest(p.position[j], reach).distance2 < reach * reach
                              : !points->within(p.position[j], reach).empty();
    all.sum(n);
    for (std::size_t b = 0; b < n.size(); b++) {
      const std::string other = "body '" + w.scene.bodies[b].name + "'";
      if (n[b] > 0 && !reported.count({name(sheet), other}))
        warn(sheet, std::to_string(n[b]) + " particles", reach, other);
    }
  }

  void orientedBodies(std::size_t sheet, const std::vector<std::unique_ptr<PointTree>>& trees) {
    for (std::size_t k = 0; k < trees.size(); k++) {
      const OrientedBody& body = w.scene.oriented[k];
      const std::string other = "oriented body '" + body.name + "'";
      const double reach = within * 0.5 * (w.sheets.plans[sheet].thickness + spacingOf(w.scene, body));
      if (!reported.count({name(sheet), other}))
        warnOfVertices(sheet, reach, other,
                       [&](const Vec3d& x, bool) { return !trees[k]->within(x, reach).empty(); });
    }
  }

  /// Warns once about each pair of sheets: about vertices of the later sheet, or of the earlier sheet if the
  /// later one has none nearby.
  void sheets(std::size_t sheet, const std::vector<std::unique_ptr<TriangleBvh>>& faces) {
    for (std::size_t k = 0; k < sheet; k++) {
      if (reported.count({name(sheet), name(k)})) continue;
      const double reach = within * 0.5 * (w.sheets.plans[sheet].thickness + w.sheets.plans[k].thickness);
      const auto near = [&](std::size_t of) {
        return
            [&, of](const Vec3d& x, bool) { return faces[of]->closest(x, reach).distance2 < reach * reach; };
      };
      if (!warnOfVertices(sheet, reach, name(k), near(k))) warnOfVertices(k, reach, name(sheet), near(sheet));
    }
  }
};

}  // namespace

void warnOfStartContacts(const World& w, const std::vector<std::vector<Vec3d>>& oriented,
                         const ReportedPairs& reported, Reducer& all, std::vector<SceneWarning>& warnings) {
  std::vector<std::unique_ptr<PointTree>> trees;
  for (const std::vector<Vec3d>& places : oriented) trees.push_back(std::make_unique<PointTree>(places));
  std::vector<std::unique_ptr<TriangleBvh>> faces;
  if (w.sheets.plans.size() > 1)
    for (const SheetPlan& plan : w.sheets.plans) faces.push_back(std::make_unique<TriangleBvh>(plan.mesh));
  ContactWarnings meetings{w, reported, all, warnings};
  for (std::size_t n = 0; n < w.sheets.plans.size(); n++) {
    meetings.walls(n);
    meetings.bodies(n);
    meetings.orientedBodies(n, trees);
    meetings.sheets(n, faces);
  }
}

}  // namespace thaw
