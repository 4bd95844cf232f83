// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/breaking/elastic_solve.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/halo/exchange.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/rigid/connect.hpp"
#include "core/rigid/piece_sums.hpp"

namespace thaw {
namespace {

constexpr double tolerance = 1e-3;    // residual relative to the initial residual
constexpr int mostIterations = 3000;  // thin shells need the most iterations

/// Lists the bonds of a particle. near: particles of the piece within connectedDistance.
void addBonds(BondedPieces& b, std::span<const BondedPieces::Bond> near, double spacing) {
  const double next2 = joinDistance * spacing * (joinDistance * spacing);
  for (const BondedPieces::Bond& n : near) {
    const bool next = dot(n.arm, n.arm) < next2;
    const bool bridged = !next && std::ranges::any_of(near, [&](const BondedPieces::Bond& o) {
      const Vec3d between = n.arm - o.arm;
      return dot(o.arm, o.arm) < next2 && dot(between, between) < next2 && o.other != n.other;
    });
    if (!bridged) b.bonds.push_back(n);
  }
}

/// Vectors of conjugate gradients over the members.
struct Iteration {
  RankPieceExchange& exchange;
  std::vector<Generalised> solution, residual, product;
  std::vector<double> size;        ///< by piece: squared residual, in the norm of the preconditioner
  std::vector<double> goal;        ///< by piece: size at convergence
  std::vector<std::uint8_t> done;  ///< by piece
};

double dotOf(const Generalised& a, const Generalised& b) {
  return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}

Generalised preconditioned(const BondedPieces& b, std::size_t m, const Generalised& r) {
  const double bonds = static_cast<double>(std::max<std::size_t>(1, b.of(m).size()));
  return {r.linear / bonds, r.angular / (0.25 * b.spacing * b.spacing * bonds)};
}

/// The pieces of a solve, for sums over ranks.
struct SolvedPieces {
  std::vector<std::uint64_t> ids;
  SharedPieces shared;
};

SolvedPieces solvedPieces(const RigidView& v, const BondedPieces& b) {
  SolvedPieces s{idsOf(v.pieces, b.pieces), {}};
  s.shared.total = v.work.shared.total;
  for (const std::uint32_t k : b.pieces) s.shared.number.push_back(v.work.shared.number[k]);
  return s;
}

/// Sums one number per member by piece, over all ranks. words: scratch buffer.
template<class Value>
std::vector<double> sumByPiece(RankPieceExchange& exchange, const BondedPieces& b,
                               std::vector<std::int64_t>& words, Value&& value) {
  std::vector<ExactSum> sums(b.pieces.size());
  for (std::size_t m = 0; m < b.member.size(); m++) sums[b.system[m]].add(value(m));
  sumOverRanks(exchange, sums, 1, words);
  std::vector<double> result;
  for (ExactSum& s : sums) result.push_back(s.value());
  return result;
}

/// Sets `product` to the product of stiffness matrix and motion.
void multiply(const BondedPieces& b, const BondedMotion& x, const std::vector<std::uint8_t>& done,
              std::vector<Generalised>& product) {
  for (std::size_t m = 0; m < b.member.size(); m++) {
    if (done[b.system[m]]) continue;
    Generalised sum;
    for (const BondedPieces::Bond& bond : b.of(m)) {
      const Generalised f = bondForce(bond, b.member[m], b.spacing, x);
      sum.linear -= f.linear;
      sum.angular -= 0.5 * cross(bond.arm, f.linear) + f.angular;
    }
    product[m] = sum;
  }
}

void setRow(BondedMotion& x, std::uint32_t row, const Generalised& g) {
  x.linear[row] = g.linear;
  x.angular[row] = g.angular;
}

/// Performs one iteration for all pieces that have not converged. Returns false if none remain on any rank.
bool iterate(const RigidView& v, const Halos& halos, const BondedPieces& b, BondedMotion& direction,
             Iteration& it) {
  refresh(halos.cells, v.particles, ColumnList{&direction.linear, &direction.angular}).wait();
  multiply(b, direction, it.done, it.product);
  const auto at = [&](std::size_t m) {
    return Generalised{direction.linear[b.member[m]], direction.angular[b.member[m]]};
  };
  const std::vector<double> curvature = sumByPiece(it.exchange, b, v.work.words, [&](std::size_t m) {
    return it.done[b.system[m]] ? 0 : dotOf(at(m), it.product[m]);
  });
  for (std::size_t k = 0; k < curvature.size(); k++)
    if (!(curvature[k] > 0)) it.done[k] = 1;
  for (std::size_t m = 0; m < b.member.size(); m++) {
    const std::size_t k = b.system[m];
    if (it.done[k]) continue;
    const double step = it.size[k] / curvature[k];
    it.solution[m].linear += step * at(m).linear;
    it.solution[m].angular += step * at(m).angular;
    it.residual[m].linear -= step * it.product[m].linear;
    it.residual[m].angular -= step * it.product[m].angular;
  }
  const std::vector<double> size = sumByPiece(it.exchange, b, v.work.words, [&](std::size_t m) {
    return it.done[b.system[m]] ? 0 : dotOf(it.residual[m], preconditioned(b, m, it.residual[m]));
  });
  for (std::size_t m = 0; m < b.member.size(); m++) {
    const std::size_t k = b.system[m];
    if (it.done[k]) continue;
    const Generalised z = preconditioned(b, m, it.residual[m]), p = at(m);
    const double beta = size[k] / it.size[k];
    setRow(direction, b.member[m], {z.linear + beta * p.linear, z.angular + beta * p.angular});
  }
  double open = 0;
  for (std::size_t k = 0; k < size.size(); k++) {
    if (it.done[k]) continue;
    it.size[k] = size[k];
    it.done[k] = !(size[k] > it.goal[k]);
    if (!it.done[k]) open = 1;
  }
  halos.all.maximum({&open, 1});
  return open > 0;
}

}  // namespace

BondedPieces bondPieces(const RigidView& v, std::span<const std::uint32_t> pieces) {
  const Continuum& p = v.particles;
  BondedPieces b;
  b.spacing = v.scene.spacing;
  b.pieces.assign(pieces.begin(), pieces.end());
  const double reach = connectedDistance * b.spacing;
  std::vector<BondedPieces::Bond> near;
  const auto isMember = [&](std::size_t i) {
    return p.piece[i] != notRigid && std::binary_search(pieces.begin(), pieces.end(), p.pieceRow[i]);
  };
  b.first.push_back(0);
  eachSurrounded(v.cells, p.owned, v.cells, isMember, [&](std::uint32_t i, std::span<const RowSpan> ranges) {
    near.clear();
    for (const RowSpan& r : ranges)
      for (std::uint32_t j = r.begin; j < r.end; j++) {
        const Vec3d arm = p.position[j] - p.position[i];
        if (j != i && p.piece[j] == p.piece[i] && dot(arm, arm) < reach * reach) near.push_back({j, arm});
      }
    b.member.push_back(i);
    b.system.push_back(b.systemOf(p.pieceRow[i]));
    addBonds(b, near, b.spacing);
    b.first.push_back(b.bonds.size());
  });
  return b;
}

std::vector<Generalised> balancedLoads(const RigidView& v, const BondedPieces& b, const ImpactLoads& loads) {
  const Continuum& c = v.particles;
  const Pieces& p = v.pieces;
  std::vector<Generalised> total(b.pieces.size());
  std::unordered_map<std::uint64_t, std::size_t> memberOf;
  for (std::size_t m = 0; m < b.member.size(); m++) memberOf[c.id[b.member[m]]] = m;
  std::vector<Generalised> result(b.member.size());
  const auto lever = [&](std::size_t m) {
    const std::uint32_t i = b.member[m];
    return rotated(p.orientation[c.pieceRow[i]], c.bodyPosition[i]);
  };
  for (std::size_t k = 0; k < loads.records.size(); k++) {
    const std::uint32_t system = b.systemOf(p.rowOf(loads.piece(k)));
    total[system].linear += loads.force(k);
    total[system].angular += loads.torque(k);
    const auto at = memberOf.find(loads.particle(k));
    if (at == memberOf.end()) continue;
    result[at->second].linear += loads.force(k);
    result[at->second].angular += loads.torque(k) - cross(lever(at->second), loads.force(k));
  }
  std::vector<Generalised> acceleration(total.size());
  for (std::size_t k = 0; k < total.size(); k++)
    acceleration[k] = {total[k].linear / p.mass[b.pieces[k]], spinOf(p, b.pieces[k], total[k].angular)};
  for (std::size_t m = 0; m < b.member.size(); m++) {
    const Generalised& a = acceleration[b.system[m]];
    const double mass = c.mass[b.member[m]];
    result[m].linear -= mass * (a.linear + cross(a.angular, lever(m)));
    result[m].angular -= ownInertia(mass, b.spacing) * a.angular;
  }
  return result;
}

bool solveBonds(const RigidView& v, const Halos& halos, const BondedPieces& b,
                std::span<const Generalised> loads, BondedMotion& motion) {
  const std::size_t members = b.member.size();
  const SolvedPieces pieces = solvedPieces(v, b);
  RankPieceExchange exchange(halos.all, pieces.ids, &pieces.shared);
  Iteration it{exchange,
               std::vector<Generalised>(members),
               {loads.begin(), loads.end()},
               std::vector<Generalised>(members),
               {},
               {},
               std::vector<std::uint8_t>(b.pieces.size(), 0)};
  motion.resize(v.particles.owned, v.particles.size() - v.particles.owned);
  for (std::size_t m = 0; m < members; m++) setRow(motion, b.member[m], preconditioned(b, m, it.residual[m]));
  it.size = sumByPiece(exchange, b, v.work.words, [&](std::size_t m) {
    return dotOf(it.residual[m], preconditioned(b, m, it.residual[m]));
  });
  for (const double size : it.size) it.goal.push_back(tolerance * tolerance * size);
  bool open = true;
  for (int k = 0; k < mostIterations && open; k++) open = iterate(v, halos, b, motion, it);
  for (std::size_t m = 0; m < members; m++) setRow(motion, b.member[m], it.solution[m]);
  refresh(halos.cells, v.particles, ColumnList{&motion.linear, &motion.angular}).wait();
  return !open;
}

Generalised bondForce(const BondedPieces::Bond& bond, std::uint32_t row, double spacing,
                      const BondedMotion& x) {
  const Vec3d turn = 0.5 * (x.angular[row] + x.angular[bond.other]);
  return {x.linear[bond.other] - x.linear[row] - cross(turn, bond.arm),
          (spacing * spacing / 12) * (x.angular[bond.other] - x.angular[row])};
}

Sym3d stressOf(const BondedPieces& b, std::size_t m, std::uint32_t row, const BondedMotion& motion) {
  const double a = b.spacing;
  Sym3d sum{};
  for (const BondedPieces::Bond& bond : b.of(m)) {
    const Generalised f = bondForce(bond, row, a, motion);
    const Vec3d &l = bond.arm, n = normalized(l), g = f.linear, along = dot(f.angular, n) * n;
    sum = sum + (0.5 / (a * a * a)) * Sym3d{l.x * g.x,
                                            l.y * g.y,
                                            l.z * g.z,
                                            0.5 * (l.x * g.y + l.y * g.x),
                                            0.5 * (l.y * g.z + l.z * g.y),
                                            0.5 * (l.x * g.z + l.z * g.x)};
    // Half of 6 M / a^3, the stress at the surface of a square beam: each axis has two bonds.
    const double bending = 3 * length(f.angular - along) / (a * a * a);
    sum = sum + bending * Sym3d{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
  }
  return sum;
}

}  // namespace thaw
