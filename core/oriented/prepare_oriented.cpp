// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/prepare_oriented.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/domain/outside.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/sampling/sampling.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/forces/anchors.hpp"
#include "core/oriented/forces/fields.hpp"
#include "core/oriented/sampling/sample_points.hpp"

namespace thaw {
namespace {

bool interpolates(const OrientedBody& b) {
  return b.growth == OrientedGrowth::Borders && (b.thin < 1 || b.source == OrientedSource::Points);
}

void storeInterpolant(const SampledPoints& m, PointInterpolant& g) {
  g.points = m.places;
  g.normals = m.normals;
  buildInterpolant(g);
  if (m.reach > 0) g.reach = m.reach / g.apart;
}

// Spacings: particles of two bodies at nearly one position repel strongly, or not at all.
constexpr double samePlace = 0.1;

/// Adds problems for bodies that share positions and for duplicate points. All ranks test all positions.
void refuseSharedPositions(const Scene& s, const std::vector<std::vector<Vec3d>>& places,
                           SceneProblems& problems) {
  for (std::size_t b = 0; b < places.size(); b++) {
    if (places[b].empty()) continue;
    const OrientedBody& body = s.oriented[b];
    const PointTree tree(places[b]);
    if (body.source == OrientedSource::Points) {
      std::size_t twice = 0;
      for (const Vec3d& x : places[b]) twice += tree.within(x, 1e-6 * spacingOf(s, body)).size() > 1;
      if (twice > 0)
        problems.add(body.where,
                     "oriented body '" + body.name + "': " + std::to_string(twice) +
                         " of its points are duplicates of another point; expected distinct points");
    }
    for (std::size_t other = b + 1; other < places.size(); other++) {
      const double near = samePlace * std::min(spacingOf(s, body), spacingOf(s, s.oriented[other]));
      std::size_t count = 0;
      for (const Vec3d& x : places[other]) count += !tree.within(x, near).empty();
      if (count > 0)
        problems.add(s.oriented[other].where, "oriented body '" + s.oriented[other].name +
                                                  "': " + std::to_string(count) +
                                                  " of its particles are at positions of '" + body.name +
                                                  "'; move them apart, or set numerics.overlap to \"keep\"");
    }
  }
}

}  // namespace

void activateOriented(Oriented& o, const Scene& scene, const Modules& modules) {
  activateBodyType(o);
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{
           &o.orientation, &o.spin, &o.inertia, &o.force, &o.torque, &o.group, &o.cutSides, &o.flags,
           &o.anchor, &o.restPosition, &o.restOrientation, &o.normal, &o.stiffness})
    o.activate(*c);
  bool changes = false;
  for (const OrientedBody& b : scene.oriented)
    changes = changes || b.growth != OrientedGrowth::None || b.crowd > 0;
  if (modules.orientedContact || modules.sheetContact)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.external, &o.dissipativeForce}) o.activate(*c);
  if (changes)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.candidate, &o.candidateRank}) o.activate(*c);
  if (!scene.oriented.empty() && scene.oriented.front().integrator == OrientedIntegrator::SemiImplicit)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.search, &o.searchSpin}) o.activate(*c);
}

void prepareOriented(Scene& s, OrientedWork& work, const MeshLoader& load) {
  for (OrientedBody& b : s.oriented) b.cellShare = areaFactorOf(b, spacingOf(s, b));
  work.potentials.clear();
  for (const OrientedBody& b : s.oriented) work.potentials.push_back(pairPotential(b, spacingOf(s, b)));
  work.fieldRegions = fieldRegions(s, load);
  work.given.assign(s.oriented.size(), {});
  for (std::size_t b = 0; b < s.oriented.size(); b++) {
    if (!interpolates(s.oriented[b])) continue;
    try {
      storeInterpolant(samplePoints(s.oriented[b], spacingOf(s, s.oriented[b]), s.seed + b, load),
                       work.given[b]);
    } catch (const std::invalid_argument&) {  // sampleOriented reports the error
    } catch (const std::runtime_error&) {}
  }
}

std::vector<std::vector<Vec3d>> sampleOriented(Oriented& o, const Scene& scene, Halos halos,
                                               const MeshLoader& load, std::vector<SceneWarning>& warnings) {
  SceneProblems problems;
  const auto ranks = static_cast<std::size_t>(halos.all.size()),
             rank = static_cast<std::size_t>(halos.all.rank());
  std::vector<std::vector<Vec3d>> places(scene.oriented.size());
  for (std::size_t b = 0; b < scene.oriented.size(); b++) {
    const OrientedBody& body = scene.oriented[b];
    const double s = spacingOf(scene, body);
    SampledPoints made;
    try {
      made = samplePoints(body, s, scene.seed + b, load);
    } catch (const std::invalid_argument& e) {
      problems.add(body.where, "oriented body '" + body.name + "': " + e.what());
      continue;
    } catch (const ShapeError& e) {
      problems.add(e.where.line > 0 ? e.where : body.where, "oriented body '" + body.name + "': " + e.what());
      continue;
    } catch (const std::runtime_error& e) {  // mesh that cannot be read
      problems.add(body.where, "oriented body '" + body.name + "': " + e.what());
      continue;
    }
    places[b] = made.places;
    const auto warn = [&](const SourcePlace& where, const std::string& whose,
                          const std::vector<std::string>& notes) {
      for (const std::string& note : notes) warnings.push_back({where, whose + ": " + note});
    };
    warn(body.where, "oriented body '" + body.name + "'", made.notes);
    if (body.growth != OrientedGrowth::None && made.places.size() > static_cast<std::size_t>(body.most))
      problems.add(body.where, "oriented body '" + body.name + "': it starts with " +
                                   std::to_string(made.places.size()) + " particles and `most` is " +
                                   std::to_string(body.most) +
                                   "; expected `most` to be at least the initial number");
    std::vector<std::shared_ptr<const SignedDistance>> regions;
    for (const OrientedAnchor& a : body.anchors) {
      const std::string whose = "oriented body '" + body.name + "': an anchor";
      regions.push_back(makeSignedDistance(a.region, load, whose, problems));
      std::vector<std::string> notes;
      if (regions.back()) regions.back()->addNotes(notes);
      warn(a.where, whose, notes);
    }
    std::vector<std::size_t> holds(body.anchors.size(), 0);
    Outside outside;
    for (std::size_t k = 0; k < made.places.size(); k++) {
      const Vec3d x = made.places[k];
      outside.look(scene.domain, x);
      std::uint8_t flags = made.held[k];
      std::uint16_t anchor = noAnchor;
      for (std::size_t a = regions.size(); a-- > 0;)  // the first anchor that contains it
        if (regions[a] && regions[a]->inside(x)) {
          holds[a]++;
          anchor = static_cast<std::uint16_t>(a);
          flags = static_cast<std::uint8_t>((body.anchors[a].position ? fixedPosition : 0) |
                                            (body.anchors[a].normal ? fixedOrientation : 0));
        }
      if (k % ranks != rank) continue;
      const std::size_t i = o.owned;
      o.resize(i + 1, 0);
      o.id[i] = static_cast<std::uint64_t>(b) << 40 | static_cast<std::uint64_t>(k);
      o.position[i] = o.restPosition[i] = body.jitter > 0 && !flags
                                              ? jittered(x, body.jitter, s, scene.seed, o.id[i])
                                              : x;
      o.velocity[i] = body.velocity;
      o.orientation[i] = o.restOrientation[i] = towards(made.normals[k]);
      if (body.jitter > 0 && !flags) {
        const Vec3d off = jittered({}, body.jitter, 1, scene.seed + 1, o.id[i]);
        o.orientation[i] = unitQuat(rotationBy(body.planar ? Vec3d{0, off.y, 0} : off) * o.orientation[i]);
        if (body.planar) o.position[i].y = x.y;
      }
      o.mass[i] = orientedMass(body, s);
      o.inertia[i] = body.inertia * o.mass[i] * s * s;
      o.body[i] = static_cast<std::uint16_t>(b);
      o.group[i] = static_cast<std::uint32_t>(b);
      o.flags[i] = flags;
      o.anchor[i] = anchor;
    }
    for (std::size_t a = 0; a < holds.size(); a++)
      if (regions[a] && holds[a] == 0)
        problems.add(body.anchors[a].where, "oriented body '" + body.name +
                                                "': no particle lies in this anchor; expected at least one");
    if (outside.count > 0)
      problems.add(body.where,
                   "oriented body '" + body.name + "': " +
                       outsideText(outside, scene.domain, static_cast<std::int64_t>(made.places.size()),
                                   "particles", "body"));
  }
  if (scene.numerics.overlap != OverlapRule::Keep) refuseSharedPositions(scene, places, problems);
  problems.raise();
  return places;
}

}  // namespace thaw
