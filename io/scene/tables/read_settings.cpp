// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "io/scene/tables/read_extension.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/nearest_word.hpp"

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
  const bool periodic = sides[0] == Side::Periodic;
  const toml::node* n = r.node(
      key, "", "\"open\", \"wall\", \"periodic\" or a pair [low, high]",
      "type of the two sides across this axis. open: particles that leave are recorded in the ledger. "
      "periodic: particles that leave enter at the opposite side. A body may lie across a periodic side, "
      "with its mesh and surface, if it does not overlap its own image. A sheet or an oriented body may not. "
      "A periodic axis is at least three support radii long: 6 spacings if `numerics.support` is 2",
      r.describing() ? "\"open\""
      : periodic     ? "periodic"
                     : "not periodic");
  if (r.recording() && !periodic)  // walls may change
    for (std::size_t end = 0; end < 2; end++)
      r.as(Restart::Coefficient)
          .node((key + std::string(end == 0 ? ".low" : ".high")).c_str(), "", "", "",
                sides[end] == Side::Wall ? "\"wall\"" : "\"open\"");
  if (!n) return;
  const toml::array* pair = n->as_array();
  const bool good = pair ? pair->size() == 2 && sideOf(pair->get(0), sides[0]) &&
                               sideOf(pair->get(1), sides[1])
                         : sideOf(n, sides[0]) && sideOf(n, sides[1]);
  if (!good)
    r.refuseValue(
        key, "expected \"open\", \"wall\" or \"periodic\", or a pair of them such as [\"wall\", \"open\"]");
  else if ((sides[0] == Side::Periodic) != (sides[1] == Side::Periodic))
    r.fail(key, "expected both sides of an axis to be periodic, or none");
}

Range factor() { return {0, 2, true, false, false}; }

}  // namespace

void readDomain(TableReader& r, Domain& d) {
  r.restart(Restart::State);
  r.vector("min", d.min, "m", "low corner");
  r.vector("max", d.max, "m", "high corner, above the low one");
  r.table(
      "sides",
      "types of the domain's sides, open by default. Bodies and obstacles may lie across periodic sides: the "
      "part beyond acts at the opposite side. At a restart, only a change to or from periodic is refused",
      [&](TableReader& s) {
        readSides(s, "x", d.side[0]);
        readSides(s, "y", d.side[1]);
        readSides(s, "z", d.side[2]);
      });
  readTermKeys(r, d);
  std::string axes;
  for (int a = 0; a < 3; a++)
    if (!(d.max[a] > d.min[a])) axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[a]);
  if (!axes.empty() && r.has("max")) r.fail("max", "must exceed `domain.min` along " + axes, {"min"});
  else if (!axes.empty()) r.fail("min", "must be below `domain.max` along " + axes);
}

void readNumerics(TableReader& r, Numerics& n) {
  r.restart(Restart::State);
  r.number("support", n.support, "", between(1.2, 6), "support radius of the kernel in spacings");
  r.number("bond_support", n.bondSupport, "", between(1.2, 6),
           "longest bond of solids in spacings, at most `support`; longer bonds soften thin bodies, shorter "
           "ones need shorter steps in irregular arrangements");
  r.restart(Restart::Coefficient);
  r.choice("kernel", n.kernel, {"wendland", "mcg03", "cubic"},
           "wendland: Wendland C2. mcg03: poly6, spiky and viscosity kernels of Mueller et al. 2003. cubic: "
           "cubic spline");
  r.choice("precision", n.precision, {"single", "double"},
           "precision of sums over pairs; the state is double");
  r.choice("elastic_precision", n.elasticPrecision, {"single", "double"},
           "precision of sums over bonds of solids; single is accurate to 1e-6 of the strain");
  r.choice("pressure", n.pressure, {"consistent", "printed"},
           "consistent: pair form that conserves energy. printed: as printed in Keiser et al. 2005, which "
           "gives half the gradient");
  r.byScene().choice(
      "density", n.density, {"summation", "continuity", "plain"},
      "density of liquids. summation: a sum over positions, consistent with compression. "
      "continuity: integrated from the divergence of the flow. plain: the plain sum. Default: "
      "\"continuity\"; \"summation\" with a form of `tension` other than \"curvature\", `quality = "
      "\"preview\"`, `pressure = \"printed\"` or the incompressible solver");
  r.flag(
      "corrected_gradients", n.correctedGradients,
      "gradients of the continuity form and of the incompressible solver are exact for linear fields inside "
      "the liquid (Bonet & Lok 1999)");
  r.number("density_diffusion", n.densityDiffusion, "", between(0, 1),
           "density diffusion of the continuity form");
  r.byScene().number(
      "shifting", n.shifting, "", between(0, 0.3),
      "largest speed of shifting: particles of a liquid move down the gradient of their concentration C. It "
      "is a multiple of the speed of sound times h grad C. With the continuity form it scales with strain "
      "and tension, and particles at the free surface are not shifted. 0: no shifting. Default with density "
      "= \"continuity\": 0.07 with gravity, 0.2 without");
  r.choice("equation_of_state", n.eos, {"linear", "tait"}, "pressure as a function of the density");
  r.byScene().number("tensile_limit", n.tensileLimit, "", between(0, 1),
                     "fraction of negative pressure that is kept. Above 0 it requires `density = "
                     "\"continuity\"` and shifting "
                     "above 0. Default: 1 with both, except with a form of `tension` other than "
                     "\"curvature\", or `quality = \"preview\"`");
  r.choice("pressure_solver", n.solver, {"state equation", "incompressible"},
           "state equation: pressure from the density. incompressible: solved for, so that liquids keep "
           "their volume; the speed of the flow limits the step, not that of sound");
  r.restart(Restart::Setting);
  r.number("density_tolerance", n.densityTolerance, "", {0, 0.1, true, false, false},
           "incompressible: the solver stops when the mean remaining compression of a step is below this. "
           "Earlier compression is removed in the time in which the flow moves by one spacing");
  r.number("divergence_tolerance", n.divergenceTolerance, "", {0, 0.1, true, false, false},
           "incompressible: mean rate of compression, times the step, below which the solver stops");
  r.whole("max_iterations", n.maxIterations, 1, 100000,
          "incompressible: largest number of iterations per solve; the summary counts solves that reach it");
  r.restart(Restart::Coefficient);
  r.choice("viscosity", n.viscosity, {"pairwise", "laplacian"},
           "pairwise: along the line between two particles, which conserves angular momentum. laplacian: as "
           "printed in Keiser et al. 2005");
  r.byScene().flag(
      "viscosity_correction", n.viscosityCorrection,
      "corrects pairwise viscosity for particle disorder, which changes it by a few per cent while layers "
      "slide past each other. Default: true where viscosity limits explicit steps more than sound does, "
      "except with quality = \"preview\"");
  r.choice("viscosity_solver", n.viscositySolver, {"explicit", "implicit"},
           "explicit: viscosity limits the step. implicit: a linear system in each step, without this limit; "
           "recommended if viscosity limits the step");
  r.restart(Restart::Setting);
  r.number("viscosity_tolerance", n.viscosityTolerance, "", between(1e-10, 0.1),
           "implicit solver: relative error of a step's velocity change by viscosity");
  r.whole("viscosity_iterations", n.viscosityIterations, 1, 100000,
          "implicit solver: largest number of iterations per step; the summary counts steps that need more");
  if (n.viscositySolver == ViscositySolver::Implicit && n.viscosity == ViscosityForm::Laplacian)
    r.fail("viscosity_solver",
           "the implicit solver supports the pairwise form of viscosity only: leave `numerics.viscosity` at "
           "\"pairwise\"");
  if (n.viscosityCorrection && n.viscosity == ViscosityForm::Laplacian)
    r.fail(
        "viscosity_correction",
        "only the pairwise form of viscosity can be corrected: leave `numerics.viscosity` at \"pairwise\"");
  r.restart(Restart::Coefficient);
  r.as(Restart::State)
      .choice("buoyancy", n.buoyancy, {"automatic", "boussinesq", "density"},
              "buoyancy of liquids with expansion or a table of densities. boussinesq: only density "
              "differences have weight, so noise of the hydrostatic pressure does not hide them. It is for "
              "closed containers full of one liquid: a free surface would be weightless. density: the whole "
              "weight acts. automatic: boussinesq where liquid of one density fills a closed domain, "
              "else density");
  r.byScene().choice(
      "tension", n.tension, {"pairwise", "colour field", "surface energy", "curvature"},
      "pairwise: cohesion of pairs, cheap, but drops behave like soft crystals. colour field: as printed in "
      "Keiser et al. 2005. surface energy: drops have Laplace's pressure and oscillate like liquids. Energy "
      "and momentum are conserved, but surfaces at rest resist flow. curvature: a force by the curvature of "
      "the free surface, for contact angles and flow along surfaces. It needs `density = \"continuity\"` "
      "and shifting. Default: \"curvature\"; \"surface energy\" without these two, with a support below "
      "1.9, `quality = \"preview\"`, `pressure = \"printed\"` or the incompressible solver");
  r.as(Restart::State)
      .choice("heat", n.heat, {"enthalpy", "paper"},
              "enthalpy: with latent heat. paper: the plain temperature of Keiser et al. 2005");
  r.choice("conduction", n.conduction, {"normalised", "plain"},
           "sum for heat conduction. normalised: exact for a quadratic temperature on the lattice. plain: "
           "with the kernel's own constant");
  r.flag("self_contact", n.selfContact, "pieces of one body collide with each other");
  r.number("max_density_error", n.maxDensityError, "", {0, 0.2, true, false, false},
           "compression that the automatic sound speed allows");
  r.as(Restart::Start)
      .choice("overlap", n.overlap, {"error", "keep", "remove later", "remove earlier"},
              "treatment of the particles of two bodies that overlap. A sheet or an oriented body that "
              "begins inside a solid one is an error, except with \"keep\"");
  r.restart(Restart::Setting);
  r.number("fixed_step", n.fixedStep, "s", notNegative(),
           "constant time step, at most `end`, shortened to a whole number of steps per frame. Stability "
           "limits and `max_step` are then not applied. 0: the step follows the limits");
  r.number("max_step", n.maxStep, "s", orNever(positive()), "largest time step");
  r.number("cfl_sound", n.cflSound, "", factor(),
           "step limit as a multiple of h / c, with the support radius h");
  r.number("cfl_viscous", n.cflViscous, "", factor(),
           "step limit as a multiple of the largest stable dt on a lattice: 0.044 h^2 rho / mu for the "
           "pairwise form with support = 2. Clumped particles need shorter steps");
  r.number("cfl_heat", n.cflHeat, "", factor(),
           "step limit as a multiple of the largest stable dt on a lattice: 0.078 h^2 / diffusivity for the "
           "wendland kernel with support = 2");
  r.number("cfl_elastic", n.cflElastic, "", factor(),
           "step limit as a multiple of spacing / speed of pressure waves");
  r.number("cfl_tension", n.cflTension, "", factor(),
           "step limit as a multiple of sqrt(rho h^3 / (2 pi sigma))");
  r.number("cfl_acceleration", n.cflAcceleration, "", factor(),
           "step limit as a multiple of sqrt(h / a), with the acceleration a; the incompressible solver "
           "takes 0.6 of it");
  std::int64_t substeps = n.elasticSubsteps;
  r.whole(
      "elastic_substeps", substeps, 0, 64,
      "largest number of substeps of solids within a step, if their elastic limit is the shortest. 0: 4 with "
      "liquid (2 if it is incompressible) and without contact of solids, else 1. With at most one solid "
      "body, contacts of frozen pieces limit the step only while pieces touch or are about to. With more "
      "than 8 the liquid may pump energy into solids without damping. With incompressible liquid, or with "
      "liquid in a scene of melting solids, the step is at most that of a `cfl_elastic` of 0.8");
  n.elasticSubsteps = static_cast<int>(substeps);
  r.number("sleep_speed", n.sleepSpeed, "m/s", notNegative(),
           "solids that are slower than this for `sleep_after`, like all their neighbours, sleep: they stay "
           "in place at little cost until a load, heat or a neighbour wakes them. Progress lines show how "
           "many sleep and what keeps the others awake. 0: never. Not available with sheets, oriented "
           "bodies, `elastic_substeps`, an incompressible or an implicit solver");
  r.number("sleep_after", n.sleepAfter, "s", positive(),
           "time at rest before a solid sleeps, or before a part of it becomes rigid (rigidify). An "
           "acceleration that reaches `sleep_speed` within this time, or half of gravity, keeps a solid "
           "awake or wakes it. With a shorter time, a solid with weak vibrations sleeps sooner");
  r.number("sleep_heating", n.sleepHeating, "K/s", positive(),
           "rate of change of the temperature that keeps a solid awake or wakes it");
  r.number("rigidify", n.rigidify, "1/s", orOff(notNegative()),
           "parts of elastic solids whose rate of strain stays below this for the time `sleep_after` move as "
           "rigid pieces. They become elastic when they deform, soften, or come near an obstacle or another "
           "body. Their elastic forces are not computed. While all solids are rigid, the elastic limit of "
           "the step does not apply. The value must be below the rates of vibrations that matter, such as "
           "0.1 for stiff bodies. Not available with rigid, yielding or breaking materials, extension laws, "
           "`sleep_speed` or `elastic_substeps`. 0 or \"off\": none");
  r.restart(Restart::Free);
  r.whole("retry_every", n.retryEvery, 0, 1000000000,
          "steps between snapshots in memory. A run that fails goes back to the last one and continues with "
          "half the step. 0: no snapshots, and a failure stops the run");
  r.whole("retries", n.retries, 0, 40,
          "largest number of active retries, each with half the step of the one before. The next failure "
          "stops the run with exit code 4 and the last snapshot as a checkpoint. A retry is active until the "
          "step has doubled again, `retry_every` full steps after the failure at the earliest");
  r.number("watch_speed", n.watchSpeed, "", orNever(positive()),
           "speed above which a step has failed, as a multiple of the expected speed plus 0.1 of the largest "
           "wave speed. The expected speed follows from start, gravity, emitters and obstacles");
  r.number("watch_density", n.watchDensity, "", orNever(positive()),
           "density of a liquid above which a step has failed, as a multiple of the rest density");
  r.number("watch_step", n.watchStep, "", {0, 1, true, false, false},
           "time step below which a run has failed, as a fraction of the materials' limit (without one: of "
           "1e-5 `end`). No retry takes a shorter step. 0: none");
  r.number("watch_inverted", n.watchInverted, "", orNever(positive()),
           "fraction of inverted solid particles (det F <= 0) above which a step has failed. It concerns "
           "materials that do not recover from inversion: law \"green\" without `volume_stiffness`");
  r.number("watch_energy", n.watchEnergy, "", orNever(positive()),
           "unexplained gain of mechanical energy above which a step has failed, as a multiple of the "
           "largest term of the ledger. It is the gain within `retry_every` steps or since the start");
  r.as(Restart::Setting)
      .number("plastic_rereference", n.plasticRereference, "", positive(),
              "norm of the plastic strain above which the reference follows the flow");
}

void readOutput(TableReader& r, Scene& s) {
  Output& o = s.output;
  const std::vector<std::string> known = outputFields(s);
  r.restart(Restart::Free);
  // Otherwise new frames would have the numbers of existing ones.
  r.as(Restart::State).number("every", o.every, "s", positive(), "simulated time between frames");
  r.number("ledger_every", o.ledgerEvery, "s", notNegative(),
           "simulated time between additional rows of ledger.csv, which has one per frame. A row is written "
           "at the first step at or after its time and changes no step. 0: none");
  r.words("fields", o.fields, known,
          "fields of the frames of bodies and emitters; frames of oriented bodies and sheets have all their "
          "fields. The six numbers of stress (Cauchy's), strain (Green's) and plastic_strain are xx, yy, zz, "
          "xy, yz, xz; off-diagonal components are listed once, not doubled. surface_velocity adds the "
          "velocity of surfels to the frames of a surface");
  if (r.has("fields")) o.fieldsWhere = r.placeOf("fields");
  r.number("checkpoint", o.checkpoint, "s", positive(),
           "wall-clock time between checkpoints; the last two are kept");
  int pieces = o.piecesByRank ? 1 : 0;
  r.choice("pieces", pieces, {"one", "ranks"},
           "pieces of a frame's file: one, or one per rank (for parallel ParaView)");
  o.piecesByRank = pieces == 1;
  r.text("colour", o.colour,
         "source of the colours of pictures; none: temperature; in scenes without heat, speed; in scenes of "
         "sheets alone, their own colours",
         "\"speed\" or a field; for a surface also \"surface\" (its own colours) or \"glow\" (own colours "
         "that blend into those of the temperature)");
  std::set<std::string> words(known.begin(), known.end());
  words.insert({"speed", "surface", "glow", "detail"});
  if (!o.colour.empty() && !words.count(o.colour))
    r.refuseValue("colour", "unknown field '" + o.colour + "'" + suggestion(o.colour, words));
  r.number("colour_min", o.colourMin, "", anyNumber(),
           "SI value of the lowest colour; none: the lowest of all frames");
  r.number("colour_max", o.colourMax, "", anyNumber(),
           "SI value of the highest colour; none: the highest of all frames");
  if (o.colourMin && o.colourMax && !(*o.colourMax > *o.colourMin))
    r.fail("colour_max", "must be above `colour_min`", {"colour_min"});
  readPicture(r, o);
}

}  // namespace thaw
