// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/start_fields.hpp"

#include <algorithm>
#include <cmath>

#include "core/domain/emit.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/scene/field_values.hpp"

namespace thaw {
namespace {

constexpr std::size_t fieldsOfBody = 4;  // velocity x, y, z and temperature

const PositionField& fieldOf(const Body& b, std::size_t k) {
  return k < 3 ? b.velocityField.component[k] : b.temperatureField;
}

bool allowed(std::size_t field, double value) {
  return field < 3 ? isStartSpeed(value) : isStartTemperature(value);
}

bool varies(const Body& b, bool relaxed) {
  if (b.velocityField.given() || b.temperatureField) return !relaxed || b.packing == Packing::Relaxed;
  return relaxed && b.packing == Packing::Relaxed &&
         (!(b.spin == Vec3d{}) || !(b.temperatureGradient == Vec3d{}));
}

/// Invalid values of one body's fields on this rank: their number, and the particle with the lowest id.
struct BadValues {
  std::int64_t count[fieldsOfBody]{};
  double firstId[fieldsOfBody] = {never, never, never, never};
  Vec3d place[fieldsOfBody]{};
};

/// Returns the image of x across periodic sides nearest to its lattice point.
Vec3d placeInBody(const CellGrid& g, const SampleLattice& l, std::uint64_t number, Vec3d x) {
  const Vec3d latticePoint = l.at(static_cast<std::int64_t>(number));
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) x[a] -= g.period[a] * std::round((x[a] - latticePoint[a]) / g.period[a]);
  return x;
}

void look(const Body& b, const Vec3d& x, std::uint64_t number, BadValues& bad) {
  for (std::size_t k = 0; k < fieldsOfBody; k++) {
    const PositionField& f = fieldOf(b, k);
    if (!f || allowed(k, f.value(x))) continue;
    bad.count[k]++;
    if (static_cast<double>(number) < bad.firstId[k])
      bad.firstId[k] = static_cast<double>(number), bad.place[k] = x;
  }
}

/// Returns one sentence about a field with invalid values at `count` particles of all ranks. Collective.
std::string problemOf(const PositionField& f, std::int64_t count, double firstId, const Vec3d& place,
                      Reducer& all) {
  double first = -firstId;
  all.maximum({&first, 1});
  double at[3];
  for (int a = 0; a < 3; a++) at[a] = firstId == -first ? place[a] : -never;
  all.maximum(at);
  const Vec3d x{at[0], at[1], at[2]};
  return badValue(f, f.value(x), x) +
         (count > 1 ? ", a particle (" + std::to_string(count) + " in all)" : ", a particle");
}

/// Throws if a field has an invalid value at a particle of any rank. Collective.
void raiseBadValues(const Scene& s, const std::vector<BadValues>& bad, Reducer& all) {
  std::vector<std::int64_t> counts;
  for (const BadValues& b : bad) counts.insert(counts.end(), b.count, b.count + fieldsOfBody);
  all.sum(counts);
  SceneProblems problems;
  for (std::size_t k = 0; k < counts.size(); k++) {
    const std::size_t b = k / fieldsOfBody, f = k % fieldsOfBody;
    if (counts[k] == 0) continue;
    const PositionField& field = fieldOf(s.bodies[b], f);
    const std::string problem = problemOf(field, counts[k], bad[b].firstId[f], bad[b].place[f], all);
    problems.add(field.where, problem + "; " + (f < 3 ? expectedSpeeds : expectedTemperatures));
  }
  problems.raise();
}

}  // namespace

Vec3d middleOf(const SignedDistance& shape) {
  const Bounds b = shape.bounds();
  return (b.min + b.max) * 0.5;
}

Vec3d startVelocity(const Body& b, const Vec3d& centre, const Vec3d& x) {
  const Vec3d v = b.velocity + cross(b.spin, x - centre);
  return b.velocityField.given() ? v + velocityOf(b.velocityField, centre, x) : v;
}

double startTemperature(const Body& b, const Vec3d& centre, const Vec3d& x) {
  return (b.temperatureField ? b.temperatureField.value(x) : b.temperature) +
         dot(b.temperatureGradient, x - centre);
}

void assignStartFields(World& w, const Shapes& shapes, Reducer& all, bool relaxed) {
  const Scene& s = w.scene;
  Continuum& p = w.particles;
  std::vector<std::uint8_t> wanted(s.bodies.size() + s.emitters.size(), 0);
  for (std::size_t b = 0; b < s.bodies.size(); b++) wanted[b] = varies(s.bodies[b], relaxed);
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end()) return;
  const std::vector<SampleLattice> lattices = bodyLattices(s, shapes);
  std::vector<Vec3d> centres(s.bodies.size());
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    if (wanted[b]) centres[b] = middleOf(*shapes[b]);
  std::vector<BadValues> bad(s.bodies.size());
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::size_t b = p.body[i];
    if (!wanted[b]) continue;
    const Body& body = s.bodies[b];
    const Vec3d x = placeInBody(w.grid, lattices[b], numberOf(p.id[i]), p.position[i]);
    look(body, x, numberOf(p.id[i]), bad[b]);
    if (!p.clamped.active || p.clamped[i] != fixedInPlace) p.velocity[i] = startVelocity(body, centres[b], x);
    const double T = startTemperature(body, centres[b], x);
    if (p.temperature.active) p.temperature[i] = T;
    if (p.enthalpy.active) p.enthalpy[i] = ledgerEnthalpy(s.numerics.heat, s.materials[p.material[i]], T);
  }
  raiseBadValues(s, bad, all);
  setPhase(s, w.modules, p, 0, p.owned);
  setStartMasses(lattices, p);
}

void setStartMasses(std::span<const SampleLattice> lattices, Continuum& p) {
  if (!p.restDensity.active) return;
  for (std::size_t i = 0; i < p.owned; i++)
    p.mass[i] = lattices[p.body[i]].mass(static_cast<std::int64_t>(numberOf(p.id[i])), p.restDensity[i]);
}

}  // namespace thaw
