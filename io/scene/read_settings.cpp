#include <fmt/format.h>

#include "io/output/frame_fields.hpp"
#include "io/scene/nearest_word.hpp"
#include "io/scene/read_sections.hpp"

namespace thaw {
namespace {

bool sideOf(const toml::node* n, Side& side) {
  const auto* word = n ? n->as_string() : nullptr;
  if (!word) return false;
  if (word->get() == "open") side = Side::Open;
  else if (word->get() == "wall") side = Side::Wall;
  else if (word->get() == "periodic") side = Side::Periodic;
  else return false;
  return true;
}

void readSides(TableReader& r, const char* key, std::array<Side, 2>& sides) {
  const toml::node* n = r.node(
      key, "", "\"open\", \"wall\", \"periodic\" or a pair [low, high]",
      "what the two sides across this axis are; open: what leaves is recorded in the ledger; periodic: what "
      "leaves comes in at the other side, at the start, too: a body may be placed across it, with its mesh "
      "and surface, if it does not overlap its own image (a sheet or an oriented body may not). A periodic "
      "axis is at least three support radii long: a thin slab has 6 spacings where `numerics.support` is 2");
  if (r.describing() || !n) return;
  const toml::array* pair = n->as_array();
  const bool good = pair ? pair->size() == 2 && sideOf(pair->get(0), sides[0]) &&
                               sideOf(pair->get(1), sides[1])
                         : sideOf(n, sides[0]) && sideOf(n, sides[1]);
  if (!good)
    r.fail(key,
           "expected \"open\", \"wall\" or \"periodic\", or a pair of them such as [\"wall\", \"open\"]");
  else if ((sides[0] == Side::Periodic) != (sides[1] == Side::Periodic))
    r.fail(key, "both sides of an axis are periodic, or none");
}

Range factor() { return {0, 2, true, false, false}; }

}  // namespace

void readDomain(TableReader& r, Domain& d) {
  r.vector("min", d.min, "m", "low corner");
  r.vector("max", d.max, "m", "high corner, above the low one");
  r.table("sides",
          "what the domain's sides are; open where nothing is said. Bodies and obstacles may lie across "
          "periodic sides: what is beyond acts on the other side",
          [&](TableReader& s) {
            readSides(s, "x", d.side[0]);
            readSides(s, "y", d.side[1]);
            readSides(s, "z", d.side[2]);
          });
  r.vector("gravity", d.gravity, "m/s^2", "acceleration of everything");
  r.number("ambient", d.ambient, "K", positive(), "temperature around, for convection and radiation");
  for (int a = 0; a < 3; a++)
    if (!(d.max[a] > d.min[a]))
      r.fail(r.has("max") ? "max" : "min",
             fmt::format("max must be above min along {}", static_cast<char>('x' + a)), {"min", "max"});
}

void readNumerics(TableReader& r, Numerics& n) {
  r.number("support", n.support, "", between(1.2, 6), "support radius of the kernel in spacings");
  r.number("bond_support", n.bondSupport, "", between(1.2, 6),
           "longest bond of solids in spacings, at most `support`; longer ones make thin bodies softer, "
           "shorter ones make uneven lumps need shorter steps");
  r.choice("kernel", n.kernel, {"wendland", "mcg03", "cubic"},
           "Wendland C2; poly6, spiky and viscosity kernel of Mueller et al. 2003; cubic spline");
  r.choice("precision", n.precision, {"single", "double"}, "of sums over pairs; the state is double");
  r.choice("elastic_precision", n.elasticPrecision, {"single", "double"},
           "of sums over bonds of solids; single is accurate to 1e-6 of the strain");
  r.choice("pressure", n.pressure, {"consistent", "printed"},
           "consistent pair form, or the sum as printed in Keiser et al. 2005 (half the gradient)");
  r.choice("density", n.density, {"summation", "continuity", "plain"},
           "of liquids: summed over positions and consistent with compression; integrated from the "
           "divergence of the flow; or the plain sum. Default: \"continuity\", except with surface tension, "
           "quality = \"preview\", pressure = \"printed\" or the incompressible solver");
  r.flag("corrected_gradients", n.correctedGradients,
         "of the continuity form: exact for linear fields inside the liquid (Bonet & Lok 1999)");
  r.number("density_diffusion", n.densityDiffusion, "", between(0, 1),
           "of the continuity form: evens out the density of neighbours");
  r.number("shifting", n.shifting, "", between(0, 0.3),
           "largest speed at which particles of a liquid are shifted from crowded to empty places, over the "
           "speed of sound times h grad C; with the continuity form it follows strain and tension, and "
           "particles at the free surface stay. 0: no shifting. Default with density = \"continuity\": 0.07 "
           "with gravity, 0.2 without");
  r.choice("equation_of_state", n.eos, {"linear", "tait"}, "pressure by density");
  r.number("tensile_limit", n.tensileLimit, "", between(0, 1),
           "share of negative pressure that is kept; requires density = \"continuity\" and shifting above 0, "
           "and is then 1 by default");
  r.choice("pressure_solver", n.solver, {"state equation", "incompressible"},
           "pressure by density, or found so that liquids keep their volume (steps are limited by speed, not "
           "by sound)");
  r.number("density_tolerance", n.densityTolerance, "", {0, 0.1, true, false, false},
           "incompressible: the solver stops where the mean of what is left of a step's compression is below "
           "it; what was there before is undone over the time of a spacing");
  r.number("divergence_tolerance", n.divergenceTolerance, "", {0, 0.1, true, false, false},
           "incompressible: mean rate of compression, times the step, at which it stops");
  r.whole("max_iterations", n.maxIterations, 1, 100000,
          "incompressible: most iterations of a solve; solves that end there are counted in the summary");
  r.choice("viscosity", n.viscosity, {"pairwise", "laplacian"},
           "along the line of two particles (keeps angular momentum), or as printed in Keiser et al. 2005");
  r.choice("viscosity_solver", n.viscositySolver, {"explicit", "implicit"},
           "explicit: steps as short as viscosity needs; implicit: a linear system in each step, of any "
           "length (pays where viscosity sets the step)");
  r.number(
      "viscosity_tolerance", n.viscosityTolerance, "", between(1e-10, 0.1),
      "of the implicit solver: error of the change of velocity by viscosity in a step, over that change");
  r.whole("viscosity_iterations", n.viscosityIterations, 1, 100000,
          "of the implicit solver, at most in a step; steps that need more are counted");
  if (n.viscositySolver == ViscositySolver::Implicit && n.viscosity == ViscosityForm::Laplacian)
    r.fail("viscosity_solver",
           "the implicit solver knows the pairwise form of viscosity only: leave numerics.viscosity at "
           "\"pairwise\"");
  r.choice("tension", n.tension, {"pairwise", "colour field", "surface energy"},
           "cohesion of pairs: cheap, but drops are soft crystals; as printed in Keiser et al. 2005; or an "
           "energy of the free surface: drops have Laplace's pressure and swing as liquids do");
  r.choice("heat", n.heat, {"enthalpy", "paper"},
           "enthalpy with latent heat, or the plain temperature of Keiser et al. 2005");
  r.choice("conduction", n.conduction, {"normalised", "plain"},
           "the sum for heat conduction: exact for a quadratic temperature on the lattice, or with the "
           "kernel's own constant");
  r.flag("self_contact", n.selfContact, "pieces of one body collide with each other");
  r.number("max_density_error", n.maxDensityError, "", {0, 0.2, true, false, false},
           "compression that the automatic sound speed allows");
  r.choice("overlap", n.overlap, {"error", "keep", "remove later", "remove earlier"},
           "what happens to particles of two bodies that overlap; a sheet or an oriented body that begins "
           "inside a solid one is an error but with \"keep\"");
  r.number("fixed_step", n.fixedStep, "s", notNegative(),
           "longest time step, at most `end`, cut so that a whole number leads to each frame; 0: as large as "
           "the limits allow");
  r.number("max_step", n.maxStep, "s", orNever(positive()), "largest time step");
  r.number("cfl_sound", n.cflSound, "", factor(), "times h / c, h the support radius");
  r.number("cfl_viscous", n.cflViscous, "", factor(),
           "times the largest dt that is stable on a lattice: .044 h^2 rho / mu for the pairwise form at a "
           "support of 2 (a clump stiffens it)");
  r.number("cfl_heat", n.cflHeat, "", factor(),
           "times the largest dt that is stable on a lattice: .078 h^2 / diffusivity for the wendland kernel "
           "at a support of 2");
  r.number("cfl_elastic", n.cflElastic, "", factor(), "times spacing / speed of pressure waves");
  r.number("cfl_tension", n.cflTension, "", factor(), "times sqrt(rho h^3 / (2 pi sigma))");
  r.number("cfl_acceleration", n.cflAcceleration, "", factor(), "times sqrt(h / a)");
  std::int64_t substeps = n.elasticSubsteps;
  r.whole("elastic_substeps", substeps, 0, 64,
          "largest number of steps that solids take within one of all else, where their elastic limit is the "
          "shortest; 0: 4 where there is liquid and solids cannot meet, else 1. Above 8 the liquid may pump "
          "energy into solids without damping");
  n.elasticSubsteps = static_cast<int>(substeps);
  r.number("sleep_speed", n.sleepSpeed, "m/s", notNegative(),
           "solids slower than that for sleep_after, with all that is around them, are held where they are "
           "until something wakes them, and cost little; lines of progress say how many do, and what keeps "
           "the others awake; 0: never. Not with sheets, oriented bodies, elastic_substeps, an "
           "incompressible or an implicit solver");
  r.number("sleep_after", n.sleepAfter, "s", positive(),
           "rest until a solid sleeps; what would make it reach sleep_speed within that time, or half of "
           "gravity, keeps it awake, or wakes it: what still rings, however little, sleeps sooner with less");
  r.number("sleep_heating", n.sleepHeating, "K/s", positive(),
           "change of temperature that keeps a solid awake, or wakes it");
  r.whole("retry_every", n.retryEvery, 0, 1000000000,
          "steps between the states kept in memory, to which a run that fails goes back and goes on with "
          "half the step; 0: none, and the run stops");
  r.whole("retries", n.retries, 0, 40,
          "largest number of retries, each with half the step of the one before; the next failure stops the "
          "run with exit code 4 and the last good state as a checkpoint. It stops counting when the step "
          "doubles, at least retry_every full steps past the failure");
  r.number("watch_speed", n.watchSpeed, "", orNever(positive()),
           "speed that counts as failure, times what start, gravity, emitters and obstacles make and a tenth "
           "of the speed of waves");
  r.number("watch_density", n.watchDensity, "", orNever(positive()),
           "density of a liquid, over that at rest, that counts as failure");
  r.number("watch_step", n.watchStep, "", {0, 1, true, false, false},
           "time step that counts as failure, times the limit of the materials (without one: times 1e-5 "
           "`end`); no retry takes a shorter step; 0: none");
  r.number("watch_inverted", n.watchInverted, "", orNever(positive()),
           "share of the solid particles inside out (det F <= 0) that counts as failure, of materials that "
           "do not recover from it: law \"green\" without volume_stiffness");
  r.number("watch_energy", n.watchEnergy, "", orNever(positive()),
           "energy from nowhere that counts as failure, times the largest term of the ledger, within "
           "retry_every steps or since the run began");
  r.number("plastic_rereference", n.plasticRereference, "", positive(),
           "norm of the plastic strain above which the reference follows the flow");
}

void readOutput(TableReader& r, Output& o) {
  const std::vector<std::string> known = knownFrameFields();
  r.number("every", o.every, "s", positive(), "simulated time between frames");
  r.number("ledger_every", o.ledgerEvery, "s", notNegative(),
           "simulated time between further rows of ledger.csv, which has one for each frame: each is of the "
           "first step at or after its time, and changes no step; 0: none");
  r.words("fields", o.fields, known,
          "fields of the frames of bodies and emitters; those of oriented bodies and sheets have all theirs. "
          "The six numbers of stress (Cauchy's), "
          "strain (Green's) and plastic_strain are xx, yy, zz, xy, yz, xz, each off-diagonal one once and "
          "not doubled");
  if (r.has("fields")) o.fieldsWhere = r.placeOf("fields");
  r.number("checkpoint", o.checkpoint, "s", positive(),
           "wall-clock time between checkpoints; the last two are kept");
  int pieces = o.piecesByRank ? 1 : 0;
  r.choice("pieces", pieces, {"one", "ranks"},
           "parts of a frame's file: one, or one for each rank (for parallel ParaView)");
  o.piecesByRank = pieces == 1;
  r.text("colour", o.colour,
         "what colours the pictures; none: temperature; where there is no heat speed, and of sheets alone "
         "their own colours",
         "\"speed\" or a field; of a surface also \"surface\" (its own colours) or \"glow\" (those turning "
         "into the temperature's)");
  std::set<std::string> words(known.begin(), known.end());
  words.insert({"speed", "surface", "glow", "detail"});
  if (!o.colour.empty() && !words.count(o.colour))
    r.fail("colour", "there is no field '" + o.colour + "'" + suggestion(o.colour, words));
  r.number("colour_min", o.colourMin, "", anyNumber(),
           "SI value of the lowest colour; none: the lowest of all frames");
  r.number("colour_max", o.colourMax, "", anyNumber(),
           "SI value of the highest colour; none: the highest of all frames");
  if (o.colourMin && o.colourMax && !(*o.colourMax > *o.colourMin))
    r.fail("colour_max", "must be above colour_min", {"colour_min"});
  std::int64_t width = o.width, height = o.height;
  r.whole("width", width, 64, 16384, "of pictures, in pixels");
  r.whole("height", height, 64, 16384, "of pictures, in pixels");
  o.width = static_cast<int>(width);
  o.height = static_cast<int>(height);
  r.table("camera", "where pictures are taken from; without it the view is fitted to all frames",
          [&](TableReader& c) {
            if (!c.describing()) o.camera.fitted = false;
            c.vector("from", o.camera.from, "m", "place of the camera");
            c.vector("at", o.camera.at, "m", "place that it looks at");
            c.number("field_of_view", o.camera.fieldOfView, "rad", between(0.01, 3), "vertical angle");
            if (c.describing()) return;
            if (!c.has("from") || !c.has("at")) c.fail(c.place(), c.path() + ": needs from and at");
            else if (o.camera.from == o.camera.at) c.fail("at", "must be another place than from");
          });
}

}  // namespace thaw
