// SPDX-License-Identifier: Apache-2.0
#include "core/contact/contact_pair.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/dashpot.hpp"
#include "core/materials/contact_modulus.hpp"
#include "core/particles/elastic_pieces.hpp"

namespace thaw {
namespace {

double stiffnessOf(const Scene& s, const Continuum& p, std::uint32_t row) {
  const Material& m = s.materials[p.material[row]];
  const double f = p.liquid.active ? static_cast<double>(p.liquid[row]) : 0;
  const double modulus = contactModulus(m, f), least = 0.01 * contactModulus(m, 0);
  return std::max(modulus, least) * s.spacing;
}

}  // namespace

double contactStiffness(const Scene& s, const Continuum& p, std::uint32_t i, std::uint32_t j) {
  double a = stiffnessOf(s, p, i), b = stiffnessOf(s, p, j);
  // A rigid particle gets the stiffness of its elastic partner, so that the step limit of contacts holds.
  if (touchesAsPiece(p, i)) a = b;
  if (touchesAsPiece(p, j)) b = a;
  return 2 * a * b / (a + b);
}

ContactPair contactPair(const Scene& s, const Continuum& p, std::uint32_t i, std::uint32_t j, double step) {
  const Material &a = s.materials[p.material[i]], &b = s.materials[p.material[j]];
  ContactPair c{contactStiffness(s, p, i, j), std::min(a.restitution, b.restitution),
                std::min(a.friction, b.friction), 0, 0};
  const double mass = p.mass[i] * p.mass[j] / (p.mass[i] + p.mass[j]);
  // Restitutions near 0 are overdamped, and a particle can touch five others. Beyond this bound the
  // dashpots would add energy.
  const double most = 0.2 * mass / step, scale = std::sqrt(c.stiffness * mass);
  c.dashpot = std::min(2 * dashpotRatio(c.restitution) * scale, most);
  c.frictionRate = std::min(scale, most);
  return c;
}

bool canTouch(const Continuum& p, std::uint32_t i, std::uint32_t j) {
  return p.phase[i] == Solid && p.phase[j] == Solid && !(touchesAsPiece(p, i) && touchesAsPiece(p, j));
}

bool hasBondTo(const Solids& solids, const Bonds& bonds, const Continuum& p, std::uint32_t i,
               std::uint32_t j) {
  const std::uint32_t solidIndex = p.solidIndex[i];
  if (solidIndex == noSolid) return false;
  const bool here = j < p.owned;  // bonds then refer to the row of j in Solids, so no id is read
  const std::uint32_t other = here ? p.solidIndex[j] : noSolid;
  if (here && other == noSolid) return false;
  for (int k = 0; k < bonds.capacity; k++) {
    const std::uint32_t n = bonds.neighbour[bonds.at(solidIndex, k)];
    if ((here ? n == other : solids.id[n] == p.id[j]) && bonds.hasBond(solidIndex, k)) return true;
  }
  return false;
}

Vec3d exactDifference(const CellGrid& g, const Vec3d& a, const Vec3d& b) {
  Vec3d d;
  for (int k = 0; k < 3; k++)
    d[k] = static_cast<double>(static_cast<std::int32_t>(fixedPoint(g, a[k], k) - fixedPoint(g, b[k], k))) *
           (g.support / fixedUnitsPerSupport);
  return d;
}

}  // namespace thaw
