// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/start_warnings.hpp"

#include <cstdio>
#include <utility>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/simulation/setup/warnings/start_contacts.hpp"
#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

constexpr double thickest = 3;  // in units of the vertex spacing
constexpr double deep = 0.5;    // fraction of the thickness; static contacts are less deep
// Fraction of the contact distance of points. If surfaces cross, few points are closer than half the
// distance.
constexpr double close = 0.6;

/// Names of a body and its rows, and its contact.
struct RowOwner {
  SourcePlace where;
  std::string name;
  const char* rows;
  double thickness;                  // m, contact distance to an obstacle
  std::string shrinkWrapTargetName;  // target of its shrink-wrap, which pulls rows onto the surface from both
                                     // sides
};

std::string counted(std::int64_t n, std::int64_t all, const RowOwner& who) {
  return who.name + ": " + std::to_string(n) + " of its " + std::to_string(all) + " " + who.rows;
}

/// Counts rows of each body for which `is(row, k)`, for each k of a list, over all ranks: [body][k], then the
/// total of rows.
template<class Is>
std::vector<std::vector<std::int64_t>> countRows(const BodyTypeRows& rows, std::size_t bodies,
                                                 std::size_t things, Reducer& all, Is&& is) {
  std::vector<std::int64_t> n(bodies * (things + 1), 0);
  for (std::size_t i = 0; i < rows.owned; i++) {
    std::int64_t* of = n.data() + rows.body[i] * (things + 1);
    for (std::size_t k = 0; k < things; k++) of[k] += is(i, k);
    of[things]++;
  }
  all.sum(n);
  std::vector<std::vector<std::int64_t>> counts(bodies);
  for (std::size_t b = 0; b < bodies; b++)
    counts[b].assign(n.begin() + static_cast<std::ptrdiff_t>(b * (things + 1)),
                     n.begin() + static_cast<std::ptrdiff_t>((b + 1) * (things + 1)));
  return counts;
}

void warnOfPlaces(const World& w, const BodyTypeRows& rows, const std::vector<RowOwner>& whose,
                  const std::vector<std::shared_ptr<const SignedDistance>>& shapes, Reducer& all,
                  SceneProblems& problems, std::vector<SceneWarning>& warnings, ReportedPairs& reported) {
  const auto inBodies = countRows(rows, whose.size(), shapes.size(), all, [&](std::size_t i, std::size_t k) {
    return shapes[k] && shapes[k]->inside(rows.position[i]);
  });
  auto inWalls = countRows(rows, whose.size(), w.walls.list.size(), all, [&](std::size_t i, std::size_t k) {
    const Wall& wall = w.walls.list[k];
    const double keep = deep * whose[rows.body[i]].thickness;
    return wall.present && wall.shape->distanceWithin(toRest(wall.pose, rows.position[i]), keep) < keep;
  });
  for (std::vector<std::int64_t>& counts : inWalls)
    for (std::size_t k = 0; k < w.walls.list.size(); k++)
      if (w.walls.list[k].isImage()) counts[w.walls.list[k].imageOf] += std::exchange(counts[k], 0);

  // A cloth through a ball stays there, since contact pushes vertices to the nearest side.
  const auto warnOfInside = [&](const RowOwner& who, const std::string& text, const Body& body) {
    if (!solidAt(w.scene.materials[static_cast<std::size_t>(body.material)], body.temperature))
      warnings.push_back(
          {who.where, text + "; contact will push the liquid of body '" + body.name + "' away"});
    else if (who.shrinkWrapTargetName == body.name) return;
    else if (w.scene.numerics.overlap == OverlapRule::Keep)
      warnings.push_back({who.where, text + "; contact traps them there: move the bodies apart"});
    else
      problems.add(
          who.where,
          text + ", where they would stay trapped; move them apart, or set `numerics.overlap` to \"keep\"");
  };
  for (std::size_t b = 0; b < whose.size(); b++) {
    const std::int64_t n = inBodies[b].back();
    for (std::size_t k = 0; k < shapes.size(); k++)
      if (inBodies[b][k] > 0) {
        const std::string body = "body '" + w.scene.bodies[k].name + "'";
        reported.insert({whose[b].name, body});
        warnOfInside(whose[b], counted(inBodies[b][k], n, whose[b]) + " start inside " + body,
                     w.scene.bodies[k]);
      }
    for (std::size_t k = 0; k < w.walls.list.size(); k++) {
      if (inWalls[b][k] == 0) continue;
      const std::string wall = "obstacle '" + w.walls.list[k].properties.name + "'";
      reported.insert({whose[b].name, wall});
      warnings.push_back({whose[b].where, counted(inWalls[b][k], n, whose[b]) +
                                              (inWalls[b][k] == 1 ? " overlaps " : " overlap ") + wall +
                                              " by more than half of their thickness: contact adds energy"});
    }
  }
}

/// Sheet or oriented body as a contact partner.
struct Other {
  const std::vector<Vec3d>* places;  // positions of all its rows
  std::string name;
  double width;  // m; two bodies touch at the mean of their widths
};

/// Warns about rows that start deep in contact with an earlier body of `others`. first: index of the first
/// body of `whose` there.
void warnOfOthers(const BodyTypeRows& rows, const std::vector<RowOwner>& whose,
                  const std::vector<Other>& others, std::size_t first, Reducer& all,
                  std::vector<SceneWarning>& warnings, ReportedPairs& reported) {
  if (first + whose.size() < 2) return;
  std::vector<std::unique_ptr<PointTree>> trees;
  for (std::size_t k = 0; k + 1 < first + whose.size(); k++)
    trees.push_back(std::make_unique<PointTree>(*others[k].places));
  const auto counts = countRows(rows, whose.size(), trees.size(), all, [&](std::size_t i, std::size_t k) {
    const std::size_t own = first + rows.body[i];
    return k < own &&
           !trees[k]->within(rows.position[i], close * 0.5 * (others[own].width + others[k].width)).empty();
  });
  for (std::size_t b = 0; b < whose.size(); b++)
    for (std::size_t k = 0; k < first + b; k++)
      if (counts[b][k] > 0) {
        reported.insert({whose[b].name, others[k].name});
        warnings.push_back({whose[b].where, counted(counts[b][k], counts[b].back(), whose[b]) +
                                                " start nearer to " + others[k].name +
                                                " than 0.6 of the contact distance: contact adds energy"});
      }
}

}  // namespace

std::vector<SceneWarning> bodyTypeStartWarnings(
    const World& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
    const std::vector<std::vector<Vec3d>>& oriented, Reducer& all, SceneProblems& problems) {
  std::vector<Other> others;
  for (std::size_t b = 0; b < oriented.size(); b++) {
    const OrientedBody& body = w.scene.oriented[b];
    others.push_back({&oriented[b], "oriented body '" + body.name + "'", spacingOf(w.scene, body)});
  }
  for (std::size_t n = 0; n < w.scene.sheets.size() && w.modules.sheet; n++)
    others.push_back({&w.sheets.plans[n].mesh.vertices, "sheet '" + w.scene.sheets[n].name + "'",
                      w.sheets.plans[n].thickness});
  std::vector<SceneWarning> warnings;
  ReportedPairs reported;
  std::vector<RowOwner> whose;
  for (const OrientedBody& b : w.scene.oriented)
    whose.push_back(
        {b.where, "oriented body '" + b.name + "'", "particles", b.thickness * spacingOf(w.scene, b), ""});
  if (w.modules.oriented) warnOfPlaces(w, w.oriented.rows, whose, shapes, all, problems, warnings, reported);
  if (w.modules.oriented) warnOfOthers(w.oriented.rows, whose, others, 0, all, warnings, reported);
  if (!w.modules.sheet) return warnings;
  const Sheets& s = w.sheets.rows;
  whose.clear();
  for (std::size_t n = 0; n < w.scene.sheets.size(); n++)
    whose.push_back({w.scene.sheets[n].where, "sheet '" + w.scene.sheets[n].name + "'", "vertices",
                     w.sheets.plans[n].thickness,
                     w.scene.sheets[n].shrinkWrap != 0 ? w.scene.sheets[n].shrinkWrapTo : ""});
  warnOfPlaces(w, s, whose, shapes, all, problems, warnings, reported);
  warnOfOthers(s, whose, others, oriented.size(), all, warnings, reported);
  warnOfStartContacts(w, oriented, reported, all, warnings);
  const auto free = countRows(s, whose.size(), 1, all, [&](std::size_t i, std::size_t) {
    return !(s.clamped.active && s.clamped[i]);
  });
  for (std::size_t n = 0; n < whose.size(); n++) {
    if (free[n][0] == 0)
      warnings.push_back({whose[n].where, whose[n].name + ": all of its " + std::to_string(free[n][1]) +
                                              " vertices are clamped: it does not move"});
    if (const DroppedElements& out = w.sheets.plans[n].droppedElements; out.triangles + out.vertices > 0)
      warnings.push_back(
          {whose[n].where,
           whose[n].name + ": " + std::to_string(out.triangles) +
               " triangles of its mesh (degenerate or duplicate) and " + std::to_string(out.vertices) +
               " vertices (without a triangle) are dropped: vertex numbers differ from the file's"});
    const double spacing = w.sheets.plans[n].spacing;
    if (char text[240]; whose[n].thickness > thickest * spacing) {
      std::snprintf(text, sizeof text,
                    ": its thickness, %g m, is more than three times its vertex spacing, %g m: "
                    "contact is slow, and keeps it far from other bodies",
                    whose[n].thickness, spacing);
      warnings.push_back({whose[n].where, whose[n].name + text});
    }
  }
  return warnings;
}

}  // namespace thaw
