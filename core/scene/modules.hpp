// Which parts of the model a scene needs. A module that is off allocates no field, runs no loop and sends no
// byte.
#pragma once
#include <string>
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

struct Modules {
  bool fluid = false;           ///< some particle is, or can become, liquid: density, pressure, viscosity
  bool continuity = false;      ///< the flow carries the density of liquids
  bool corrected = false;       ///< and by corrected gradients
  bool shifting = false;        ///< particles of liquids are moved to emptier places
  bool incompressible = false;  ///< pressure by the solver of core/fluid/incompressible/ instead of the
                                ///< equation of state
  bool tension = false;         ///< a liquid with surface tension
  bool surfaceEnergy = false;   ///< and it is an energy of the surface (core/fluid/surface_energy.hpp)
  bool xsph = false, artificialViscosity = false;
  bool implicitViscosity = false;  ///< a liquid with viscosity, and the scene asks for the implicit solver
  bool solid = false;              ///< some particle is, or can become, solid: bonds, elastic forces
  bool substeps = false;           ///< solids may take several steps in one of the scene
  int mostSubsteps = 1;
  bool plastic = false;   ///< a material yields
  bool fracture = false;  ///< a material's bonds break
  bool freezing = false;  ///< liquid can become solid while running: bonds have their own reference on both
                          ///< ends
  bool welding = false;   ///< separate solids of materials that weld can meet: bonds as with freezing
  bool contact = false;   ///< unbonded solids can meet: several solid bodies, pieces, freezing
  bool heat = false;      ///< temperature changes: conduction, hot obstacles, sources
  bool melting = false;   ///< a material melts: liquid fraction, phase
  bool surfaceHeat = false;  ///< convection or radiation to the ambient
  bool sleep = false;        ///< solids at rest are held, and their sums not formed again (core/sleep/)
  bool neighbours = false;   ///< any sum over unbonded neighbours
  bool surface = false;      ///< surfels on the continuum bodies
  bool emitters = false;
  bool oriented = false;  ///< oriented bodies (core/oriented/)
  bool meeting = false;   ///< oriented particles can touch continuum bodies
  bool sheet = false;     ///< sheets (core/sheet/)
  bool uniform = false;  ///< all there is is liquid of one material whose parameters are the same everywhere:
                         ///< pair sums read less (terms/uniform_forces.hpp)
  bool draping = false;  ///< sheets and oriented particles can touch
  bool kinds() const { return oriented || sheet; }
  std::vector<std::string> why;  ///< a line for each module that is on: "heat: obstacle 'plate' has a
                                 ///< temperature"
};

Modules modulesOf(const Scene& scene);

/// Is a body of the material solid at the start, at this temperature (K)?
bool solidAt(const Material& material, double T);

/// Is it solid at the start?
inline bool solidAtStart(const Scene& s, const Body& b) {
  return solidAt(s.materials[static_cast<std::size_t>(b.material)], b.temperature);
}

}  // namespace thaw
