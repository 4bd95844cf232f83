// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_types/type_actions.hpp"

#include "core/oriented/prepare_oriented.hpp"
#include "core/sheet/forces/inner_forces.hpp"
#include "core/sheet/prepare_sheets.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {
namespace {

TypeActions orientedActions() {
  TypeActions a;
  a.isOn = [](const World& w) { return w.modules.oriented; };
  a.activate = [](World& w) { activateOriented(w.oriented.rows, w.scene, w.modules); };
  a.sample = [](World& w, SamplingOfTypes& x) {
    x.positions = sampleOriented(w.oriented.rows, w.scene, x.halos, x.load, x.warnings);
  };
  a.leavesAtSides = false;  // evaluateOriented removes the rows itself, after it has computed the energy of
                            // their pairs
  return a;
}

TypeActions sheetActions() {
  TypeActions a;
  a.isOn = [](const World& w) { return w.modules.sheet; };
  a.activate = [](World& w) { activateSheets(w.sheets, w.scene, w.modules); };
  a.sample = [](World& w, SamplingOfTypes& x) { sampleSheets(w.sheets, w.scene, x.halos, x.load); };
  a.beforeRemoval = [](World& w, std::span<const std::uint32_t> rows, double dt) {
    finaliseRemoved(sheetView(w), rows, dt);
  };
  a.afterRemoval = [](World& w, bool removed) { clearSolidsAtStart(w.sheets, removed); };
  a.migrateMore = [](World& w, Halos& halos, const Migration& m) {
    halos.edges->migrate(vertexRows(w.sheets.rows), w.sheets.edges.ends, w.sheets.edges.bonds, m);
  };
  a.clear = [](World& w) { clearEdges(w.sheets); };
  return a;
}

}  // namespace

const std::array<TypeActions, bodyTypeCount>& typeActions() {
  static const std::array<TypeActions, bodyTypeCount> all = [] {
    std::array<TypeActions, bodyTypeCount> a;
    a[orientedType] = orientedActions();
    a[sheetType] = sheetActions();
    return a;
  }();
  return all;
}

}  // namespace thaw
