// SPDX-License-Identifier: Apache-2.0
// Work data of oriented bodies, made once from the scene or rebuilt in each step. It is not part of the
// state.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/quat.hpp"
#include "core/oriented/data/relax_progress.hpp"
#include "core/oriented/interpolation/interpolant.hpp"
#include "core/oriented/laws/pair_potential.hpp"
#include "core/oriented/laws/plan_contact.hpp"

namespace thaw {

/// Neighbours of each owned row in (cell, id) order, ghosts included.
struct OrientedLists {
  std::vector<std::uint32_t> first, list;  ///< list[first[i]] .. list[first[i + 1]]
};

struct OrientedWork {
  std::vector<PairPotential> potentials;   ///< one per body
  std::vector<OrientedContact> contacts;   ///< one per body, with the continuum; empty without contact
  std::vector<ObstacleContact> obstacles;  ///< one per body, with obstacles
  double obstacleFrequency2 = 0;        ///< 1/s^2, largest squared frequency of this rank's rows at obstacle
                                        ///< barriers
  std::vector<PointInterpolant> given;  ///< one per body; empty for others
  /// per body and field; null: everywhere
  std::vector<std::vector<std::shared_ptr<const SignedDistance>>> fieldRegions;
  double time = 0;  ///< s, time of the current forces
  double over = 0;  ///< s, step length over which field forces are averaged; 0: field forces are those at
                    ///< `time`
  OrientedLists lists;
  std::vector<Vec3d> place, move, spinMove;  // buffers of integrators, by owned row
  std::vector<Quat> turn;
  // N, by owned row: mean force over the step as the integrator used it, without gravity and damping
  std::vector<Vec3d> acting;
  std::vector<Vec3d> actingTorque;  // N m, mean torque in the same way
  std::vector<Vec3d> velocity, spin, sumForce, sumTorque, sumVelocity, sumSpin;
  std::vector<Vec3d> rest, restSpin, along, alongSpin, image, imageSpin;
  double fastest2 = 0;  ///< 1/s^2, largest squared frequency of contacts between this rank's oriented and
                        ///< continuum particles
  double residualForce = 0;       ///< 1, largest remaining force after relaxation, over stiffness times
                                  ///< spacing
  bool begins = false;            ///< the next evaluation is the first: it applies the events of time 0
  std::int64_t relaxAtLeast = 0;  ///< minimum number of relaxation iterations at the start for all bodies,
                                  ///< set by a command
  std::int64_t relaxed = 0;       ///< iterations of relaxation at the start
  std::int64_t relaxing = 0;      ///< particles in relaxation, on all ranks
  RelaxProgress relaxProgress;    ///< convergence of the relaxation
  bool atRest = false, relaxStopped = false, relaxStalled = false;  ///< reason why relaxation ended before
                                                                    ///< the last iteration; the same on all
                                                                    ///< ranks
  std::function<bool(std::int64_t done)> stopRelaxing;  ///< called on each rank before each iteration; true
                                                        ///< on any rank ends relaxation. Empty: never ends
                                                        ///< early
  struct Born {
    std::uint32_t row;
    double energy;
  };                       // J, without contacts of other body types
  std::vector<Born> born;  ///< particles created in this evaluation
  struct Event {
    std::size_t body, event;
  };
  std::vector<Event> idle;  ///< events that affected no particle on any rank; cleared when reported
  struct Field {
    std::size_t body, field;
  };
  std::vector<Field> unusedFields;  ///< fields without a particle at their start; cleared when reported
  std::int64_t solves = 0, iterations = 0;  ///< statistics of the implicit integrator
};

}  // namespace thaw
