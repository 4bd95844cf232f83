// SPDX-License-Identifier: Apache-2.0
// The scene in SI units, as plain structs. io/scene reads the scene from TOML. Its table of keys gives the
// unit, range, default and documentation of every member. Nothing here depends on MPI or on a file format.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/scene/flow_law.hpp"
#include "core/scene/heat_sources.hpp"
#include "core/scene/oriented_body.hpp"
#include "core/scene/position_field.hpp"
#include "core/scene/shape.hpp"
#include "core/scene/sheet_body.hpp"

namespace thaw {

/// A material parameter with a solid and a liquid value, interpolated linearly (K05 3.3).
struct Blend {
  double solid = 0, liquid = 0;
  double at(double liquidFraction) const { return solid + (liquid - solid) * liquidFraction; }
};

struct Material {
  std::string name;
  SourcePlace where;
  double density = 1000;             // kg/m^3, at rest; of the liquid phase, if the phases differ
  double solidDensity = 0;           // kg/m^3, of the solid phase at rest; 0: `density`
  std::uint32_t colour = 0xdfe6ebu;  // colour of its surface, red | green << 8 | blue << 16
  // liquid
  Blend viscosity;                                        // Pa s
  std::vector<std::pair<double, double>> viscosityTable;  // (K, Pa s), interpolated logarithmically; replaces
                                                          // viscosity if not empty
  double surfaceTension = 0;                              // N/m
  TemperatureTable surfaceTensionTable;                   // (K, N/m), interpolated linearly; replaces
                                                          // surfaceTension if not empty
  double contactAngle = std::numbers::pi / 2;             // rad, of its liquid at walls
  double soundSpeed = 0;  // m/s, in the equation of state; 0: ten times the largest expected speed of the
                          // scene
  double xsph = 0;        // 1, velocity smoothing (XSPH)
  double artificialViscosity = 0;  // 1, Monaghan's alpha
  double bulkDamping = 0;          // 1, volume viscosity over (density * speed of sound * support radius)
  FlowLawSettings flowLaw;         // replaces viscosity if not Newtonian
  double expansion = 0;            // 1/K, volume expansion of the liquid, for its buoyancy
  TemperatureTable densityTable;   // (K, kg/m^3), of the liquid, interpolated linearly, for its buoyancy;
                                   // replaces expansion if not empty
  double expansionFrom = 0;        // K, temperature of `density`; 0: the ambient temperature
  Blend young;                     // Pa; a solid value > 0 allows the material to be solid
  Blend poisson{0.3, 0.3};         // 1
  ExtensionSettings law{.name = "green", .values = {}};  // in core/solid/laws/laws.hpp or an extension
  Blend yieldStrain{never, never};  // 1, gamma_yield: yield stress |dev sigma|/2G (OBH02; plasticity.hpp);
                                    // never: not plastic
  Blend creepRate{never, never};    // 1/s, gamma_creep: decay rate of the stress above yield; never:
                                    // instantaneous
  double hardening = 0;             // Pa, d(yield stress)/d(equivalent plastic strain)
  double maxPlasticStrain = never;  // 1, gamma_max: norm of the logarithmic plastic strain
  double volumeStiffness = 0;       // Pa, k_v of the volume force (MKN04)
  double hourglass = 1.25;          // 1, alpha of the penalty on zero-energy modes (G15); 1.25 also
                                    // compensates for the error of short waves (elastic.hpp)
  double breakStretch = never;      // 1, stretch above which a bond breaks
  double strength = never;          // Pa, tensile stress at which rigid pieces break; never: they do not
                                    // break
  double impactModulus = 0;         // Pa, Young's modulus for impacts of rigid pieces that break
  double damping = 0;               // 1/s, decay rate of velocity differences between bonded particles
  bool weld = false;                // solids of this material weld where they touch
  double weldTemperature = never;   // K, temperature above which touching rigid pieces join; never: they do
                                    // not join
  double weldTime = 0;              // s, contact time after which they join
  double friction = 0.3;            // 1, Coulomb, between separate solids
  double rollingFriction = 0;       // m, maximum moment over normal force at a contact of rigid pieces
  double restitution = 0.5;         // 1, of contacts between separate solids
  // heat
  Blend conductivity{0, 0};                  // W/(m K)
  Blend heatCapacity{1000, 1000};            // J/(kg K)
  double latentHeat = 0;                     // J/kg
  double solidus = never, liquidus = never;  // K; never: does not melt
  double hysteresis = 0;  // 1, liquid freezes at a liquid fraction below this, and solid melts above 1 minus
                          // this
  double heatSource = 0;  // W/kg
  double emissivity = 0;  // 1, radiation from free surfaces to the ambient
  double convection = 0;  // W/(m^2 K), from free surfaces to the ambient
  double contactConductance = never;  // W/(m^2 K), at faces with other bodies; never: perfect contact
  TemperatureTable evaporation;       // (K, kg/(m^2 s)), from free surfaces of its liquid; empty: none
  double evaporationHeat = 0;         // J/kg, latent heat of evaporation
  double mushDrag = 0;                // kg/(m^3 s), Carman-Kozeny's coefficient between solidus and liquidus
  double absorptivity = 1;            // 1, absorbed fraction of the light of lamps and lasers
  double paperDiffusivity = 0;        // m^2/s, k_heat of K05, for heat model "paper"
  bool liquidAtStart = false;         // only for materials that do not melt: initial phase
  bool melts() const { return solidus < never; }
  bool yields() const { return yieldStrain.solid < never; }
  bool isRigid() const { return std::string_view(law.name) == "rigid"; }  // bodies of core/rigid/
  bool canBeSolid() const { return young.solid > 0 || isRigid(); }
};

// ---- bodies -----------------------------------------------------------------------------------------------
enum class Packing { Lattice, Relaxed };

struct Body {
  std::string name;
  SourcePlace where;
  Shape shape;
  int material = 0;                // index into Scene::materials
  Vec3d velocity{};                // m/s
  Vec3d spin{};                    // rad/s, about the centre of the body's bounding box
  double temperature = 293.15;     // K
  Vec3d temperatureGradient{};     // K/m, adds a temperature that is zero at the centre of the bounding box
  VelocityField velocityField;     // added to velocity and spin
  PositionField temperatureField;  // K, replaces temperature
  Packing packing = Packing::Lattice;
  std::vector<Shape> clamp;  // particles in one of these at the start are fixed in place
};

struct Emitter {
  std::string name;
  SourcePlace where;
  bool disc = true;                     // disc of this radius, else rectangle of this size
  double radius = 0.05;                 // m
  double width = 0.1, depth = 0.1;      // m
  Vec3d centre{}, direction{0, 0, -1};  // m, centre of the opening; 1, direction of the flow
  double speed = 1;                     // m/s
  double rate = 0;                      // kg/s; 0: density * area * speed
  double temperature = 293.15;          // K
  VelocityField velocityField;          // over the opening, added to the flow; no component along `direction`
  PositionField temperatureField;       // K, over the opening, replaces temperature
  int material = 0;
  double start = 0, end = never;  // s
};

enum class ObstacleLook { Glass, Solid };

struct Obstacle {
  std::string name;
  SourcePlace where;
  Shape shape;
  std::optional<double> temperature;  // K; none: the obstacle is insulating
  double conductance = never;         // W/(m^2 K); never: the surface has the obstacle's temperature
  double friction = 0.3;              // 1, Coulomb friction of solids
  double restitution = 0.5;           // 1, of solids
  bool slip = false;                  // liquids slip freely; else they stick
  double contactAngle = never;        // rad, of liquids at it; never: the material's angle
  std::vector<Keyframe> motion;
  double until = never;                     // s, the obstacle disappears at this time
  ObstacleLook look = ObstacleLook::Glass;  // in pictures
  std::uint32_t colour = 0xc8c1bc;          // red | green << 8 | blue << 16
};

/// Drives particles anywhere in the domain to a temperature, as in K05's freezing while pouring.
struct Thermostat {
  SourcePlace where;
  int material = -1;            // index into Scene::materials; -1: all
  double start = 0, over = 0;   // s, the enthalpy changes linearly over this time; over 0: within one step
  double temperature = 293.15;  // K
};

enum class Side { Open, Wall, Periodic };

struct Domain {
  Vec3d min{-1, -1, -1}, max{1, 1, 1};        // m
  std::array<std::array<Side, 2>, 3> side{};  // [axis][0 low, 1 high]
  Vec3d gravity{0, 0, -9.81};                 // m/s^2
  Vec3d buoyantGravity{};                     // m/s^2, acts only on density differences (buoyancy.hpp)
  double ambient = 293.15;                    // K, for convection and radiation
  bool holds(const Vec3d& x) const {
    for (int a = 0; a < 3; a++)
      if (!(x[a] >= min[a] && x[a] < max[a])) return false;
    return true;
  }
};

// ---- numerics ---------------------------------------------------------------------------------------------
enum class KernelKind { WendlandC2, Mcg03, CubicSpline };
enum class Precision { Single, Double };      // precision of pair sums; the state itself is double
enum class PairForm { Consistent, Printed };  // Printed: the sums of K05 as printed
enum class DensityForm { Summation, Continuity, Plain };
enum class EquationOfState { Linear, Tait };
enum class PressureSolver { StateEquation, Incompressible };
enum class ViscosityForm { Pairwise, Laplacian };
enum class ViscositySolver { Explicit, Implicit };
enum class TensionForm {
  Pairwise,
  ColourField,
  SurfaceEnergy,
  Curvature
};  // ColourField: as printed in MCG03/K05
enum class Buoyancy {
  Automatic,
  Boussinesq,
  Density
};  // Boussinesq: gravity acts only on density differences; Density: the weight also acts (buoyancy.hpp)
enum class HeatModel { Enthalpy, Paper };
enum class Conduction {
  Normalised,
  Plain
};  // normalisation of the sum over neighbours: second moment of the lattice, or of the integral
enum class OverlapRule { Error, Keep, RemoveLater, RemoveEarlier };

enum class Quality { Preview, Standard, Reference };  // presets of numerical choices (quality.hpp)

struct Numerics {
  double support = 2.0;      // 1, support radius over spacing
  double bondSupport = 1.7;  // 1, longest bond of solids over spacing; not above `support`
  KernelKind kernel = KernelKind::WendlandC2;
  Precision precision = Precision::Single;
  Precision elasticPrecision = Precision::Double;
  PairForm pressure = PairForm::Consistent;
  DensityForm density = DensityForm::Summation;
  bool correctedGradients = true;  // for the continuity form
  double densityDiffusion = 0.1;   // 1, for the continuity form: delta of MC09
  double shifting = 0;             // 1, shifting velocity towards lower concentration over c h |grad C|
  EquationOfState eos = EquationOfState::Linear;
  double tensileLimit = 0;  // 1, fraction of negative pressure that is kept; 0: pressure is clamped at 0
  PressureSolver solver = PressureSolver::StateEquation;
  double densityTolerance = 1e-4;     // 1, mean residual compression of a step in the incompressible solver
  double divergenceTolerance = 1e-3;  // 1, mean residual rate of compression times the step
  std::int64_t maxIterations = 100;   // iteration limit of each of the two pressure solves
  ViscosityForm viscosity = ViscosityForm::Pairwise;
  bool viscosityCorrection = false;  // for the pairwise form
  ViscositySolver viscositySolver = ViscositySolver::Explicit;
  double viscosityTolerance = 1e-3;        // 1, error of the implicit solver's velocity change
  std::int64_t viscosityIterations = 200;  // iteration limit per step
  TensionForm tension = TensionForm::SurfaceEnergy;
  Buoyancy buoyancy = Buoyancy::Automatic;  // thermal, for materials with expansion
  HeatModel heat = HeatModel::Enthalpy;
  Conduction conduction = Conduction::Normalised;
  bool selfContact = true;        // pieces of one solid collide with each other
  double maxDensityError = 0.01;  // 1, maximum compression for the automatic sound speed
  OverlapRule overlap = OverlapRule::Error;
  // Time step factors (docs/validation/stability.md, row 10).
  double fixedStep = 0;    // s; 0: the largest step that the limits allow
  double maxStep = never;  // s
  double cflSound = 0.4, cflViscous = 0.8, cflHeat = 0.8, cflElastic = 0.4, cflTension = 0.25,
         cflAcceleration = 0.25;
  int elasticSubsteps = 0;  // maximum number of substeps of solids in a step. 0: automatic: 4
                            // (incompressible: 2) if there is liquid and solids cannot touch, else 1
  // Sleep (core/sleep/).
  double sleepSpeed = 0;       // m/s, speed below which a solid is at rest; 0: nothing sleeps
  double sleepAfter = 0.05;    // s, rest time before a solid sleeps
  double sleepHeating = 0.01;  // K/s, heating rate above which a solid is awake
  double rigidify = 0;         // 1/s, rate of strain below which elastic solids move as rigid pieces; 0: off
  // Stability monitor (core/simulation/monitor/).
  std::int64_t retryEvery = 100;    // steps between snapshots in memory; 0: none
  std::int64_t retries = 4;         // maximum number of successive rollbacks; each halves the step
  double watchSpeed = 10;           // 1, speed limit over the expected speed of the scene
  double watchDensity = 2;          // 1, limit of a liquid's relative density
  double watchStep = 1e-4;          // 1, lower limit of the step over the materials' step limit; 0: not
                                    // monitored
  double watchInverted = 0.1;       // 1, limit of the fraction of inverted solid particles
  double watchEnergy = 0.5;         // 1, limit of the energy residual over the energy scale
  double plasticRereference = 0.2;  // 1, norm of plastic strain above which the reference configuration is
                                    // updated
};

// ---- surface (K05 section 4) ------------------------------------------------------------------------------
enum class SmoothingForm {
  Sphere,
  Plane
};  // Plane: as in K05; Sphere: no force if surfels lie on a sphere (co-circularity, ST92)
enum class MergeRule {
  Liquid,
  All,
  None
};  // components that merge on contact; surfaces of other components stay separate
enum class SurfelSource {
  Automatic,
  Particles
};  // Automatic: from the mesh or shape of bodies that have one (isSampled)

struct SurfaceSettings {
  bool on = false;             // the scene has a table [surface]
  double spacing = 0;          // m, target spacing of surfels; 0: half the spacing of particles
  double support = 3;          // 1, h_ss over the spacing of surfels
  double particleSupport = 2;  // 1, h_ps over the support radius of the particles
  SurfelSource source = SurfelSource::Automatic;
  // Times of updates.
  std::int64_t everySteps = 0;  // steps between updates; 0: only at frames and after everyMove
  double everyMove = 0.25;  // 1, update after a particle has moved by this fraction of the support radius; 0:
                            // never
  // Relaxation in an update. Weights (1) of the four forces (k of K05).
  double implicit = 0.5, attract = 0.05, smooth = 0.4, repel = 0.3;
  SmoothingForm smoothing = SmoothingForm::Sphere;
  double isoLevel = 0.5;         // 1, I of the colour field
  double leastLevel = 0.2;       // 1, I_min of the implicit constraint
  double damping = 1;            // 1, alpha of the integration
  std::int64_t iterations = 40;  // iteration limit per update
  double stop = 0.01;        // 1, a surfel stops if it and its neighbours move less than this fraction of its
                             // spacing
  double adapt = 0;          // 1, smallest spacing on curved surfaces over the target spacing; 0: uniform
  double enforceVolume = 1;  // 1, weight of the force that keeps a liquid component's volume equal to its
                             // particles' volume; 0: none
  MergeRule merge = MergeRule::Liquid;
  double linkLength = 1.5;  // spacings, link radius: particles of one component are connected up to this
                            // distance
  SourcePlace where;        // the table
  std::map<std::string, SourcePlace> places;  // positions of the keys present in the scene
};

struct Camera {
  bool fitted = true;
  Vec3d from{1, -1, 1}, at{};  // m
  double fieldOfView = 0.6;    // rad, vertical
};

/// Display of drops of one or two particles in pictures of a surface: ellipsoids along their motion, spheres,
/// nothing, or their own surfels.
enum class Spray { Ellipsoids, Spheres, Hide, Surfels };

/// Distant light of pictures.
struct PictureLight {
  Vec3d direction{0, 0, 1};         // from the scene to the light, any length
  std::uint32_t colour = 0xffffff;  // as Material::colour
  double strength = 1;              // 1, relative to the sun of pictures without lights
  double size = 0.14;               // rad, subtended angle
};

struct Output {
  double every = 0.04;     // s of simulated time between frames
  double ledgerEvery = 0;  // s of simulated time between extra rows of ledger.csv; 0: only at frames
  std::vector<std::string> fields{"velocity", "temperature", "liquid"};
  SourcePlace fieldsWhere;  // without a line: the fields are defaults
  double checkpoint = 600;  // s of wall-clock time
  bool piecesByRank = false;
  Camera camera;
  std::string colour;  // field of the pictures; empty: temperature if the scene has heat, sheet colours if
                       // there are only sheets, else speed
  std::optional<double> colourMin, colourMax;  // SI units of the field
  std::optional<std::uint32_t> background;     // pictures; as Material::colour; none: a pale sky
  std::optional<std::uint32_t> backgroundTop;  // colour at the top of pictures; none: as `background`
  std::vector<PictureLight> lights;            // pictures; none: the sun
  double ambient = 1;                          // 1, strength of the sky's light in pictures
  std::optional<Vec3d> sun;                    // direction from the scene to the sun in pictures, any length;
                                               // none: over the camera's left shoulder
  Spray spray = Spray::Ellipsoids;             // pictures
  int width = 1280, height = 960;
};

/// Expected motion of a scene, for the automatic sound speed; set at set-up
/// (core/simulation/setup/expected_motion.hpp).
struct ExpectedMotion {
  double start = 0;                          // m/s, fastest particle of the bodies at the start
  double emitted = 0;                        // m/s, fastest particle of the emitters
  double driven = 0;                         // m/s, fastest point of the moving obstacles
  double lift = 0;                           // m, largest rise of any obstacle point against gravity
  double column = 0;                         // m, highest column of liquid that emitters can fill
  double coldest = never, hottest = -never;  // K, of bodies and emitters at the start
  std::string startBy, emittedBy, drivenBy;  // names
};

struct Scene {
  std::string title, file, text;  // text: all input, for the record in the output
  double spacing = 0.01;          // m, particle spacing
  double end = 1;                 // s
  Quality quality = Quality::Standard;
  std::uint64_t seed = 1;
  double fallHeight = never;  // m, largest height of fall, for the automatic sound speed; set from the bodies
                              // at set-up
  ExpectedMotion expected;    // set with fallHeight
  Domain domain;
  Numerics numerics;
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<OrientedBody> oriented;
  std::vector<SheetBody> sheets;
  std::vector<Emitter> emitters;
  std::vector<Obstacle> obstacles;
  std::vector<Thermostat> thermostats;
  std::vector<Lamp> lamps;
  std::vector<Laser> lasers;
  std::vector<HeatedRegion> heatedRegions;
  std::vector<ExtensionSettings> extensions;
  SurfaceSettings surface;
  Output output;
};

/// Returns true if the scene has continuum particles, at the start or later. Otherwise, it has only oriented
/// bodies and sheets.
inline bool hasContinuum(const Scene& s) { return !s.bodies.empty() || !s.emitters.empty(); }

/// Returns the target spacing (m) of an oriented body's particles, or of a generated sheet's vertices. If the
/// body has none, it is the scene's spacing.
inline double spacingOf(const Scene& s, const OrientedBody& b) {
  return b.spacing > 0 ? b.spacing : s.spacing;
}
inline double spacingOf(const Scene& s, const SheetBody& b) { return b.spacing > 0 ? b.spacing : s.spacing; }
/// Returns the target spacing of surfels (m).
inline double surfelSpacing(const Scene& s) {
  return s.surface.spacing > 0 ? s.surface.spacing : 0.5 * s.spacing;
}

}  // namespace thaw
