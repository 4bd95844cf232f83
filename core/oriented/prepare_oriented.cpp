// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/prepare_oriented.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/domain/outside.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/sampling/sampling.hpp"
#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/forces/constraints.hpp"
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

// Spacings. Particles of two bodies at almost the same position repel strongly, or not at all.
constexpr double samePlace = 0.1;

/// Adds problems for bodies with common positions, and for duplicate points. All ranks test all positions.
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
        problems.add(s.oriented[other].where,
                     "oriented body '" + s.oriented[other].name + "': " + std::to_string(count) +
                         " of its particles are at positions of '" + body.name +
                         "'; move them apart, or set `numerics.overlap` to \"keep\"");
    }
  }
}

}  // namespace

void activateOriented(Oriented& o, const Scene& scene, const Modules& modules) {
  activateBodyType(o);
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{
           &o.orientation, &o.spin, &o.inertia, &o.force, &o.torque, &o.group, &o.cutSides, &o.flags,
           &o.constraint, &o.restPosition, &o.restOrientation, &o.normal, &o.stiffness})
    o.activate(*c);
  bool changes = false;
  for (const OrientedBody& b : scene.oriented)
    changes = changes || b.growth != OrientedGrowth::None || b.removalDistance > 0;
  if (modules.orientedContact || modules.sheetContact)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.external, &o.dissipativeForce}) o.activate(*c);
  if (changes)
    for (AnyColumn* c : std::initializer_list<AnyColumn*>{&o.candidate, &o.candidatePriority}) o.activate(*c);
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
    } catch (const std::invalid_argument&) {  // sampleOriented reports this error
    } catch (const std::runtime_error&) {}
  }
}

namespace {

/// Samples a body, with the same result on all ranks. On failure, adds a problem and returns false.
bool tryToSample(const Scene& scene, std::size_t b, const MeshLoader& load, SampledPoints& sampled,
                 SceneProblems& problems) {
  const OrientedBody& body = scene.oriented[b];
  const std::string name = "oriented body '" + body.name + "': ";
  try {
    sampled = samplePoints(body, spacingOf(scene, body), scene.seed + b, load);
  } catch (const std::invalid_argument& e) {
    problems.add(body.where, name + e.what());
    return false;
  } catch (const ShapeError& e) {
    problems.add(e.where.line > 0 ? e.where : body.where, name + e.what());
    return false;
  } catch (const std::runtime_error& e) {  // mesh that cannot be read
    problems.add(body.where, name + e.what());
    return false;
  }
  if (body.growth != OrientedGrowth::None && sampled.places.size() > static_cast<std::size_t>(body.most))
    problems.add(body.where, name + "it starts with " + std::to_string(sampled.places.size()) +
                                 " particles and `most` is " + std::to_string(body.most) +
                                 "; expected `most` to be at least the initial number");
  return true;
}

void warnOfNotes(const SourcePlace& where, const std::string& whose, const std::vector<std::string>& notes,
                 std::vector<SceneWarning>& warnings) {
  for (const std::string& note : notes) warnings.push_back({where, whose + ": " + note});
}

/// Constraints of a body. A particle belongs to the first constraint that contains it.
struct ConstraintRegions {
  const OrientedBody& body;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;  ///< null if the shape has a problem
  std::vector<std::size_t> count;                             ///< number of particles inside, on all ranks

  ConstraintRegions(const OrientedBody& b, const MeshLoader& load, SceneProblems& problems,
                    std::vector<SceneWarning>& warnings)
      : body(b), count(b.constraints.size(), 0) {
    for (const OrientedConstraint& a : body.constraints) {
      const std::string whose = "oriented body '" + body.name + "': a constraint";
      shapes.push_back(makeSignedDistance(a.region, load, whose, problems));
      std::vector<std::string> notes;
      if (shapes.back()) shapes.back()->addNotes(notes);
      warnOfNotes(a.where, whose, notes, warnings);
    }
  }

  /// Returns the index of the constraint at x (m), or noConstraint. Counts x for each constraint that
  /// contains it.
  std::uint16_t at(const Vec3d& x) {
    std::uint16_t constraint = noConstraint;
    for (std::size_t a = shapes.size(); a-- > 0;)
      if (shapes[a] && shapes[a]->inside(x)) {
        count[a]++;
        constraint = static_cast<std::uint16_t>(a);
      }
    return constraint;
  }

  void refuseEmpty(SceneProblems& problems) const {
    for (std::size_t a = 0; a < count.size(); a++)
      if (shapes[a] && count[a] == 0)
        problems.add(
            body.constraints[a].where,
            "oriented body '" + body.name + "': no particle lies in this constraint; expected at least one");
  }
};

/// Initial state of a particle.
struct SampledParticle {
  std::size_t number;  ///< number in its body
  Vec3d position, normal;
  std::uint8_t flags;
  std::uint16_t constraint;
};

/// Appends a row for a particle of body b. Particles without constraints are jittered.
void addSampledRow(Oriented& o, const Scene& scene, std::size_t b, const SampledParticle& p) {
  const OrientedBody& body = scene.oriented[b];
  const double s = spacingOf(scene, body);
  const Vec3d x = p.position;
  const bool jitters = body.jitter > 0 && !p.flags;
  const std::size_t i = o.owned;
  o.resize(i + 1, 0);
  o.id[i] = static_cast<std::uint64_t>(b) << 40 | static_cast<std::uint64_t>(p.number);
  o.position[i] = o.restPosition[i] = jitters ? jittered(x, body.jitter, s, scene.seed, o.id[i]) : x;
  o.velocity[i] = body.velocity;
  o.orientation[i] = o.restOrientation[i] = towards(p.normal);
  if (jitters) {
    const Vec3d turn = jittered({}, body.jitter, 1, scene.seed + 1, o.id[i]);
    o.orientation[i] = unitQuat(rotationBy(body.planar ? Vec3d{0, turn.y, 0} : turn) * o.orientation[i]);
    if (body.planar) o.position[i].y = x.y;
  }
  o.mass[i] = orientedMass(body, s);
  o.inertia[i] = body.inertia * o.mass[i] * s * s;
  o.body[i] = static_cast<std::uint16_t>(b);
  o.group[i] = static_cast<std::uint32_t>(b);
  o.flags[i] = p.flags;
  o.constraint[i] = p.constraint;
}

/// Returns all particles of a body, with their constraints from fixed points and from constraint regions.
std::vector<SampledParticle> particlesOf(const SampledPoints& sampled, ConstraintRegions& constraints) {
  std::vector<SampledParticle> particles;
  for (std::size_t k = 0; k < sampled.places.size(); k++) {
    const Vec3d x = sampled.places[k];
    const std::uint16_t constraint = constraints.at(x);
    std::uint8_t flags = sampled.flags[k];
    if (constraint != noConstraint)
      flags = static_cast<std::uint8_t>(
          (constraints.body.constraints[constraint].position ? fixedPosition : 0) |
          (constraints.body.constraints[constraint].normal ? fixedOrientation : 0));
    particles.push_back({k, x, sampled.normals[k], flags, constraint});
  }
  return particles;
}

void refuseOutside(const Scene& scene, const OrientedBody& body, const std::vector<Vec3d>& places,
                   SceneProblems& problems) {
  Outside outside;
  for (const Vec3d& x : places) outside.look(scene.domain, x);
  if (outside.count > 0)
    problems.add(body.where, "oriented body '" + body.name + "': " +
                                 outsideText(outside, scene.domain, static_cast<std::int64_t>(places.size()),
                                             "particles", "body"));
}

}  // namespace

std::vector<std::vector<Vec3d>> sampleOriented(Oriented& o, const Scene& scene, Halos halos,
                                               const MeshLoader& load, std::vector<SceneWarning>& warnings) {
  const auto ranks = static_cast<std::size_t>(halos.all.size()),
             rank = static_cast<std::size_t>(halos.all.rank());
  SceneProblems problems;
  std::vector<std::vector<Vec3d>> places(scene.oriented.size());
  for (std::size_t b = 0; b < scene.oriented.size(); b++) {
    const OrientedBody& body = scene.oriented[b];
    SampledPoints sampled;
    if (!tryToSample(scene, b, load, sampled, problems)) continue;
    places[b] = sampled.places;
    warnOfNotes(body.where, "oriented body '" + body.name + "'", sampled.notes, warnings);
    ConstraintRegions constraints(body, load, problems, warnings);
    for (const SampledParticle& p : particlesOf(sampled, constraints))
      if (p.number % ranks == rank) addSampledRow(o, scene, b, p);
    constraints.refuseEmpty(problems);
    refuseOutside(scene, body, places[b], problems);
  }
  if (scene.numerics.overlap != OverlapRule::Keep) refuseSharedPositions(scene, places, problems);
  problems.raise();
  return places;
}

}  // namespace thaw
