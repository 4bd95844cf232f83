// The fields of continuum particles (K05): one line a field. A scene activates the fields of the modules that
// it switches on.
#pragma once
#include "core/particles/column.hpp"

namespace thaw {

inline constexpr std::uint32_t noSlot = 0xffffffffu;

enum Phase : std::uint8_t { Solid = 0, Liquid = 1 };

inline constexpr std::uint8_t held = 1, driven = 2;  ///< values of Continuum::clamped

struct Continuum : Table {
  Continuum() : Table("continuum") {}
  using u8 = std::uint8_t;
  // always
  // clang-format off
  Column<std::uint64_t> id{*this, "id", "1", Keep::State,
      "body or emitter number << 40 | number of the sample in it"};
  Column<Vec3d> position{*this, "position", "m", Keep::State, "centre"};
  Column<Vec3d> velocity{*this, "velocity", "m/s", Keep::State, "at the same time as the position"};
  Column<Vec3d> acceleration{*this, "acceleration", "m/s^2", Keep::State,
      "of the last force evaluation; the next half kick uses it", Rows::Owned};
  Column<Vec3d> fastAcceleration{*this, "fastAcceleration", "m/s^2", Keep::State,
      "its part that substeps kick with: of bonds, and of a solid's contacts with walls", Rows::Owned};
  Column<double> mass{*this, "mass", "kg", Keep::State, "constant"};
  Column<std::uint16_t> material{*this, "material", "1", Keep::State, "index into the scene's materials"};
  Column<std::uint16_t> body{*this, "body", "1", Keep::State, "index into bodies, then emitters"};
  Column<double> dissipated{*this, "dissipated", "J", Keep::State,
      "mechanical energy lost at this particle so far", Rows::Owned};
  Column<std::uint64_t> cell{*this, "cell", "1", Keep::Local,
      "key of the cell at the last sort", Rows::Owned};
  GuestColumn<std::uint64_t> nextCell{*this, "nextCell", "1", Keep::Local,
      "key of the cell now: from the drift to the sort, in the memory of `dissipation`", Rows::Owned};
  Column<u8> clamped{*this, "clamped", "1", Keep::State,
      "1: held where it is; 2: driven by its emitter, at constant velocity"};
  // fluid
  Column<float> filling{*this, "filling", "1", Keep::Transient,
      "delta = sum V0_j W_ij over its lattice value; density = delta * rest density"};
  Column<double> compression{*this, "compression", "1", Keep::State,
      "carried relative density less 1; in solids, that of adjacent liquid, else 0"};
  Column<double> densityRate{*this, "densityRate", "1/s", Keep::Transient,
      "rate of compression by the flow", Rows::Owned};
  Column<double> spreading{*this, "spreading", "1/s", Keep::Transient,
      "rate of compression by diffusion", Rows::Owned};
  Column<Sym3f> moment{*this, "moment", "1", Keep::Transient,
      "moment of the neighbourhood at mid-step", Rows::Owned};
  Column<Sym3f> midCorrection{*this, "midCorrection", "1", Keep::State,
      "inverse of the moment less 1, at the last mid-step", Rows::Owned};
  Column<Sym3f> correction{*this, "correction", "1", Keep::Transient,
      "gradient correction of the pressure, extrapolated to the end of the step"};
  Column<Mat3f> flow{*this, "flow", "1/s", Keep::Transient,
      "minus the velocity gradient, uncorrected; one row per derivative", Rows::Owned};
  Column<float> wetting{*this, "wetting", "1", Keep::Transient,
      "sum V W of liquid, with the particle's own; 0: no liquid near", Rows::Owned};
  Column<Vec3f> solidNormal{*this, "solidNormal", "1", Keep::Transient,
      "away from solid neighbours, weighted; 0 without any", Rows::Owned};
  Column<Vec3d> travel{*this, "travel", "m/s", Keep::State,
      "mean velocity over the step of a particle with substeps"};
  Column<Vec3d> smoothing{*this, "smoothing", "m/s", Keep::State,
      "XSPH and shifting: the particle moves with velocity + smoothing"};
  Column<Vec3f> crowding{*this, "crowding", "1", Keep::Transient,
      "h grad of the filling by places", Rows::Owned};
  Column<u8> atSurface{*this, "atSurface", "1", Keep::State,
      "1 at the free surface in the last step (core/fluid/free_surface.hpp)"};
  Column<Vec3f> surfaceNormal{*this, "surfaceNormal", "1", Keep::Transient,
      "away from neighbours at the free surface, weighted; 0 without any", Rows::Owned};
  Column<float> gradientSize{*this, "gradientSize", "1", Keep::Transient, "h sum V |grad W|", Rows::Owned};
  // incompressible liquids (core/fluid/incompressible/)
  Column<float> holding{*this, "holding", "Pa", Keep::State,
      "pressure that keeps the volume over the next step, over that step: where the next solve begins"};
  Column<float> steadying{*this, "steadying", "Pa", Keep::State,
      "pressure that stopped compression at the end of the last step, over that step: likewise"};
  Column<Vec3d> pressureKick{*this, "pressureKick", "m/s", Keep::State,
      "velocity that the next step begins by adding: of `holding`"};
  Column<Vec3d> drag{*this, "drag", "N", Keep::Transient,
      "the part of the force that takes energy away: viscosity, drag of walls"};
  Column<float> trialPressure{*this, "trialPressure", "Pa s", Keep::Transient,
      "of the iteration at hand, over the step"};
  Column<Vec3d> trialVelocity{*this, "trialVelocity", "m/s", Keep::Transient, "that follows from it"};
  Column<float> exposure{*this, "exposure", "1", Keep::Transient,
      "share in the free surface; 1 for a column of particles below a flat surface"};
  // surface tension as an energy of the surface (core/fluid/surface_energy.hpp)
  Column<Vec3d> surfaceGradient{*this, "surfaceGradient", "1", Keep::Transient,
      "h sum V grad W: into the liquid at its surface, 0 inside"};
  Column<double> surfaceCover{*this, "surfaceCover", "1", Keep::Transient, "sum V W of the others"};
  Column<Vec3d> surfacePull{*this, "surfacePull", "Pa", Keep::Transient,
      "slope of the surface energy per volume by surfaceGradient"};
  Column<double> surfaceDraw{*this, "surfaceDraw", "Pa", Keep::Transient, "and by surfaceCover"};
  Column<Vec3d> viscousAcceleration{*this, "viscousAcceleration", "m/s^2", Keep::State,
      "by implicit viscosity in the last step, where the next one starts to look"};
  Column<Vec3d> viscousSearch{*this, "viscousSearch", "m/s", Keep::Transient,
      "velocities that implicit viscosity sends to ghosts"};
  // heat and phase
  Column<double> enthalpy{*this, "enthalpy", "J/kg", Keep::State,
      "0 at the solidus (at 0 K for materials that do not melt)"};
  Column<double> temperature{*this, "temperature", "K", Keep::State,
      "function of the enthalpy (state itself in the paper's heat model)"};
  Column<float> liquid{*this, "liquid", "1", Keep::State, "liquid fraction; blend parameter of the material"};
  Column<u8> phase{*this, "phase", "1", Keep::State, "Solid: has or may have bonds; Liquid: has none"};
  // surface (core/surface/)
  Column<Vec3d> surfacePlace{*this, "surfacePlace", "m", Keep::State,
      "position at the last update of the surface"};
  Column<Vec3d> surfaceStart{*this, "surfaceStart", "m", Keep::State,
      "place when the surface was made; only where there are solids"};
  Column<std::uint64_t> component{*this, "component", "1", Keep::State,
      "label: 1 + the smallest id of a particle of its component; 0: came after the last update"};
  Column<double> surfaceShare{*this, "surfaceShare", "1", Keep::State,
      "volume that the surface is to hold for it over its own: that of its body's mesh or shape at the "
      "start; 0: its own"};
  Column<float> surfaceFill{*this, "surfaceFill", "1", Keep::State,
      "what of its body was around it at the start, over the mean (cell_shares.hpp); 0: as much as of any"};
  // contact with sheets by triangles (core/sheet/face_contact.hpp): what the particle's owner found
  Column<std::uint32_t> sheetFace{*this, "sheetFace", "1", Keep::Transient,
      "1 + number of the triangle of the sheet that it is deepest in; 0: it touches none"};
  Column<Vec3d> sheetPush{*this, "sheetPush", "N, N, N/m", Keep::Transient,
      "force along the slope of its depth in the sheet, what of it takes energy away, and their own slope, "
      "for a triangle at a depth of 1 (face_contact.cpp)"};
  Column<Mat3d> sheetRubs{*this, "sheetRubs", "N", Keep::Transient,
      "friction on the corners of the sheet's triangle that it touches, a row each"};
  Column<Vec3d> sheetNumbers{*this, "sheetNumbers", "J, W/K, K", Keep::Transient,
      "energy and conductance to the sheet, for a triangle at a depth of 1, and the temperature of the "
      "particle"};
  // solid
  Column<std::uint32_t> slot{*this, "slot", "1", Keep::Local,
      "row in the table of solids, noSlot for liquids"};
  // at rest (core/sleep/sleep.hpp)
  Column<float> calm{*this, "calm", "s", Keep::State,
      "for how long it has neither moved, accelerated nor warmed"};
  Column<u8> sleep{*this, "sleep", "1", Keep::State,
      "0: awake; 1, 2: held where it is; 3: and nothing in its sums changes"};
  Column<Vec3d> hold{*this, "hold", "N", Keep::State,
      "of what is held: what balances its weight and all forces but those of walls"};
  // to form bonds in a running simulation (solid/bond_forming.hpp); exchanged only after something froze
  Column<Mat3d> frame{*this, "frame", "1", Keep::Transient,
      "F of the particle; the identity if it has just frozen"};
  Column<u8> justFrozen{*this, "justFrozen", "1", Keep::State,
      "froze in this step: takes its bonds in the next, wherever that is, or after a restart"};
  Column<float> standoff{*this, "standoff", "1", Keep::State,
      "spacings from a wall at which a solid rests; less than 1/2 where it froze closer to it"};
  Column<Vec3d> home{*this, "home", "m", Keep::Transient,
      "position, not shifted in periodic images; only with periodic sides"};
  // rates of the current step
  GuestColumn<Vec3d> force{*this, "force", "N", Keep::Transient,
      "sum of all forces; where nobody asks for both it is in the memory of `acceleration` until the kick "
      "makes that of it (forceOf, core/time/integrate.hpp)", Rows::Owned};
  Column<double> heatFlow{*this, "heatFlow", "W", Keep::Transient,
      "sum of all heat flows into the particle", Rows::Owned};
  Column<double> dissipation{*this, "dissipation", "W", Keep::Transient,
      "rate of loss of mechanical energy at this particle", Rows::Owned};
  Column<double> interaction{*this, "interaction", "J", Keep::State,
      "potential energy of pair and wall contacts, this particle's half; what leaves takes it along, also "
      "right after a restart", Rows::Owned};
  Column<double> softening{*this, "softening", "J", Keep::Transient,
      "d(interaction of all)/d(liquid fraction of this one), places held; only where a material "
      "melts", Rows::Owned};
  // clang-format on
};

/// Does a particle take substeps (core/solid_substeps.hpp)? Not what has melted or frozen at the end of the
/// last step: it has no bonds.
inline bool takesSubsteps(const Continuum& p, std::size_t i) {
  return p.slot[i] != noSlot && p.phase[i] == Solid && !(p.justFrozen.active && p.justFrozen[i]);
}

}  // namespace thaw
