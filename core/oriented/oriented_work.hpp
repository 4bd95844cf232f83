// What the step keeps for oriented bodies: made once from the scene, or found anew in every step. Nothing of
// it is part of the state.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/math/quat.hpp"
#include "core/oriented/given_surface.hpp"
#include "core/oriented/pair_potential.hpp"
#include "core/oriented/plan_contact.hpp"
#include "core/oriented/relax_progress.hpp"

namespace thaw {

/// Neighbours of each owned row in (cell, id) order, ghosts among them.
struct OrientedLists {
  std::vector<std::uint32_t> first, list;  ///< list[first[i]] .. list[first[i + 1]]
};

struct OrientedWork {
  std::vector<PairPotential> potentials;   ///< of each body
  std::vector<OrientedContact> contacts;   ///< of each body, with the continuum; empty where they do not meet
  std::vector<ObstacleContact> obstacles;  ///< of each body, with obstacles
  double atObstacles2 = 0;         ///< 1/s^2, the fastest of this rank's rows on the barrier of an obstacle
  std::vector<GivenPoints> given;  ///< of each body; empty without any
  /// of each body's fields; null: everywhere
  std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions;
  double time = 0;  ///< s, of the forces at hand
  double over = 0;  ///< s, length of the step that is under way, of which forces of fields are the means; 0:
                    ///< they are those at `time`
  OrientedLists lists;
  std::vector<Vec3d> place, move, spinMove;  // of integrators: by owned row
  std::vector<Quat> turn;
  std::vector<Vec3d> acting;  // N, by owned row: the mean force over the step as the integrator has taken it,
                              // without gravity and damping
  std::vector<Vec3d> actingTorque;  // N m, the same of torques
  std::vector<Vec3d> velocity, spin, sumForce, sumTorque, sumVelocity, sumSpin;
  std::vector<Vec3d> rest, restSpin, along, alongSpin, image, imageSpin;
  double fastest2 = 0;  ///< 1/s^2, of this rank's continuum particles at oriented ones, and of these at those
  double unrest = 0;    ///< largest force left by relaxation, over stiffness times spacing
  bool begins = false;  ///< the next evaluation is that of the start: it does the events of time 0
  std::int64_t relaxAtLeast = 0;  ///< iterations of relaxation at the start that a command asks of all bodies
  std::int64_t relaxed = 0;       ///< iterations of relaxation at the start
  std::int64_t relaxing = 0;      ///< particles in it, on all ranks
  RelaxProgress relaxProgress;    ///< what it has come to
  bool atRest = false, relaxStopped = false, gotNowhere = false;  ///< how it ended, if not by its last
                                                                  ///< iteration; on all ranks
  std::function<bool(std::int64_t done)> stopRelaxing;  ///< asked on each rank before each of its iterations;
                                                        ///< one yes ends it. Empty: never
  struct Born {
    std::uint32_t row;
    double energy;
  };                       // J, without contacts of kinds
  std::vector<Born> born;  ///< in this evaluation
  struct Event {
    std::size_t body, event;
  };
  std::vector<Event> idle;  ///< events that have met nothing, on all ranks; whoever tells of them clears it
  struct Field {
    std::size_t body, field;
  };
  std::vector<Field> idleFields;            ///< fields that no particle is in as they begin, as `idle`
  std::int64_t solves = 0, iterations = 0;  ///< of the implicit integrator
};

}  // namespace thaw
