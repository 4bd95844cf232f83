// SPDX-License-Identifier: Apache-2.0
// The fields of continuum particles (K05), each with one declaration. A scene activates the fields of the
// modules that it uses.
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "core/particles/added_column.hpp"
#include "core/particles/column.hpp"

namespace thaw {

inline constexpr std::uint32_t noSolid = 0xffffffffu;

enum Phase : std::uint8_t { Solid = 0, Liquid = 1 };

inline constexpr std::uint8_t fixedInPlace = 1, driven = 2,
                              fixedByPiece = 3;  ///< values of Continuum::clamped

inline constexpr std::uint64_t notRigid = 0;  ///< value of Continuum::piece

inline constexpr double atFracture = -1;  ///< value of Continuum::touchTime

struct Continuum : Table {
  Continuum() : Table("continuum") {}
  using u8 = std::uint8_t;
  // Always active.
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "body or emitter number << 40 | number of the sample in it"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::State, "at the same time as the position"};
  Column<Vec3d> acceleration{*this, "acceleration", "m/s^2", Keep::State,
      "from the last force evaluation; the next half kick uses it", Rows::Owned};
  Column<Vec3d> fastAcceleration{*this, "fastAcceleration", "m/s^2", Keep::State,
      "part that substeps apply: bonds, and contacts of solids with walls", Rows::Owned};
  Column<double> mass{*this, "mass", "kg", Keep::State, "constant, except in liquids that evaporate"};
  Column<std::uint16_t> material{*this, "material", "1", Keep::State, "index into the scene's materials"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into bodies, then emitters"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::State,
      "mechanical energy lost at this particle so far", Rows::Owned};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local,
      "key of the cell at the last sort", Rows::Owned};
  GuestColumn<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local,
      "key of the current cell, valid from the drift to the sort; shares the memory of "
      "`dissipation`", Rows::Owned};
  Column<u8> clamped{*this, "clamped", "1", Keep::State,
      "1: fixed until it melts; 2: driven by its emitter at constant velocity; 3: part of a rigid piece with "
      "fixed particles"};
  Column<double> restDensity{*this, "restDensity", "kg/m^3", Keep::State,
      "density at rest, of materials whose phases differ in density"};
  // Fluid.
  Column<float> relativeDensity{*this, "relativeDensity", "1", Keep::Transient,
      "relative density: delta = sum V0_j W_ij over its lattice value; density = delta * rest density"};
  Column<double> compression{*this, "compression", "1", Keep::State,
      "carried relative density minus 1; in solids, that of adjacent liquid, else 0"};
  Column<Sym3f> midCorrection{*this, "midCorrection", "1", Keep::State,
      "inverse of the moment minus 1, at the last mid-step", Rows::Owned};
  Column<Sym3f> correction{*this, "correction", "1", Keep::Transient,
      "gradient correction of the pressure, extrapolated to the end of the step"};
  Column<Vec3f> relief{*this, "relief", "N", Keep::Transient,
      "force on liquid from all its solid neighbours (core/fluid/laws/lattice_relief.hpp)"};
  Column<Vec3d> stepMeanVelocity{*this, "stepMeanVelocity", "m/s", Keep::State,
      "mean velocity over the step, of particles with substeps"};
  Column<Vec3d> shiftingVelocity{*this, "shiftingVelocity", "m/s", Keep::State,
      "XSPH and shifting velocity; a particle moves with the sum of this and velocity"};
  Column<Vec3d> positionForce{*this, "positionForce", "N", Keep::State,
      "surface tension and pair forces of extensions; their work on shifting is recorded", Rows::Owned};
  Column<Vec3f> concentrationGradient{*this, "concentrationGradient", "1", Keep::Transient,
      "concentration gradient times h", Rows::Owned};
  Column<u8> atSurface{*this, "atSurface", "1", Keep::State,
      "1: at the free surface in the last step (core/fluid/laws/free_surface.hpp)"};
  // Incompressible liquids (core/flow/incompressible/).
  Column<float> densityPressure{*this, "densityPressure", "Pa", Keep::State,
      "density pressure (DFSPH) of the next step, over the step; initial guess of the next solve"};
  Column<float> divergencePressure{*this, "divergencePressure", "Pa", Keep::State,
      "divergence pressure (DFSPH) of the last step, over the step; initial guess of the next solve"};
  Column<Vec3d> pressureImpulse{*this, "pressureImpulse", "m/s", Keep::State,
      "velocity change due to the density pressure, added at the start of the next step"};
  Column<Vec3d> drag{*this, "drag", "N", Keep::Transient,
      "dissipative part of the force: viscosity, drag of walls"};
  Column<float> trialPressure{*this, "trialPressure", "Pa s", Keep::Transient,
      "pressure of the current iteration times the step"};
  Column<Vec3d> trialVelocity{*this, "trialVelocity", "m/s", Keep::Transient,
      "velocity that follows from trialPressure"};
  Column<float> freeSurfaceIndicator{*this, "freeSurfaceIndicator", "1", Keep::Transient,
      "free-surface indicator; 1 for a column of particles below a flat surface"};
  // Surface tension as a surface energy (core/fluid/laws/surface_energy.hpp).
  Column<Vec3d> surfaceGradient{*this, "surfaceGradient", "1", Keep::Transient,
      "colour gradient h sum V grad W: points into the liquid at its surface, 0 inside"};
  Column<double> surfaceColour{*this, "surfaceColour", "1", Keep::Transient,
      "colour: sum V W over the neighbours"};
  Column<Vec3d> surfaceEnergyByGradient{*this, "surfaceEnergyByGradient", "Pa", Keep::Transient,
      "derivative of the surface energy per volume with respect to surfaceGradient"};
  Column<double> surfaceEnergyByColour{*this, "surfaceEnergyByColour", "Pa", Keep::Transient,
      "derivative of the surface energy per volume with respect to the colour"};
  Column<float> surfaceTension{*this, "surfaceTension", "N/m", Keep::State,
      "surface tension at its temperature"};
  Column<float> viscosityCorrection{*this, "viscosityCorrection", "1", Keep::State,
      "factor of the viscosity minus 1 (core/fluid/laws/viscosity_factor.hpp)"};
  Column<float> apparentViscosity{*this, "apparentViscosity", "Pa s", Keep::State,
      "viscosity at the shear rate of the last step (core/flow/rheology/)"};
  Column<float> compressionRate{*this, "compressionRate", "1/s", Keep::State,
      "rate of the relative density in the last step; bulk damping uses it", Rows::Owned};
  Column<Vec3d> viscousAcceleration{*this, "viscousAcceleration", "m/s^2", Keep::State,
      "from implicit viscosity in the last step; initial guess of the next solve"};
  Column<Vec3d> viscousSearch{*this, "viscousSearch", "m/s", Keep::Transient,
      "velocities that the implicit viscosity solver exchanges with ghosts"};
  // Heat and phase.
  Column<double> enthalpy{*this, "enthalpy", "J/kg", Keep::State,
      "0 at the solidus; at 0 K for materials that do not melt"};
  Column<double> temperature{*this, "temperature", "K", Keep::State,
      "function of the enthalpy; a state variable of its own in the paper's heat model"};
  Column<float> conductionCorrection{*this, "conductionCorrection", "1", Keep::State,
      "factor of the conductivity minus 1 (core/heat/conduction_correction.hpp)"};
  Column<float> exposedArea{*this, "exposedArea", "1", Keep::Transient,
      "area of the free surface in units of spacing^2 (core/heat/exposed_area.hpp)"};
  Column<float> absorbed{*this, "absorbed", "W", Keep::State,
      "power of lamps, lasers and heated regions into the particle", Rows::Owned};
  Column<Vec3f> contactNormal{*this, "contactNormal", "1", Keep::Transient,
      "normal of its contact with other bodies, away from them; 0: no contact (core/heat/contact_heat.hpp)"};
  Column<Vec3f> exposure{*this, "exposure", "1", Keep::Transient,
      "spacing times the gradient of the neighbours' volume fraction: points into the body at its surface"};
  Column<double> vapour{*this, "vapour", "kg", Keep::State,
      "mass that leaves it as vapour at the start of the next step", Rows::Owned};
  Column<double> vapourEnergy{*this, "vapourEnergy", "J", Keep::State,
      "potential energy of pairs that leaves with it", Rows::Owned};
  Column<float> mushRate{*this, "mushRate", "1/s", Keep::State,
      "rate at which the drag of a mush stops it relative to solidVelocity; 0: none", Rows::Owned};
  Column<Vec3d> solidVelocity{*this, "solidVelocity", "m/s", Keep::State,
      "mean velocity of solid neighbours of a liquid in a mush", Rows::Owned};
  Column<float> liquid{*this, "liquid", "1", Keep::State, "liquid fraction; blend parameter of the material"};
  Column<u8> phase{*this, "phase", "1", Keep::State, "Solid: has or may have bonds; Liquid: has none"};
  // Surface (core/surface/).
  Column<Vec3d> surfacePosition{*this, "surfacePosition", "m", Keep::State,
      "position at the last update of the surface"};
  Column<Vec3d> surfaceStartPosition{*this, "surfaceStartPosition", "m", Keep::State,
      "position when the surface was created; only in scenes with solids"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "label: 1 + smallest particle id of its component; 0: created after the last update"};
  Column<double> surfaceVolumeRatio{*this, "surfaceVolumeRatio", "1", Keep::State,
      "volume that the surface encloses for it, over its own volume: from the mesh or shape of its body at "
      "the start; 0: its own volume"};
  Column<float> initialFill{*this, "initialFill", "1", Keep::State,
      "fraction of its cell that its body filled at the start, over the mean (cell_fractions.hpp); 0: the "
      "mean"};
  // Contact with sheets by triangles (face_contact.hpp), as the owner of the particle computed it.
  Column<std::uint32_t> sheetFace{*this, "sheetFace", "1", Keep::Transient,
      "1 + number of the sheet triangle with the deepest overlap; 0: no contact"};
  Column<Vec3d> sheetNormalForce{*this, "sheetNormalForce", "N, N, N/m", Keep::Transient,
      "force along the gradient of its depth in the sheet, its dissipative part, and their derivative, for a "
      "triangle at a depth of 1 (face_contact.cpp)"};
  Column<Mat3d> sheetFriction{*this, "sheetFriction", "N", Keep::Transient,
      "friction on the corners of the sheet triangle in contact, one row each"};
  Column<Vec3d> sheetContactData{*this, "sheetContactData", "J, W/K, K", Keep::Transient,
      "energy and conductance to the sheet for a triangle at a depth of 1, and temperature of the particle"};
  // Solid.
  Column<std::uint32_t> solidIndex{*this, "solid_index", "1", Keep::Local,
      "row in the table of solids; noSolid for liquids"};
  // Rigid pieces (core/rigid/).
  Column<std::uint64_t> piece{*this, "piece", "1", Keep::State,
      "rigid piece: 1 + smallest id of its particles; 0: none"};
  Column<Vec3d> bodyPosition{*this, "bodyPosition", "m", Keep::State,
      "position in the body frame of its piece", Rows::Owned};
  Column<std::uint32_t> pieceRow{*this, "pieceRow", "1", Keep::Local, "row of its piece on this rank"};
  Column<std::uint64_t> setLabel{*this, "setLabel", "1", Keep::Transient,
      "smallest label found so far in its set of connected rows (core/halo/spread_labels.hpp)"};
  Column<u8> exposed{*this, "exposed", "1", Keep::State,
      "1: rigid particle that the initial surface may no longer cover; only with a surface", Rows::Owned};
  Column<Vec3f> faceNormal{*this, "faceNormal", "1", Keep::State,
      "surface of its rigid piece: normal, or vector to a sharp edge (surface_element.hpp); body frame"};
  Column<float> faceOffset{*this, "faceOffset", "m", Keep::State,
      "distance from the surface of its rigid piece; 0: inside, so it has no contacts"};
  Column<float> faceRadius{*this, "faceRadius", "m", Keep::State,
      "radius of curvature of the surface of its rigid piece; infinite: plane; its offset: round; negative: "
      "code of a sharp edge (core/rigid/contact/edge_code.hpp)"};
  Column<double> touchTime{*this, "touchTime", "s", Keep::State,
      "time for which a hot surface particle has touched another hot piece of its material; -1: at a "
      "fracture that has been hot since; only with welding of rigid pieces"};
  Column<std::uint64_t> contactPartner{*this, "contactPartner", "1", Keep::State,
      "rigid piece or obstacle that pressed on it most in the last step; 0: none", Rows::Owned};
  Column<Vec3d> contactImpulse{*this, "contactImpulse", "N s", Keep::State,
      "impulse of that contact; first guess of the next solve", Rows::Owned};
  Column<Vec3d> rollingImpulse{*this, "rollingImpulse", "N m s", Keep::State,
      "angular impulse of that contact by rolling friction; first guess of the next solve", Rows::Owned};
  // Rest (core/sleep/sleep.hpp).
  Column<float> restTime{*this, "restTime", "s", Keep::State,
      "time since it last moved, accelerated or warmed; with numerics.rigidify, since it last deformed"};
  Column<u8> sleep{*this, "sleep", "1", Keep::State,
      "0: awake; 1, 2: sleeping, fixed in place; 3: sleeping, and its sums are skipped"};
  Column<Vec3d> constraintForce{*this, "constraintForce", "N", Keep::State,
      "constraint force of a sleeping particle: balances its weight and all forces except those of walls; "
      "with numerics.rigidify, the load on it as its energy became constant, in the body frame"};
  // Formation of bonds in a running simulation (bond_forming.hpp). These fields are exchanged only after a
  // particle froze.
  Column<Mat3d> frame{*this, "frame", "1", Keep::Transient,
      "deformation gradient F; the identity if the particle has just frozen"};
  Column<u8> justFrozen{*this, "justFrozen", "1", Keep::State,
      "1: froze in this step; forms its bonds in the next step, also on another rank or after a restart"};
  Column<float> contactOffset{*this, "contactOffset", "1", Keep::State,
      "contact offset: distance from a wall, in spacings, at which a solid rests; below 1/2 if it froze "
      "closer"};
  Column<float> contactDepth{*this, "contactDepth", "1", Keep::State,
      "depth below the surface of its body at the start, in spacings, at most 1/2; 0: 1/2"};
  Column<float> wallOffset{*this, "wallOffset", "1", Keep::State,
      "distance from a wall, in spacings, at which the present contact begins; 0: no contact", Rows::Owned};
  Column<Vec3f> wallShear{*this, "wallShear", "m", Keep::State,
      "displacement of the friction spring to obstacles", Rows::Owned};
  Column<float> contactRest{*this, "contactRest", "1", Keep::State,
      "sum over the solids of other bodies at which contact with them begins; 0: not known yet "
      "(core/contact/body_contact.hpp)", Rows::Owned};
  Column<Vec3d> contactShear{*this, "contactShear", "m", Keep::State,
      "displacement of the friction spring to other bodies", Rows::Owned};
  Column<Mat3f> bodyContact{*this, "bodyContact", "m^2 J J, J, J", Keep::Transient,
      "contact with other bodies: factors of its forces; friction of its spring and of its dashpot"};
  Column<Vec3d> unwrappedPosition{*this, "unwrappedPosition", "m", Keep::Transient,
      "position without the shift of periodic images; only with periodic sides"};
  // Rates of the current step.
  GuestColumn<Vec3d> force{*this, "force", "N", Keep::Transient,
      "sum of all forces; shares the memory of `acceleration` where possible, until the kick converts it "
      "(forceOf, core/simulation/time/integrate.hpp)", Rows::Owned};
  Column<Vec3d> outsideForce{*this, "outsideForce", "N", Keep::State,
      "part of the force that the program adds (core/terms/outside_forces.hpp)", Rows::Owned};
  Column<double> buoyancy{*this, "buoyancy", "1", Keep::State,
      "its relative deficit of density in the last evaluation: its buoyant force over its weight, upwards "
      "(core/terms/buoyant_force.hpp)", Rows::Owned};
  Column<double> heatFlow{*this, "heatFlow", "W", Keep::Transient,
      "sum of all heat flows into the particle", Rows::Owned};
  Column<double> dissipation{*this, "dissipation", "W", Keep::Transient,
      "rate of mechanical energy loss at this particle", Rows::Owned};
  Column<double> interaction{*this, "interaction", "J", Keep::State,
      "potential energy of pair and wall contacts, this particle's half; migrates with the particle, also "
      "right after a restart", Rows::Owned};
  Column<double> softening{*this, "softening", "J", Keep::Transient,
      "d(compression and tension of all)/d(liquid fraction of this particle) at fixed positions; only where "
      "a material melts", Rows::Owned};
  // clang-format on

  /// Fields of extensions, the last of `columns`.
  std::vector<std::unique_ptr<AddedColumn>> added;
  /// Declares the added fields of another table that this one lacks.
  void declareLike(const Continuum& other) {
    for (std::size_t k = added.size(); k < other.added.size(); k++)
      added.push_back(std::make_unique<AddedColumn>(*this, *other.added[k]));
  }
  /// Returns the added field of that name, or null.
  AddedColumn* addedField(std::string_view name) const {
    for (const auto& c : added)
      if (name == c->name) return c.get();
    return nullptr;
  }
};

/// Returns true if a particle belongs to a rigid piece.
inline bool isRigid(const Continuum& p, std::size_t i) { return p.piece.active && p.piece[i] != notRigid; }

/// Returns true if a particle takes substeps (core/simulation/solid_substeps.hpp). Particles that melted or
/// froze at the end of the last step have no bonds and take none.
inline bool takesSubsteps(const Continuum& p, std::size_t i) {
  return p.solidIndex[i] != noSolid && p.phase[i] == Solid && !(p.justFrozen.active && p.justFrozen[i]);
}

}  // namespace thaw
