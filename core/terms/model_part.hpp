// SPDX-License-Identifier: Apache-2.0
// The part of an extension by which the library declares a part of its own model: keys in the scene's own
// tables, such as [[lamp]] or [material.NAME], modules, step limits, energies. A body force, a source of heat
// and a pair force have their action here, too. Sums that are fused for speed, such as those of pressure and
// viscosity, act in core/simulation/modules/. core/terms/terms.hpp lists them.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/fluid/pair_sums/pair_kernels.hpp"
#include "core/fluid/pair_sums/records.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/key_table.hpp"
#include "core/scene/modules.hpp"
#include "core/scene/scene.hpp"
#include "core/terms/outside_forces.hpp"

namespace thaw {

/// Members of an element of a list of tables, for checks that all lists share; null: the element has no such
/// member.
struct TermElement {
  SourcePlace* where = nullptr;
  std::string* name = nullptr;
  int* material = nullptr;  ///< index into Scene::materials; -1: all
  Shape* shape = nullptr;
};

/// A list of tables [[key]] of a scene, whose elements are in a vector of Scene.
struct TermTable {
  const char *key, *title;  ///< title: for messages and elements without a name
  const char* about;
  std::size_t (*size)(const Scene&);
  TermElement (*at)(Scene&, std::size_t);
  void (*append)(Scene&);
  void (*removeLast)(Scene&);
  void (*keys)(KeyTable&, Scene&, std::size_t);  ///< declares the keys of an element
};

/// Returns the table of the elements in a vector of Scene. Keys: void(KeyTable&, Element&).
template<auto List, auto Keys> TermTable termTable(const char* key, const char* title, const char* about) {
  return {key,
          title,
          about,
          [](const Scene& s) { return (s.*List).size(); },
          [](Scene& s, std::size_t k) {
            auto& one = (s.*List)[k];
            TermElement element{.where = &one.where};
            if constexpr (requires { one.name; }) element.name = &one.name;
            if constexpr (requires { one.material; }) element.material = &one.material;
            if constexpr (requires { one.shape; }) element.shape = &one.shape;
            return element;
          },
          [](Scene& s) { (s.*List).emplace_back(); },
          [](Scene& s) { (s.*List).pop_back(); },
          [](KeyTable& keys, Scene& s, std::size_t k) { Keys(keys, (s.*List)[k]); }};
}

/// A module that belongs to a term, with its name in the list of `thaw check`.
struct TermModule {
  bool Modules::*module;
  const char* name;
};

/// A module that a term needs, of this or of another term, and why: "the density of ..." in the list of
/// `thaw check`.
struct ModuleUse {
  bool Modules::*module;
  std::string why;
};

/// Stages of a step at which terms act, in this order. Within a stage they act in the order of their list.
enum class LoadStage {
  Forces,    ///< ModulePhase::ContinuumForce
  Exchange,  ///< ModulePhase::AllForces: heat that depends on the particles' own temperatures
  Sources    ///< ModulePhase::AllForces, after evaporation: heat from elsewhere
};

/// The force that a sum over pairs adds to.
enum class PairTarget {
  Force,          ///< Continuum::force
  ExplicitForce,  ///< the same; with incompressible liquid Continuum::drag
  PositionForce   ///< Continuum::positionForce, where forces of positions alone are apart; else the force
};

/// A sum over pairs by the vector code of the library (core/fluid/pair_sums/pair_kernels.hpp). It is called
/// for inner and boundary groups in turn, after the sum of pressures.
struct PairSweep {
  void (*PairKernels::*sum)(const PairSums&, GroupRange);
  bool (*isOn)(const Numerics&, const Modules&);
  PairTarget onto = PairTarget::Force;
  /// Packs records of rows that it reads besides those of pressures; none: no further ones.
  void (*pack)(const RecordContext&, const Continuum&, std::size_t begin, std::size_t end,
               PairRecords&) = nullptr;
};

/// The scene and its meshes, for a term that begins. Errors of shapes are added to problems.
struct TermSetup {
  const Scene& scene;
  const MeshLoader& load;
  SceneProblems& problems;
};

struct ModelPart {
  // Keys
  std::vector<TermTable> tables = {};
  void (*domainKeys)(KeyTable&, Domain&) = nullptr;      ///< in [domain]
  void (*numericsKeys)(KeyTable&, Numerics&) = nullptr;  ///< in [numerics]
  void (*materialKeys)(KeyTable&, Material&) = nullptr;  ///< in [material.NAME]
  /// Refuses meaningless combinations, when all keys of the material are read.
  void (*checkMaterial)(KeyTable&, const Material&, const Numerics&) = nullptr;
  // Modules
  std::vector<TermModule> modules = {};  ///< each belongs to one term
  /// Returns the modules that the scene needs whatever the phases of its particles are, which are not known
  /// then: above all why temperatures change. Null: none.
  std::vector<ModuleUse> (*earlyUses)(const Scene&) = nullptr;
  /// Returns the modules that the scene needs with those that are found before, among them those of terms
  /// earlier in the list. Null: none. The scene uses the term if this, or without it earlyUses, returns any.
  std::vector<ModuleUse> (*uses)(const Scene&, const Modules& found) = nullptr;
  // Action
  LoadStage stage = LoadStage::Forces;
  /// Makes the force or source. It adds to OutsideLoad::force and heat, which are the fields of the
  /// particles, and records its energies in the ledger.
  OutsideSource (*start)(const TermSetup&) = nullptr;
  /// Records work and impulse of the force in a half kick. Called before it.
  void (*recordKick)(const OutsideLoad&, HalfKick) = nullptr;
  std::vector<PairSweep> sweeps = {};
  /// Limits of the step: names in limitNames (core/simulation/time/step_limits.hpp).
  std::vector<const char*> limits = {};
  /// Longest stable step (s) at a time (s), for the first limit; none: set-up or the forces themselves give
  /// it.
  double (*stepLimit)(const Scene&, double time) = nullptr;
  std::vector<const char*> energies = {};  ///< columns of ledger.csv with its energy, work, heat, mass
};

/// A term of a scene.
struct ActiveTerm {
  const ModelPart* part = nullptr;
  OutsideSource add = {};
};

}  // namespace thaw
