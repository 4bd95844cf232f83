// SPDX-License-Identifier: Apache-2.0
// A ModelPart declares a part of the library's own model: keys, modules, step limits and energies. The keys
// are in the scene's own tables, such as [[lamp]] or [material.NAME]. Body forces, heat sources and pair
// forces also declare their functions here. Sums that are fused for speed, such as pressure and viscosity,
// are called from core/simulation/modules/. core/terms/terms.hpp lists all terms.
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

/// Members of an element of a list of tables, for checks common to all lists. Null: the element has no such
/// member.
struct TermElement {
  SourcePlace* where = nullptr;
  std::string* name = nullptr;
  int* material = nullptr;  ///< index into Scene::materials; -1: all
  Shape* shape = nullptr;
};

/// A list of tables [[key]] of a scene. Its elements are in a vector of Scene.
struct TermTable {
  const char *key, *title;  ///< title: used in messages and for elements without a name
  const char* about;
  std::size_t (*size)(const Scene&);
  TermElement (*at)(Scene&, std::size_t);
  void (*append)(Scene&);
  void (*removeLast)(Scene&);
  void (*keys)(KeyTable&, Scene&, std::size_t);  ///< declares the keys of an element
};

/// Returns the TermTable of a vector of Scene. Keys: void(KeyTable&, Element&).
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

/// A module of a term, with its name in the list of `thaw check`.
struct TermModule {
  bool Modules::*module;
  const char* name;
};

/// A module that a term needs, and the reason, such as "the density of ...", in the list of `thaw check`. The
/// module may belong to another term.
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

/// The force field to which a sum over pairs adds.
enum class PairTarget {
  Force,          ///< Continuum::force
  ExplicitForce,  ///< Continuum::force, or Continuum::drag with incompressible liquid
  PositionForce   ///< Continuum::positionForce if it is active (for forces that depend on positions alone),
                  ///< else Continuum::force
};

/// A sum over pairs by the vector code of the library (core/fluid/pair_sums/pair_kernels.hpp). It is called
/// after the sum of pressures, first for inner and then for boundary groups.
struct PairSweep {
  void (*PairKernels::*sum)(const PairSums&, GroupRange);
  bool (*isOn)(const Numerics&, const Modules&);
  PairTarget onto = PairTarget::Force;
  /// Packs the records that it reads in addition to those of the pressure sum. Null: no additional records.
  void (*pack)(const RecordContext&, const Continuum&, std::size_t begin, std::size_t end,
               PairRecords&) = nullptr;
};

/// The scene and its meshes, for the start of a term. Errors of shapes are added to problems.
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
  /// Rejects meaningless combinations after all keys of the material are read.
  void (*checkMaterial)(KeyTable&, const Material&, const Numerics&) = nullptr;
  // Modules
  std::vector<TermModule> modules = {};  ///< each belongs to one term
  /// Returns the modules that the scene needs independent of the phases of its particles, which are not known
  /// yet. These are mostly reasons for which temperatures change. Null: none.
  std::vector<ModuleUse> (*earlyUses)(const Scene&) = nullptr;
  /// Returns the modules that the scene needs, given the modules found so far, including those of terms
  /// earlier in the list. Null: none. The scene uses the term if this function returns any; if it is null,
  /// earlyUses decides.
  std::vector<ModuleUse> (*uses)(const Scene&, const Modules& found) = nullptr;
  // Action
  LoadStage stage = LoadStage::Forces;
  /// Creates the force or heat source. It adds to OutsideLoad::force and heat, which point to fields of the
  /// particles, and records its energies in the ledger.
  OutsideSource (*start)(const TermSetup&) = nullptr;
  /// Records work and impulse of the force in a half kick. It is called before the kick.
  void (*recordKick)(const OutsideLoad&, HalfKick) = nullptr;
  std::vector<PairSweep> sweeps = {};
  /// Names of its step limits, from limitNames (core/simulation/time/step_limits.hpp).
  std::vector<const char*> limits = {};
  /// Longest stable step (s) at a time (s), for the first limit. Null: set-up or the forces determine the
  /// limit.
  double (*stepLimit)(const Scene&, double time) = nullptr;
  std::vector<const char*> energies = {};  ///< columns of ledger.csv with its energy, work, heat or mass
};

/// A term of a scene.
struct ActiveTerm {
  const ModelPart* part = nullptr;
  OutsideSource add = {};
};

}  // namespace thaw
