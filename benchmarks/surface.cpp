// SPDX-License-Identifier: Apache-2.0
// surface [--surfels N] [--repeat R] [--only GROUP] [--csv FILE]: cost of surface updates on one core, and
// accuracy of a ball's surface.
//   iteration: full iterations of all surfels of a ball for several supports h_ss; ns per surfel and
//   iteration,
//              by phase
//   update:    a whole update of a melting bust of 4,000 particles, from the particle copies to the blend,
//              until the local stop
//   whole updates: updateSurface with resampling, components and measures, of a solid and a molten bust
//              (benchmarks/surface/whole_updates.hpp), with h_ss = 3 d, 2.5 d and, for the molten bust, the
//              support radius of the particles; by phase
//   ball:      surfels relaxed on a ball of whole lattice cells, against the exact ball, for the same h_ss.
//   Its
//              error includes the staircase. The accuracy case surface_ball has balls of scenes and targets
// --only: iterations, update, solid, molten (whole updates) or balls. Times are processor time. Searches,
// placement and once-per-update work are listed separately, in ms.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <numbers>

#include "benchmarks/surface/row.hpp"
#include "benchmarks/surface/whole_updates.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/surface/advection/displace.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/blend.hpp"
#include "tests/support/surface/relax_rig.hpp"

namespace {

using namespace thaw;
using test::RelaxRig;
using Row = SurfaceRow;

/// Processor time (s), which depends less on other load of the machine.
double seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Mean numbers of particles within h_ps and surfels within h_ss of a surfel.
void neighbours(const RelaxRig& rig, double& particles, double& surfels) {
  const Surface& s = rig.w.surface;
  std::size_t n = 0, counted[2]{0, 0};
  for (std::size_t i = 0; i < s.surfels.owned; i += 37, n++) {
    const auto within = [&](const auto& rows, double h) {
      std::size_t found = 0;
      for (std::size_t j = 0; j < rows.owned; j++) {
        const Vec3d d = rows.position[j] - s.surfels.position[i];
        found += dot(d, d) < h * h;
      }
      return found;
    };
    counted[0] += within(s.particles, s.particleSupport);
    counted[1] += within(s.surfels, s.surfelSupport) - 1;
  }
  particles = static_cast<double>(counted[0]) / static_cast<double>(n);
  surfels = static_cast<double>(counted[1]) / static_cast<double>(n);
}

/// Twelve full iterations of about `surfels` surfels on a ball of 4,000 particles. On so small a ball a
/// surfel has 114 particles within twice their support radius, against 134 on a plane. A slightly larger
/// particle support gives 130.
Row iterations(const std::string& name, double surfels, int repeat,
               const std::function<void(Scene&, double spacing)>& change) {
  const double R = 9.85, spacing = std::sqrt(4 * std::numbers::pi * R * R / (0.866 * surfels));
  Row best;
  for (int k = 0; k < repeat; k++) {
    RelaxRig rig(spacing, R + 6, [&](Scene& s) {
      s.surface.stop = 1e-6, s.surface.particleSupport = 2.1, change(s, spacing);
    });
    rig.addLattice(12, {0.5, 0.5, 0.5}, [&](const Vec3d& x) { return length(x) < R; });
    rig.addBallSurfels(R);
    rig.place();
    rig.relaxSurfels(8);
    rig.tools.relax.times = {};
    rig.relaxSurfels(12);
    Row r;
    r.name = name;
    r.particles = static_cast<double>(rig.w.surface.particles.owned);
    r.surfels = static_cast<double>(rig.w.surface.surfels.owned);
    neighbours(rig, r.aroundParticles, r.aroundSurfels);
    fillPhases(r, rig.tools.relax.times);
    r.targetRate = name == "iteration" ? 1e6 : 0;  // surfels/s
    r.searchMs = 1e3 * rig.tools.relax.times.search;
    r.searches = static_cast<double>(rig.tools.relax.times.searches);
    if (r.rate > best.rate) best = r;
  }
  return best;
}

using PointWork = std::function<void(const Vec3d&)>;

/// Calls at(x) for the points of a cubic lattice in a box.
void forLattice(const Bounds& b, double spacing, const PointWork& at) {
  for (double z = b.min.z + 0.5 * spacing; z < b.max.z; z += spacing)
    for (double y = b.min.y + 0.5 * spacing; y < b.max.y; y += spacing)
      for (double x = b.min.x + 0.5 * spacing; x < b.max.x; x += spacing) at({x, y, z});
}

/// Returns the height of a bust of `particles` particles, in particle spacings. unit: bust of height 1.
double heightOfBust(const SignedDistance& unit, double particles) {
  double height = 40;
  for (int k = 0; k < 3; k++) {
    std::size_t n = 0;
    forLattice(unit.bounds(), 1 / height, [&](const Vec3d& x) { n += unit.inside(x); });
    height *= std::cbrt(particles / static_cast<double>(n));
  }
  return height;
}

/// Surfels of a body, one per spacing^2.
struct Skin {
  double spacing = 0.2;
  std::vector<std::pair<Vec3d, Vec3d>> points;  ///< position and normal
};

/// Returns about this number of surfels: points of a fine lattice within half its spacing of the surface.
Skin skinOf(const SignedDistance& body, double surfels) {
  Skin skin;
  for (int k = 0; k < 3; k++) {
    skin.points.clear();
    forLattice(body.bounds(), skin.spacing, [&](const Vec3d& x) {
      Vec3d n;
      const double d = body.distanceWithin(x, skin.spacing, &n);
      if (std::abs(d) < 0.5 * skin.spacing) skin.points.emplace_back(x - d * n, n);
    });
    if (k < 2) skin.spacing *= std::sqrt(static_cast<double>(skin.points.size()) / surfels);
  }
  return skin;
}

/// The builtin bust, melting from below: the lowest third is liquid and spreads, the next tenth is mixed.
struct MeltingBust {
  double height;
  std::shared_ptr<const SignedDistance> shape;
  float liquidAt(const Vec3d& x) const {
    return static_cast<float>(std::clamp((0.43 * height - x.z) / (0.1 * height), 0.0, 1.0));
  }
  /// Spreads and sinks the liquid by at most a quarter of a support radius.
  Vec3d displacementAt(const Vec3d& x) const {
    return static_cast<double>(liquidAt(x)) * 0.5 * Vec3d{0.5 * x.x, 0.5 * x.y, -x.z} / (0.43 * height);
  }
};

MeltingBust meltingBust(double particles) {
  Shape shape;
  shape.kind = ShapeKind::Mesh;
  shape.mesh = "builtin:bust";
  shape.scale = heightOfBust(*makeSignedDistance(shape), particles);
  return {shape.scale, makeSignedDistance(shape)};
}

/// Adds the bust's particles and surfels, and relaxes the liquid part of the surface, as after an update.
void placeBust(RelaxRig& rig, const MeltingBust& bust, const Skin& skin) {
  World& w = rig.w;
  forLattice(bust.shape->bounds(), 1, [&](const Vec3d& x) {
    if (bust.shape->inside(x)) rig.addParticle(x, bust.displacementAt(x), 1, bust.liquidAt(x));
  });
  for (const auto& [x, n] : skin.points) rig.addSurfel(x, n, 1, 0);
  rig.place();
  rig.tools.relax.particlesPrepared = false;
  sampleFields(w.scene, w.surface, rig.ranks->halos(), rig.tools);
  rig.relaxSurfels(100, false);
  w.surface.particles.resize(w.surface.particles.owned, 0);
  rig.place();
}

/// Measures one update.
Row updateOf(RelaxRig& rig) {
  World& w = rig.w;
  rig.tools.relax.times = {};
  Row r;
  r.name = "update of a melting bust";
  r.particles = static_cast<double>(w.surface.particles.owned);
  r.surfels = static_cast<double>(w.surface.surfels.owned);
  RelaxationResult done;
  const SurfaceHalos halos = rig.ranks->halos();
  r.displaceMs = 1e3 * seconds([&] {
                   findDisplacementGradients(w.grid, w.surface, halos, rig.tools);
                   displaceSurfels(w.scene, w.surface, halos, rig.tools);
                 });
  const double place = seconds([&] {
    SurfaceParticles& p = w.surface.particles;
    for (std::size_t i = 0; i < p.owned; i++) p.position[i] += p.displacement[i];
    p.resize(p.owned, 0);
    rig.place();
  });
  r.readyMs = 1e3 * seconds([&] { prepareParticles(w.scene, w.surface, halos, rig.tools); });
  r.fieldsMs = 1e3 * seconds([&] { sampleFields(w.scene, w.surface, halos, rig.tools); });
  const double relax = seconds([&] {
    done = rig.relaxSurfels(w.scene.surface.iterations, false);
    blendSurfels(w.surface.surfels);
  });
  r.updateS = relax + place + 1e-3 * (r.displaceMs + r.readyMs + r.fieldsMs);
  r.targetS = 0.5;
  r.iterations = static_cast<double>(done.iterations);
  fillPhases(r, rig.tools.relax.times);
  r.searchMs = 1e3 * rig.tools.relax.times.search;
  r.placeMs = 1e3 * (place + rig.tools.relax.times.place);
  r.searches = static_cast<double>(rig.tools.relax.times.searches);
  return r;
}

/// Returns the fastest of `repeat` updates of a melting bust of 4,000 particles.
Row update(double surfels, int repeat) {
  const MeltingBust bust = meltingBust(4000);
  const Skin skin = skinOf(*bust.shape, surfels);
  Row best;
  for (int k = 0; k < repeat; k++) {
    RelaxRig rig(skin.spacing * 1.07, bust.height + 8);
    placeBust(rig, bust, skin);
    const Row r = updateOf(rig);
    if (k == 0 || r.updateS < best.updateS) best = r;
  }
  return best;
}

/// Row of wholeUpdates. `repeat` sets the number of updates.
Row whole(bool molten, double surfels, double support, const std::string& choice, int repeat) {
  const WholeUpdates u = wholeUpdates(molten, surfels, support, 2 + 2 * repeat);
  const auto ms = [&](SurfacePhase phase) { return 1e3 * u.phase[static_cast<std::size_t>(phase)]; };
  Row r;
  r.name = std::string("whole update of a ") + (molten ? "molten" : "solid") +
           " bust until the local stop with h_ss = " + choice;
  r.particles = u.particles;
  r.surfels = u.surfels;
  r.aroundSurfels = u.surfelNeighbours;
  r.updateS = u.seconds;
  r.targetS = 0.5;
  r.worstS = u.worst;
  r.startS = u.startSeconds;
  r.finished = u.finished;
  r.iterations = u.iterations;
  r.displaceMs = ms(SurfacePhase::Displacement);
  r.fieldsMs = ms(SurfacePhase::Fields);
  r.placeMs = ms(SurfacePhase::Place);
  r.componentsMs = ms(SurfacePhase::Components);
  r.growthMs = ms(SurfacePhase::Growth);
  r.resamplingMs = ms(SurfacePhase::Resampling);
  r.iterationsMs = ms(SurfacePhase::Iterations);
  r.measuresMs = ms(SurfacePhase::Measures);
  return r;
}

Row ball(int R, SmoothingForm form, double support = 3) {
  RelaxRig rig(0.5, R + 6, [&](Scene& s) { s.surface.smoothing = form, s.surface.support = support; });
  rig.addLattice(R + 1, {0.5, 0.5, 0.5}, [&](const Vec3d& x) { return length(x) < R; });
  rig.addBallSurfels(R, 0.1);
  rig.place();
  Row r;
  r.iterations = static_cast<double>(rig.relaxSurfels(60).iterations);
  r.name = std::string("ball of whole lattice cells R/dx ") + std::to_string(R) +
           (form == SmoothingForm::Plane ? " smoothing to planes" : "") +
           (support != 3 ? " h_ss " + std::to_string(support).substr(0, 3) + " d" : "");
  r.particles = static_cast<double>(rig.w.surface.particles.owned);
  r.surfels = static_cast<double>(rig.w.surface.surfels.owned);
  const test::BallErrors e = test::ballErrors(rig.w.surface.surfels, R);
  r.hausdorff = 100 * e.hausdorff;
  r.normalMean = e.normalMean;
  r.normalMax = e.normalMax;
  return r;
}

/// Prints the rows of a group in order. Returns false for an unknown group.
bool printGroup(FILE* out, const std::string& group, double surfels, int repeat) {
  if (group == "iterations") {
    print(out, iterations("iteration", surfels, repeat, [](Scene&, double) {}));
    print(out, iterations("iteration smoothing to planes", surfels, repeat,
                          [](Scene& s, double) { s.surface.smoothing = SmoothingForm::Plane; }));
    for (int support : {4, 6})
      print(out, iterations("iteration h_ss " + std::to_string(support) + " d", surfels, repeat,
                            [&](Scene& s, double) { s.surface.support = support; }));
    print(out, iterations("iteration h_ss = h (the paper)", surfels, 1,
                          [](Scene& s, double d) { s.surface.support = 2 / d; }));
  } else if (group == "update") {
    print(out, update(surfels, repeat));
  } else if (group == "solid" || group == "molten") {
    const bool molten = group == "molten";
    print(out, whole(molten, surfels, 3, "3 d", repeat));
    print(out, whole(molten, surfels, 2.5, "2.5 d", repeat));
    // the support radius of the particles is two spacings of 28.5 mm
    if (molten)
      print(out, whole(true, surfels, 8, "8 d (the paper has h = 10.4 d: surface.support = 10.4)", 1));
  } else if (group == "balls") {
    for (int R : {8, 16, 24}) print(out, ball(R, SmoothingForm::Sphere));
    for (const double support : {2.5, 4.0, 6.0}) print(out, ball(16, SmoothingForm::Sphere, support));
    print(out, ball(16, SmoothingForm::Plane));
  } else {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  double surfels = 60000;
  int repeat = 3;
  const char* csv = nullptr;
  std::vector<std::string> groups{"iterations", "update", "solid", "molten", "balls"};
  for (int a = 1; a < argc; a += 2) {
    const std::string key = argv[a];
    const bool help = key == "-h" || key == "--help";
    if (help || a + 1 == argc)
      return std::fprintf(help ? stdout : stderr,
                          "scripts/bench surface [--surfels 60000] [--repeat 3] [--only "
                          "iterations|update|solid|molten|balls] [--csv FILE]\n"),
             help ? 0 : 2;
    if (key == "--surfels") surfels = std::atof(argv[a + 1]);
    else if (key == "--repeat") repeat = std::atoi(argv[a + 1]);
    else if (key == "--only") groups = {argv[a + 1]};
    else if (key == "--csv") csv = argv[a + 1];
    else return std::fprintf(stderr, "unknown option %s\n", argv[a]), 2;
  }
  if (surfels < 100 || repeat < 1)
    return std::fprintf(stderr, "surface: --surfels must be at least 100, --repeat at least 1\n"), 2;
  FILE* out = csv ? std::fopen(csv, "w") : stdout;
  if (!out) return std::fprintf(stderr, "surface: cannot write %s\n", csv), 3;
  printHead(out);
  for (const std::string& group : groups)
    if (!printGroup(out, group, surfels, repeat))
      return std::fprintf(stderr,
                          "surface: unknown group %s; groups: iterations, update, solid, molten, balls\n",
                          group.c_str()),
             2;
  if (csv) std::fclose(out);
  return 0;
}
