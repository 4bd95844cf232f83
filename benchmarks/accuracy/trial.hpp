// SPDX-License-Identifier: Apache-2.0
// One run of an accuracy case: a scene, stepped as in `thaw run`, and its figures.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/ledger/report.hpp"
#include "core/surface/update_surface.hpp"
#include "parallel/mpi_simulation.hpp"
#include "parallel/row_scatter.hpp"

namespace thaw::accuracy {

/// An error norm and its target (`never`: none).
struct Figure {
  std::string norm;
  double error;
  double target = never;
};

/// Values at one time, for cases with time series.
struct Sample {
  double time;
  std::vector<double> value;
};

struct Trial : MpiSimulation {
  explicit Trial(const Communicator& c) : MpiSimulation(c), comm(c) {}
  double spacing() const { return world.scene.spacing; }

  const Communicator& comm;
  std::unique_ptr<SurfaceRanks> surface;  ///< null without a surface
  SurfaceTools surfaceTools;
  std::vector<Sample> series;           ///< values recorded by `watch`
  std::map<std::string, double> notes;  ///< values passed between hooks
  std::vector<std::string> overrides;   ///< `overrides` of `run`
  std::vector<std::uint64_t> ids;       ///< ids of the particles or surfels in `series`
  double coreSeconds = 0;               ///< processor time (s) of the steps and the surface, all ranks
  double updateSeconds = 0;             ///< processor time (s) of surface updates
  bool finite = true;                   ///< false: the run blew up
};

/// A case. Its scene is scenes/<name>.toml unless `scene` names another. Hooks may be empty; all are
/// collective.
struct Case {
  const char* name;
  const char* about;                       ///< one line: setup, reference and source
  const char* scene = nullptr;             ///< file in scenes/
  std::function<void(Trial&)> place = {};  ///< moves particles before bonds are made (jitter)
  std::function<void(Trial&)> start = {};  ///< velocities, displacements, temperatures at time 0;
                                           ///< initializeForces follows
  std::function<void(Trial&)> watch = {};  ///< called after every step
  std::function<std::vector<Figure>(Trial&)> measure;
  std::function<void(Scene&)> adapt = {};  ///< changes the scene after it is read, for values that follow the
                                           ///< spacing
};

/// All cases. Each part of the method has its own file; cases.cpp joins them.
std::vector<Case> allCases();
std::vector<Case> flowCases();       ///< pressure: columns, dam breaks, vortices
std::vector<Case> stretchedCases();  ///< liquids without walls, deformed by their own flow
std::vector<Case> viscousCases();    ///< viscosity and surface tension
std::vector<Case> yieldCases();      ///< flow laws
std::vector<Case> tensionCases();    ///< contact angles, thermocapillary flow
std::vector<Case> solidCases();
std::vector<Case> heatCases();
std::vector<Case> sourceCases();  ///< lasers that move
std::vector<Case> convectionCases();
std::vector<Case> meltingCases();   ///< melting that flow governs
std::vector<Case> mixedCases();     ///< liquids and solids in one scene
std::vector<Case> floatingCases();  ///< solids that float, sink and rise in water
std::vector<Case> tankCases();      ///< tanks that are no multiple of the spacing
std::vector<Case> surfaceCases();   ///< surfaces

/// For Case::adapt: makes domain and boxes six spacings (three support radii) wide along periodic axes. Finer
/// runs of one-dimensional cases then cost no more across.
void makeThin(Scene& scene);

/// Runs a case to the end of its scene. The surface is updated at and between frames as in `thaw run`, and at
/// the end. `overrides` has the form of `thaw run --set`. Throws SceneErrors.
void run(const Case& c, Trial& trial, const std::vector<std::string>& overrides);

// Sums over the particles of all ranks. They are exact, so that figures have the same bits on any number of
// ranks.
using OfParticle = std::function<double(const World&, std::size_t row)>;
double sum(Trial& trial, const OfParticle& f);
double largest(Trial& trial, const OfParticle& f);
/// Root of the mean of squares.
double rootMeanSquare(Trial& trial, const OfParticle& f);

}  // namespace thaw::accuracy
