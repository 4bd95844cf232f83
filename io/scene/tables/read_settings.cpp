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
  r.restart(Restart::Coefficient);
  r.choice("kernel", n.kernel, {"wendland", "mcg03", "cubic"},
           "wendland: Wendland C2. mcg03: poly6, spiky and viscosity kernels of Mueller et al. 2003. cubic: "
           "cubic spline");
  r.choice("precision", n.precision, {"single", "double"},
           "precision of sums over pairs; the state is double");
  readTermKeys(r, n);
  r.as(Restart::Start)
      .choice("overlap", n.overlap, {"error", "keep", "remove later", "remove earlier"},
              "treatment of the particles of two bodies that overlap. A sheet or an oriented body that "
              "begins inside a solid one is an error, except with \"keep\"");
  r.restart(Restart::Setting);
  r.number("fixed_step", n.fixedStep, "s", notNegative(),
           "constant time step, at most `end`, shortened to a whole number of steps per frame. Stability "
           "limits and `max_step` are then not applied. 0: the step follows the limits");
  r.number("max_step", n.maxStep, "s", orNever(positive()), "largest time step");
  r.number("cfl_acceleration", n.cflAcceleration, "", stepFactor(),
           "step limit as a multiple of sqrt(h / a), with the acceleration a; the incompressible solver "
           "takes 0.6 of it");
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
}

void readOutput(TableReader& r, Scene& s) {
  Output& o = s.output;
  const std::vector<std::string> known = outputFields(s);
  r.restart(Restart::Free);
  // A changed interval would give new frames the numbers of existing ones.
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
