// The fields of the vertices of sheets (docs/theory/sheets.md): one line a field.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/kinds/kind_rows.hpp"
#include "core/neighbours/grid.hpp"
#include "core/sheet/exact_step.hpp"
#include "core/sheet/plan_sheets.hpp"
#include "core/solid/solids.hpp"

namespace thaw {

struct MeshSearch;

struct Sheets : KindRows {
  Sheets() : KindRows("sheet") {}
  // clang-format off
  Column<Vec3d> rest{*this, "rest", "m", Keep::State,
      "where the vertex is at the start and, without plastic flow, at rest: q0"};
  Column<Vec3d> flow{*this, "flow", "m", Keep::State,
      "plastic: the place of rest q0 is rest + flow; only where a sheet is plastic"};
  Column<double> hardening{*this, "hardening", "m", Keep::State,
      "what the elastic limit has grown by: 1 - plasticity of what went beyond it"};
  Column<Vec3d> load{*this, "load", "N/m^2", Keep::State,
      "force per area of the last evaluation, all but the spring to the place of rest and its damping"};
  Column<Vec3d> outside{*this, "outside", "N/m^2", Keep::State,
      "its part that does work from outside: wind, wrap, brushes; only where a sheet has one"};
  Column<Mat3d> changing{*this, "changing", "J", Keep::State,
      "stored by coefficients that change in time, each at a factor of 1: warp, weft, shear; bending, "
      "volume, push; pull; only where one does"};
  Column<Vec3d> moved{*this, "moved", "m", Keep::State,
      "over the last step: work of what pushes, losses of damping; only where there is either"};
  Column<Vec3d> resisting{*this, "resisting", "N/m^2", Keep::State,
      "part of the load that takes mechanical energy away: dashpots, friction; only where a sheet touches "
      "anything"};
  Column<double> area{*this, "area", "m^2", Keep::State,
      "of the sheet at the start, a third of the vertex' triangles"};
  Column<std::uint16_t> law{*this, "law", "1", Keep::State, "index into SheetBodies::laws"};
  Column<std::uint32_t> part{*this, "part", "1", Keep::State,
      "index into SheetBodies::parts: the connected piece it belongs to"};
  Column<std::uint8_t> clamped{*this, "clamped", "1", Keep::State, "1: held where it is"};
  Column<double> temperature{*this, "temperature", "K", Keep::State, "only where there is heat"};
  Column<double> heatFlow{*this, "heatFlow", "W", Keep::Transient, "sum of all heat flows into the vertex"};
  Column<Vec3d> facing{*this, "facing", "m^2", Keep::Transient,
      "area vector: of a third of its triangles, along the normal"};
  Column<Vec3d> moving{*this, "moving", "m/s", Keep::Transient,
      "velocity at the time of the forces; only where vertices touch each other or particles"};
  Column<std::uint32_t> slot{*this, "slot", "1", Keep::Local, "row in the table of edges' ends"};
  // clang-format on
};

/// Edges as bonds of the shared machinery (core/solid/): of each vertex first its ring, counter-clockwise,
/// then the vertices across edges. Of a bond x is the length at rest (m), y the stiffness (N/m), z 1 + the
/// number in the ring of the neighbour that closes a triangle with it (0: none), the weight 1 + its own
/// number.
struct SheetEdges {
  Solids ends;
  Bonds bonds;
};

/// Factors in time of a sheet's coefficients, beside sheetCoefficients: at the forces of now, and the largest
/// until the end of the next step, for its limit.
struct FactorsNow {
  std::array<double, sheetFactors> now, most;
};

/// All of the sheets on one rank.
struct SheetBodies {
  Sheets rows;
  CellTable cells;
  SheetEdges edges;
  // the same on all ranks; from the scene, not part of the state
  std::vector<SheetPlan> plans;  ///< of each sheet
  std::vector<SheetLaw> laws;
  std::vector<SheetPart> parts;
  // of the last evaluation
  std::vector<FactorsNow> factors;  ///< of each sheet
  std::vector<double> slope;        ///< N/m^3, of each owned row: bound of the slope of neighbour forces and
                                    ///< contacts, added up over them
  std::vector<double> stiffest;     ///< N/m^3, of each law: the largest slope of this rank's vertices. Of one
                                 ///< vertex each: a sum of two vertices' would depend on what is on the same
                                 ///< rank
  double fastestDrag = 0;  ///< 1/s, of the wind: how fast it takes along a vertex, 2 rho |u_n| area / mass;
                           ///< the largest of this rank
  double stiffestParticle = 0;  ///< 1/s^2, contact with vertices over the mass of particles: the largest of
                                ///< this rank
  double fastest2 = 0;  ///< m^2/s^2, square of the largest speed of this rank's vertices that can touch
                        ///< anything
  double hardest = 0;   ///< m/s^2, the largest acceleration of these by their loads
  double blows = 0;  ///< 1/s, rate of contact over the step that blows allow it (blowRate in touch.hpp): the
                     ///< largest of this rank
  double closing = 0;  ///< 1/s, how fast vertices, triangles and edges that touch come together, over their
                       ///< distance: the largest of this rank
  std::shared_ptr<MeshSearch> search;  ///< of contact by triangles, in the evaluation at hand
                                       ///< (mesh_pairs.hpp); kept for its memory, not part of the state
  std::vector<Vec3d> velocityRoom, impulseRoom;  ///< one a vertex, of an evaluation; kept, since fresh memory
                                                 ///< in every step costs as much as a force
  bool leftHere = false;     ///< a vertex has left the domain since edges were last linked
  bool edgesAtStart = true;  ///< the next evaluation makes the bonds, from the plans
};

}  // namespace thaw
