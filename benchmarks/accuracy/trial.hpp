// One run of an accuracy case: a scene, stepped as `thaw run` does it, and the figures that are taken of it.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/ledger/report.hpp"
#include "core/setup/setup.hpp"
#include "core/surface/update_surface.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"
#include "parallel/row_courier.hpp"

namespace thaw::accuracy {

/// An error norm and what it is to reach (never: nothing is asked for). floor: what a finer spacing cannot
/// better, said in the charts.
struct Figure {
  std::string norm;
  double error;
  double target = never;
};

/// Values at one time, for cases that follow something.
struct Sample {
  double time;
  std::vector<double> value;
};

struct Trial {
  explicit Trial(const Communicator& c) : comm(c), all(c) {}
  Halos halos() { return {all, *cells, *bonds}; }
  double spacing() const { return world.scene.spacing; }

  const Communicator& comm;
  World world;
  StepTools tools;
  MpiReducer all;
  std::unique_ptr<MpiCellHalo> cells;
  std::unique_ptr<MpiBondHalo> bonds;
  std::unique_ptr<SurfaceRanks> surface;  ///< where the scene has one
  SurfaceTools surfaceTools;
  std::vector<Sample> series;           ///< what `watch` notes
  std::map<std::string, double> notes;  ///< what hooks leave for each other
  std::vector<std::string> overrides;   ///< what `run` was given
  std::vector<std::uint64_t> ids;       ///< the same: of what `series` is about
  double coreSeconds = 0;  ///< processor time of the steps, of all ranks; the surface with its start is part
                           ///< of it
  double updateSeconds = 0;  ///< that of the surface's updates
  bool finite = true;        ///< false: the run blew up, and the figures say so
};

/// A case: its scene is scenes/<name>.toml unless it says another. Hooks may be empty; all are collective.
struct Case {
  const char* name;
  const char* about;                       ///< what is run, and against what: one line with its source
  const char* scene = nullptr;             ///< file in scenes/
  std::function<void(Trial&)> place = {};  ///< moves particles before bonds are made (jitter)
  std::function<void(Trial&)> start = {};  ///< velocities, displacements, temperatures at time 0; takeStock
                                           ///< follows
  std::function<void(Trial&)> watch = {};  ///< after every step
  std::function<std::vector<Figure>(Trial&)> measure;
  std::function<void(Scene&)> adapt = {};  ///< changes the scene once it is read: what follows the spacing
};

/// Every case. A file of cases for each part of the method; cases.cpp joins them.
std::vector<Case> allCases();
std::vector<Case> flowCases();       ///< pressure: columns, dam breaks, vortices
std::vector<Case> stretchedCases();  ///< liquids without walls that their own flow stretches
std::vector<Case> viscousCases();    ///< viscosity and surface tension
std::vector<Case> solidCases();
std::vector<Case> heatCases();
std::vector<Case> mixedCases();     ///< liquids and solids in one scene
std::vector<Case> floatingCases();  ///< solids that float, sink and rise in water
std::vector<Case> tankCases();      ///< tanks that are no multiple of the spacing
std::vector<Case> surfaceCases();   ///< surfels

/// For Case::adapt: domain and boxes are six spacings (three support radii) wide along the periodic axes, so
/// that a finer run of a one-dimensional case costs no more across.
void makeThin(Scene& scene);

/// Runs a case to the end of its scene; a surface is updated as `thaw run` does it, at frames and between
/// them, and at the end. overrides: as `thaw run --set`. Throws SceneErrors.
void run(const Case& c, Trial& trial, const std::vector<std::string>& overrides);

// Sums over the particles of all ranks, exact, so that figures have the same bits on any number of ranks.
using OfParticle = std::function<double(const World&, std::size_t row)>;
double sum(Trial& trial, const OfParticle& f);
double largest(Trial& trial, const OfParticle& f);
/// Root of the mean of squares.
double rootMeanSquare(Trial& trial, const OfParticle& f);

}  // namespace thaw::accuracy
