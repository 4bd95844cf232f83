// SPDX-License-Identifier: Apache-2.0
// Modules of the model that a scene needs (core/terms/find_modules.hpp). An inactive module allocates no
// field, runs no loop and sends no data.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

struct Modules {
  bool fluid = false;           ///< some particle is or can become liquid: density, pressure, viscosity
  bool continuity = false;      ///< the density of liquids follows from the continuity equation
  bool corrected = false;       ///< the continuity equation uses corrected gradients
  bool shifting = false;        ///< liquid particles shift towards lower concentration
  bool incompressible = false;  ///< pressure from the solver of core/flow/incompressible/ instead of the
                                ///< equation of state
  bool tension = false;         ///< a liquid has surface tension
  bool surfaceEnergy = false;   ///< surface tension is the gradient of a surface energy
                                ///< (core/fluid/laws/surface_energy.hpp)
  bool xsph = false, artificialViscosity = false;
  bool implicitViscosity = false;    ///< a liquid has viscosity and the scene selects the implicit solver
  bool flowLaw = false;              ///< viscosity depends on the shear rate (core/flow/rheology/)
  bool bulkDamping = false;          ///< liquids with volume viscosity
  bool viscosityCorrection = false;  ///< viscosity is corrected for the arrangement of the particles
  bool solid = false;                ///< some particle is or can become solid: bonds, elastic forces
  bool elastic = false;              ///< some solid has bonds
  bool rigid = false;                ///< some particle is or can become part of a rigid piece (core/rigid/)
  bool substeps = false;             ///< solids may take several substeps in a step
  int mostSubsteps = 1;
  bool plastic = false;      ///< a material yields
  bool fracture = false;     ///< bonds of a material break
  bool freezing = false;     ///< liquid can solidify at run time: bonds store a reference at both ends
  bool welding = false;      ///< separate solids of weldable materials can touch; bonds store a reference at
                             ///< both ends, as with freezing
  bool contact = false;      ///< unbonded solids can touch: several solid bodies, pieces of one, or freezing
  bool bodyContact = false;  ///< elastic solids of different bodies can touch (core/contact/body_contact.hpp)
  bool rareContact = false;  ///< contact limits the step only while it acts: solids have substeps, and only
                             ///< frozen pieces of one body can touch
  bool heat = false;         ///< temperature changes: conduction, hot obstacles, sources
  bool melting = false;      ///< a material melts: liquid fraction, phase
  bool lamps = false;        ///< lamps, lasers or heated regions (core/heat/sources/)
  bool buoyancy = false;     ///< buoyancy of liquids with expansion (core/scene/buoyancy.hpp)
  bool phaseDensity = false;        ///< the rest density of a particle changes with its phase or temperature
  bool tensionTable = false;        ///< surface tension depends on the temperature
  bool contactAngle = false;        ///< some contact angle is not 90 degrees
  bool evaporation = false;         ///< liquids lose mass at free surfaces
  bool mushDrag = false;            ///< drag between solidus and liquidus
  bool contactConductance = false;  ///< heat passes between bodies with a given conductance
  bool rigidify = false;            ///< parts of elastic solids that do not deform move as rigid pieces
  bool surfaceHeat = false;         ///< convection or radiation to the ambient
  bool sleep = false;               ///< solids at rest sleep: their sums are skipped (core/sleep/)
  bool pieceSleep = false;          ///< rigid pieces at rest sleep (core/rigid/sleeping_pieces.hpp)
  bool rollingFriction = false;     ///< rigid pieces have rolling friction (core/rigid/contact/rolling.hpp)
  bool breaking = false;            ///< rigid pieces break in impacts (core/rigid/breaking/)
  bool pieceWelding = false;        ///< hot rigid pieces that touch join (core/rigid/welding/)
  bool neighbours = false;          ///< some term sums over unbonded neighbours
  bool surface = false;             ///< surfels on the continuum bodies
  bool emitters = false;
  bool oriented = false;         ///< oriented bodies (core/oriented/)
  bool orientedContact = false;  ///< oriented particles can touch continuum bodies
  bool sheet = false;            ///< sheets (core/sheet/)
  bool uniform = false;  ///< all particles are liquid of one material with constant parameters, so pair sums
                         ///< read less (terms/uniform_forces.hpp)
  bool sheetContact = false;  ///< sheets and oriented particles can touch
  bool bodyTypes() const { return oriented || sheet; }
  std::vector<std::string> why;  ///< one line per active module: "heat: obstacle 'plate' has a temperature"
};

/// Returns true if a body of the material is solid at this initial temperature (K).
inline bool solidAt(const Material& m, double T) {
  return m.canBeSolid() && (m.melts() ? T < m.liquidus : !m.liquidAtStart);
}

/// Returns true if some particles of the material are or can become liquid in a scene with these modules.
inline bool hasLiquid(const Modules& modules, const Material& m) {
  return modules.fluid && (!m.canBeSolid() || m.liquidAtStart || (m.melts() && modules.heat));
}

/// Returns true if the body is solid at the start.
inline bool solidAtStart(const Scene& s, const Body& b) {
  return solidAt(s.materials[static_cast<std::size_t>(b.material)], b.temperature);
}

}  // namespace thaw
