// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/pair_sums/records.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/fluid/laws/sticking_viscosity.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/materials/rest_density.hpp"
#include "core/materials/state_equation.hpp"
#include "core/particles/step_velocity.hpp"

namespace thaw {
namespace {

template<class Real> struct Four { Real a, b, c, d; };

// SIMD pairs of baseline instruction sets. Packing takes a tenth of a step, so it is vectorised.
typedef double Pair __attribute__((vector_size(16)));
typedef float Quad __attribute__((vector_size(16)));
typedef std::uint32_t Words __attribute__((vector_size(16)));
Pair pairAt(const double* p) {
  Pair v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Fixed-point positions: fixedPoint() of x and y at once. The fourth word is 0.
struct FixedPlaces {
  Pair originXY, scaleXY;
  double originZ, scaleZ;
  explicit FixedPlaces(const CellGrid& g) : originXY{g.origin.x, g.origin.y}, originZ(g.origin.z) {
    scaleZ = fixedUnitsPerSupport / g.support;
    scaleXY = Pair{scaleZ, scaleZ};
  }
  Words operator()(const Vec3d& at) const {
    const Pair xy = (pairAt(&at.x) - originXY) * scaleXY + fixedPointMagic,
               z = Pair{(at.z - originZ) * scaleZ + fixedPointMagic, 0};
    return __builtin_shufflevector(reinterpret_cast<Words>(xy), reinterpret_cast<Words>(z), 0, 2, 4, 6);
  }
};

/// Velocity and a fourth value in single precision.
Quad quad(const Vec3d& v, float last) {
  typedef float Two __attribute__((vector_size(8)));
  const Two xy = __builtin_convertvector(pairAt(&v.x), Two);
  return Quad{xy[0], xy[1], static_cast<float>(v.z), last};
}
void put(Four<float>& to, const Vec3d& v, float last) {
  const Quad q = quad(v, last);
  std::memcpy(&to, &q, sizeof q);
}
void put(Four<double>& to, const Vec3d& v, double last) { to = {v.x, v.y, v.z, last}; }

template<class Real> Four<Real>* rows(AlignedVector<std::byte>& bytes) {
  return reinterpret_cast<Four<Real>*>(bytes.data());
}

void resizeBytes(AlignedVector<std::byte>& v, std::size_t rows, std::size_t each) {
  makeRoom(v, rows, each);
  v.resize(rows * each);
}

MaterialParameters localParameters(HeatModel model, const Material& m, double f, double T) {
  return {viscosityAt(m, f, T), conductivityOf(model, m, f)};
}

/// Returns true if pair sums need more than positions. If not, neighbours are listed only for the initial
/// bonds.
bool sumsOverPairs(const Modules& m) { return m.fluid || m.heat || m.contact; }

template<class Real>
void packPlace(const CellGrid& grid, const FixedPlaces& fixedPlace, const Vec3d& at, double volume,
               Four<Real>& to) {
  if constexpr (sizeof(Real) == 8) {
    const Vec3d d = at - grid.origin;
    const double perSupport = 1 / grid.support;
    to = {d.x * perSupport, d.y * perSupport, d.z * perSupport, volume};
  } else {
    Words words = fixedPlace(at);
    words[3] = std::bit_cast<std::uint32_t>(static_cast<float>(volume));
    std::memcpy(&to, &words, sizeof words);
  }
}

/// Returns the factor in a column that stores factors minus 1; 1 if the column is not active.
double factorOf(const Column<float>& correction, std::size_t i) {
  return correction.active ? 1 + static_cast<double>(correction[i]) : 1;
}

template<class Real>
void packAs(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end, PairRecords& r) {
  const CellGrid grid = x.grid;
  const double h = grid.support;
  const bool carried = x.modules.continuity, surfaces = p.atSurface.active;
  const double stiffness = carried ? x.liquids[0].stiffness : 1;
  const bool sums = sumsOverPairs(x.modules);
  const bool heat = x.modules.heat, melting = x.modules.melting, surface = !r.surface.empty(),
             uniform = x.modules.uniform, byPhase = p.restDensity.active,
             pairwise = x.scene.numerics.viscosity == ViscosityForm::Pairwise;
  r.constant.clear();
  r.volumePerMass.clear();
  for (const Material& m : x.scene.materials) {
    r.constant.push_back(localParameters(x.scene.numerics.heat, m, restFraction(m), 293));
    r.volumePerMass.push_back(1 / (m.density * h * h * h));
  }
  Four<float>* fixed = rows<float>(r.fixed);
  const FixedPlaces fixedPlace(grid);
  std::uint16_t* const coarse[3] = {r.coarse[0].data(), r.coarse[1].data(), r.coarse[2].data()};
  for (std::size_t i = begin; i < end; i++) {
    const std::uint16_t k = p.material[i];
    const Material& m = x.scene.materials[k];
    const Vec3d& at = p.position[i];
    const double V = byPhase ? p.mass[i] / (p.restDensity[i] * h * h * h) : p.mass[i] * r.volumePerMass[k];
    Words positionVolume = fixedPlace(at);
    for (int a = 0; a < 3; a++) coarse[a][i] = coarsePosition(positionVolume[a]);
    const double marked = uniform && surfaces && p.atSurface[i] ? -V : V;
    positionVolume[3] = std::bit_cast<std::uint32_t>(static_cast<float>(marked));
    std::memcpy(&fixed[i], &positionVolume, sizeof positionVolume);
    if constexpr (sizeof(Real) == 8)
      packPlace(grid, fixedPlace, at, marked, rows<double>(r.positionVolume)[i]);
    if (!sums) continue;
    const StepVelocity moved = stepVelocity(p, i, x.substeps);
    if (carried)
      packPlace(grid, fixedPlace, at - moved.all * (0.5 * x.elapsed), marked, rows<Real>(r.middle)[i]);
    if (uniform && !surface) {
      put(rows<Real>(r.velocityViscosity)[i], moved.flow,
          carried ? static_cast<Real>(p.compression[i])
          : heat  ? static_cast<Real>(p.temperature[i])
                  : Real(0));
      continue;
    }
    const double f = melting                ? static_cast<double>(p.liquid[i])
                     : p.phase[i] == Liquid ? 1
                                            : 0,
                 T = heat ? p.temperature[i] : 0;
    const MaterialParameters local = m.melts() || (heat && !m.viscosityTable.empty())
                                         ? localParameters(x.scene.numerics.heat, m, f, T)
                                         : r.constant[k];
    const double viscosity = local.viscosity * factorOf(p.viscosityCorrection, i);
    put(rows<Real>(r.velocityViscosity)[i], moved.flow,
        static_cast<Real>(pairwise ? stickingViscosity(viscosity, f) : viscosity));
    const bool atSurface = surfaces && p.atSurface[i];
    const double signedLiquid = atSurface ? -f : f;
    if (!r.pressurePhaseHeat.empty())
      rows<Real>(r.pressurePhaseHeat)[i] = {
          carried ? static_cast<Real>(p.compression[i] * (x.liquids[k].stiffness / stiffness)) : Real(0),
          static_cast<Real>(signedLiquid), static_cast<Real>(T),
          static_cast<Real>(local.conductivity * factorOf(p.conductionCorrection, i))};
    if (surface)
      rows<Real>(r.surface)[i] = {
          static_cast<Real>(x.liquids[k].rootTension * f), Real(p.phase[i] == Solid),
          static_cast<Real>(
              (atSurface ? artificialAtSurface(x.liquids[k], local.viscosity) : x.liquids[k].artificial) * f),
          static_cast<Real>(m.xsph * f)};
  }
}

template<class Real> Four<Real>* places(PairRecords& r) {
  return rows<Real>(sizeof(Real) == 4 ? r.fixed : r.positionVolume);
}

bool isFixedSolid(const Continuum& p, std::size_t i) {
  return p.phase[i] == Solid && p.clamped.active &&
         (p.clamped[i] == fixedInPlace || p.clamped[i] == fixedByPiece);
}

/// Packs the pressure tensors of carried densities (terms/forces.hpp).
template<class Real>
void packTensors(const RecordContext& x, Continuum& p, std::size_t begin, std::size_t end, PairRecords& r) {
  const Numerics& n = x.scene.numerics;
  const bool uniform = x.modules.uniform, corrected = x.modules.corrected,
             recordsEnergy = !uniform && end <= p.owned;
  for (std::size_t i = begin; i < end; i++) {
    const double relativeDensity = static_cast<double>(p.relativeDensity[i]);
    const double pressure = relativeDensity > 0 ? pressureOf(n.eos, x.liquids[p.material[i]].stiffness,
                                                             relativeDensity, n.tensileLimit) /
                                                      (relativeDensity * relativeDensity)
                                                : 0;
    const Sym3f d = corrected ? p.correction[i] : Sym3f{};
    const auto of = [&](float a) { return static_cast<Real>(pressure * static_cast<double>(a)); };
    const Real xx = of(1 + d.xx), yy = of(1 + d.yy), zz = of(1 + d.zz);
    if (uniform) {
      places<Real>(r)[i].d = xx;
      rows<Real>(r.velocityViscosity)[i].d = yy;
      rows<Real>(r.pressureDiagonal)[i] = {zz, of(d.xy), of(d.xz), of(d.yz)};
      continue;
    }
    const Vec3f relief = p.relief.active ? p.relief[i] : Vec3f{};
    rows<Real>(r.pressureDiagonal)[i] = {xx, yy, zz, Real(relief.x)};
    rows<Real>(r.pressureOffDiagonal)[i] = {of(d.xy), of(d.xz), of(d.yz), Real(relief.y)};
    Four<Real>& pressurePhaseHeat = rows<Real>(r.pressurePhaseHeat)[i];
    pressurePhaseHeat.a = Real(relief.z);
    pressurePhaseHeat.b = std::abs(pressurePhaseHeat.b);  // the sign is for the density sums only
    if (p.relief.active && isFixedSolid(p, i)) pressurePhaseHeat.b = Real(-0.0);
    // For mush, drag uses the mean velocity and thus dissipates exactly the energy that it removes. In the
    // longer steps of other solids this is unstable, so their drag uses the velocity at the end of the step.
    if (!x.modules.melting && movedInSubsteps(p, i, x.substeps))
      put(rows<Real>(r.velocityViscosity)[i], p.velocity[i], rows<Real>(r.velocityViscosity)[i].d);
    if (recordsEnergy) p.interaction[i] += compressionOf(x, p, i, static_cast<double>(pressurePhaseHeat.b));
  }
}

/// Packs the pressure of one liquid (Modules::uniform) with summed density.
template<class Real>
void packUniformPressure(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                         PairRecords& r) {
  const Numerics& n = x.scene.numerics;
  const double stiffness = x.liquids[0].stiffness, tensileLimit = n.tensileLimit;
  const float* const relativeDensity = p.relativeDensity.data();
  Four<Real>* const to = x.modules.heat ? places<Real>(r) : rows<Real>(r.velocityViscosity);
  const auto loop = [&](EquationOfState eos) {
    for (std::size_t i = begin; i < end; i++) {
      const double f = static_cast<double>(relativeDensity[i]),
                   term = pressureOf(eos, stiffness, f, tensileLimit) / (f * f);
      to[i].d = f > 0 ? static_cast<Real>(term) : Real(0);
    }
  };
  if (n.eos == EquationOfState::Linear) loop(EquationOfState::Linear);
  else loop(EquationOfState::Tait);
}

template<class Real>
void packPressureAs(const RecordContext& x, Continuum& p, std::size_t begin, std::size_t end,
                    PairRecords& r) {
  if (x.modules.continuity) return packTensors<Real>(x, p, begin, end, r);
  const Numerics& n = x.scene.numerics;
  const bool uniform = x.modules.uniform, recordsEnergy = !uniform && end <= p.owned;
  Four<Real>* pressurePhaseHeat = rows<Real>(r.pressurePhaseHeat);
  if (uniform && n.pressure == PairForm::Consistent) return packUniformPressure<Real>(x, p, begin, end, r);
  Four<Real>* positionVolume = places<Real>(r);
  for (std::size_t i = begin; i < end; i++) {
    const double f = uniform ? 1 : static_cast<double>(pressurePhaseHeat[i].b),
                 relativeDensity = static_cast<double>(p.relativeDensity[i]);
    Real& term = uniform ? rows<Real>(r.velocityViscosity)[i].d : pressurePhaseHeat[i].a;
    if (f == 0 || relativeDensity <= 0) {
      term = Real(0);
      continue;
    }
    const double pressure = pressureOf(n.eos, x.liquids[p.material[i]].stiffness, relativeDensity,
                                       n.tensileLimit);
    if (recordsEnergy) p.interaction[i] += compressionOf(x, p, i, f);
    if (n.pressure == PairForm::Consistent) {
      term = static_cast<Real>(f * pressure / (relativeDensity * relativeDensity));
    } else {
      term = static_cast<Real>(f * pressure);
      positionVolume[i].d = static_cast<Real>(static_cast<double>(positionVolume[i].d) / relativeDensity);
    }
  }
}

}  // namespace

void resizeRecords(const RecordContext& x, std::size_t n, PairRecords& r) {
  const bool real64 = x.scene.numerics.precision == Precision::Double;
  const std::size_t each = real64 ? 32 : 16;
  resizeBytes(r.fixed, n + 1, 16);
  for (auto& c : r.coarse) {
    makeRoom(c, n + 32);  // the search reads up to 31 entries more
    c.resize(n + 32);
  }
  if (real64) resizeBytes(r.positionVolume, n + 1, each);
  const bool sums = sumsOverPairs(x.modules);
  if (sums) resizeBytes(r.velocityViscosity, n + 1, each);
  else r.velocityViscosity.clear();
  if (sums && !x.modules.uniform) resizeBytes(r.pressurePhaseHeat, n + 1, each);
  else r.pressurePhaseHeat = {};  // frees memory that the packing of bodies may have used
  const bool surface = x.modules.tension || x.modules.contact ||
                       (x.modules.artificialViscosity && !x.modules.uniform) || x.modules.xsph;
  if (surface) resizeBytes(r.surface, n + 1, each);
  else r.surface.clear();
  const bool tensors = x.modules.continuity ||
                       (x.modules.incompressible && x.scene.numerics.correctedGradients);
  if (x.modules.continuity) resizeBytes(r.middle, n + 1, each);
  if (tensors) resizeBytes(r.pressureDiagonal, n + 1, each);
  if (tensors && !x.modules.uniform) resizeBytes(r.pressureOffDiagonal, n + 1, each);
  if (x.modules.surfaceEnergy) resizeBytes(r.surfaceEnergyDerivatives, n + 1, each);
  for (AlignedVector<std::byte>* v :
       {&r.fixed, &r.middle, &r.positionVolume, &r.velocityViscosity, &r.pressurePhaseHeat, &r.surface,
        &r.pressureDiagonal, &r.pressureOffDiagonal, &r.surfaceEnergyDerivatives}) {
    const std::size_t record = v == &r.fixed ? 16 : real64 ? 32 : 16;
    if (!v->empty()) std::memset(v->data() + n * record, 0, record);
  }
  if (sums && x.modules.uniform && (x.modules.heat || x.modules.continuity)) {
    const double mark = x.modules.continuity ? dummyPressure : dummyTemperature;
    real64 ? void(rows<double>(r.velocityViscosity)[n].d = mark)
           : void(rows<float>(r.velocityViscosity)[n].d = static_cast<float>(mark));
  }
}

void packRecords(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                 PairRecords& r) {
  x.scene.numerics.precision == Precision::Double ? packAs<double>(x, p, begin, end, r)
                                                  : packAs<float>(x, p, begin, end, r);
}

void packPressure(const RecordContext& x, Continuum& p, std::size_t begin, std::size_t end, PairRecords& r) {
  x.scene.numerics.precision == Precision::Double ? packPressureAs<double>(x, p, begin, end, r)
                                                  : packPressureAs<float>(x, p, begin, end, r);
}

double compressionOf(const RecordContext& x, const Continuum& p, std::size_t i, double f) {
  // A carried density applies to the whole particle, even to solids near liquid.
  return x.modules.continuity ? compressionAt(x, p, i, 1, 1 + p.compression[i])
                              : compressionAt(x, p, i, f, static_cast<double>(p.relativeDensity[i]));
}

double compressionAt(const RecordContext& x, const Continuum& p, std::size_t i, double f,
                     double relativeDensity) {
  if (f == 0 || x.modules.incompressible) return 0;
  const Numerics& n = x.scene.numerics;
  return f * p.mass[i] / restDensityOf(p, x.scene.materials, i) *
         compressionEnergy(n.eos, x.liquids[p.material[i]].stiffness, relativeDensity, n.tensileLimit);
}

void packCohesion(const RecordContext& x, const Continuum& p, std::size_t begin, std::size_t end,
                  PairRecords& r) {
  const auto pack = [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = begin; i < end; i++)
      rows<Real>(r.surface)[i].a = static_cast<Real>(rootTensionOf(p, x.liquids, i));
  };
  x.scene.numerics.precision == Precision::Double ? pack(double{}) : pack(float{});
}

void packSurfaceEnergyDerivatives(const RecordContext& x, const Continuum& p, std::size_t begin,
                                  std::size_t end, PairRecords& r) {
  const auto pack = [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = begin; i < end; i++) {
      const Vec3d& u = p.surfaceEnergyByGradient[i];
      rows<Real>(r.surfaceEnergyDerivatives)[i] = {static_cast<Real>(u.x), static_cast<Real>(u.y),
                                                   static_cast<Real>(u.z),
                                                   static_cast<Real>(p.surfaceEnergyByColour[i])};
    }
  };
  x.scene.numerics.precision == Precision::Double ? pack(double{}) : pack(float{});
}

void setUnitPressure(const RecordContext& x, std::size_t n, PairRecords& r) {
  const auto set = [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = 0; i < n; i++) {
      rows<Real>(r.pressurePhaseHeat)[i] = {Real(1), Real(1), Real(0), Real(0)};
      rows<Real>(r.velocityViscosity)[i].d = Real(0);
    }
  };
  x.scene.numerics.precision == Precision::Double ? set(double{}) : set(float{});
}

void setExcessPressure(const RecordContext& x, const Continuum& p, PairRecords& r) {
  const auto set = [&](auto real) {
    using Real = decltype(real);
    for (std::size_t i = 0; i < p.size(); i++)
      rows<Real>(r.pressurePhaseHeat)[i].a = p.phase[i] == Liquid
                                                 ? std::max(static_cast<Real>(p.relativeDensity[i]) - Real(1),
                                                            Real(0))
                                                 : Real(0);
  };
  x.scene.numerics.precision == Precision::Double ? set(double{}) : set(float{});
}

}  // namespace thaw
