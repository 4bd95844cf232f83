// SPDX-License-Identifier: Apache-2.0
// Fields of sheet vertices (docs/theory/sheets.md), one per line.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/particles/body_type_rows.hpp"
#include "core/particles/solids.hpp"
#include "core/sheet/data/exact_step.hpp"
#include "core/sheet/data/plan_sheets.hpp"

namespace thaw {

struct MeshSearch;

struct Sheets : BodyTypeRows {
  Sheets() : BodyTypeRows("sheet") {}
  // clang-format off
  Column<Vec3d> rest{*this, "rest", "m", Keep::State,
      "initial position, the rest position q0 without plastic flow"};
  Column<Vec3d> flow{*this, "flow", "m", Keep::State,
      "plastic displacement: the rest position q0 is rest + flow; only for plastic sheets"};
  Column<double> hardening{*this, "hardening", "m", Keep::State,
      "growth of the elastic limit: 1 - plasticity times the excess"};
  Column<Vec3d> load{*this, "load", "N/m^2", Keep::State,
      "force per area of the last evaluation, without rest spring and damping"};
  Column<Vec3d> outside{*this, "outside", "N/m^2", Keep::State,
      "external part of the load: wind, shrink-wrap, pressure brushes; only where a sheet has one"};
  Column<Mat3d> changing{*this, "changing", "J", Keep::State,
      "energy of time-dependent coefficients at a factor of 1: warp, weft, shear; bending, volume, "
      "repulsion; attraction; only where one changes"};
  Column<Vec3d> moved{*this, "moved", "m", Keep::State,
      "displacement over the last step; only with external loads or damping"};
  Column<Vec3d> dissipativeForce{*this, "dissipativeForce", "N/m^2", Keep::State,
      "dissipative part of the load: dashpots and friction; only where a sheet touches anything"};
  Column<double> area{*this, "area", "m^2", Keep::State, "initial area, a third of the vertex's triangles"};
  Column<std::uint16_t> law{*this, "law", "1", Keep::State, "index into SheetBodies::laws"};
  Column<std::uint32_t> part{*this, "part", "1", Keep::State,
      "index into SheetBodies::parts, its connected component"};
  Column<std::uint8_t> clamped{*this, "clamped", "1", Keep::State, "1: fixed position"};
  Column<double> temperature{*this, "temperature", "K", Keep::State, "temperature; only with heat"};
  Column<double> heatFlow{*this, "heatFlow", "W", Keep::Transient, "sum of all heat flows into the vertex"};
  Column<Vec3d> areaNormal{*this, "areaNormal", "m^2", Keep::Transient,
      "area vector: a third of its triangles', along the normal"};
  Column<Vec3d> moving{*this, "moving", "m/s", Keep::Transient,
      "velocity at the time of the forces; only with contact of vertices"};
  Column<std::uint32_t> solidIndex{*this, "solid_index", "1", Keep::Local, "row in the table of edges' ends"};
  // clang-format on
};

/// Edges as bonds (core/solid/). The bonds of a vertex are first its ring, counter-clockwise, then the
/// vertices across edges. For a bond, x is the rest length (m) and y the stiffness (N/m). z is 1 + the ring
/// index of the neighbour that closes a triangle with it (0: none). The weight is 1 + its own index.
struct SheetEdges {
  Solids ends;
  Bonds bonds;
};

/// Time factors (1) of a sheet's coefficients, parallel to sheetCoefficients. now: current values; most:
/// maxima until the end of the next step, for the step limit.
struct FactorsNow {
  std::array<double, sheetFactors> now, most;
};

/// The sheets on one rank.
struct SheetBodies {
  Sheets rows;
  CellTable cells;
  SheetEdges edges;
  // from the scene, the same on all ranks; not part of the state
  std::vector<SheetPlan> plans;  ///< per sheet
  std::vector<SheetLaw> laws;
  std::vector<SheetPart> parts;
  // results of the last evaluation
  std::vector<FactorsNow> factors;  ///< per sheet
  std::vector<double> slope;        ///< N/m^3, per owned row: sum of the slope bounds of neighbour forces and
                                    ///< contacts
  /// N/m^3, per law: largest slope of any vertex of this rank. Sums over two vertices would depend on the
  /// partition.
  std::vector<double> stiffest;
  double fastestDrag = 0;       ///< 1/s, largest drag rate of the wind on this rank, 2 rho |u_n| area / mass
  double stiffestParticle = 0;  ///< 1/s^2, largest slope of vertex contact over particle mass on this rank
  double fastest2 = 0;  ///< m^2/s^2, largest squared speed of this rank's vertices that can touch anything
  double largestAcceleration = 0;  ///< m/s^2, largest acceleration of these vertices by loads
  double impactRate = 0;   ///< 1/s, inverse of the longest step that impacts allow, on this rank (blowRate in
                           ///< touch.hpp)
  double closingRate = 0;  ///< 1/s, largest approach speed over distance of touching vertices, triangles and
                           ///< edges, on this rank
  std::shared_ptr<MeshSearch> search;  ///< current contact search (mesh_pairs.hpp), kept to reuse memory; not
                                       ///< part of the state
  std::vector<Vec3d> velocityBuffer, impulseBuffer;  ///< buffers by vertex, kept because allocation costs as
                                                     ///< much as a force evaluation
  bool leftHere = false;     ///< a vertex has left the domain since the last update of edges
  bool edgesAtStart = true;  ///< the next evaluation creates the bonds from the plans
};

}  // namespace thaw
