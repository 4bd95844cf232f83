// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/update_pieces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/halo/exchange.hpp"
#include "core/math/hash_random.hpp"
#include "core/math/sym_eigen.hpp"
#include "core/particles/elastic_pieces.hpp"
#include "core/rigid/connect.hpp"
#include "core/rigid/link_pieces.hpp"
#include "core/rigid/motion.hpp"
#include "core/rigid/piece_sums.hpp"
#include "core/rigid/rotation.hpp"
#include "core/rigid/sleeping_pieces.hpp"
#include "core/rigid/surface_elements.hpp"
#include "core/solid/bonds/weight.hpp"

namespace thaw {
namespace {

/// Returns the moment of inertia (kg m^2) of a particle about its own centre. It is 0 in elastic solids:
/// their particles do not rotate.
double inertiaOf(const Continuum& p, const Scene& scene, std::size_t i) {
  return piecesAreElastic(p) ? 0 : ownInertia(p.mass[i], scene.spacing);
}

/// Pieces that get new rows, ascending by id.
struct NewPieces {
  std::vector<std::uint64_t> ids;
  std::vector<std::uint64_t> count;
  std::vector<Vec3d> reference;  ///< m, a point in or near each piece
  std::vector<Vec3d> centre;     ///< m
  std::vector<double> mass;      ///< kg

  std::size_t rowOf(std::uint64_t id) const {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    return at != ids.end() && *at == id ? static_cast<std::size_t>(at - ids.begin()) : ids.size();
  }
};

/// Motion of the former piece of a particle.
struct FormerMotion {
  Vec3d spin{}, turning{};  ///< rad/s, rad/s^2
  Vec3d spinChange{};       ///< rad/s, due to pressure at the start of the next step
  double contactLoad = 0;   ///< N, contact load of the piece over the number of its particles
};

/// Angular momentum of particles that left their pieces, about the particles' own centres. It stays with the
/// pieces.
struct LeftSpins {
  std::vector<std::uint64_t> ids;  ///< former pieces, ascending
  std::vector<Vec3d> share;        ///< kg m^2/s, for each remaining particle

  Vec3d of(std::uint64_t piece) const {
    const auto at = std::lower_bound(ids.begin(), ids.end(), piece);
    return at != ids.end() && *at == piece ? share[static_cast<std::size_t>(at - ids.begin())] : Vec3d{};
  }
};

FormerMotion formerMotion(const RigidView& v, std::size_t i) {
  const Continuum& p = v.particles;
  const std::uint32_t row = p.piece[i] == notRigid ? noPieceRow : v.pieces.rowOf(p.piece[i]);
  if (row == noPieceRow) return {};
  return {spinOf(v.pieces, row, v.pieces.angularMomentum[row]), angularAcceleration(v.pieces, row),
          spinOf(v.pieces, row, v.pieces.pressureTwist[row]),
          v.pieces.contactLoad[row] / static_cast<double>(v.pieces.count[row])};
}

/// Returns the pieces whose sets of particles changed, and the pieces that particles left. A set has changed
/// if its particle count or the sum of its ids' hashes differs from the former piece of the same id.
NewPieces findChanged(const RigidView& v, Reducer& all) {
  const Continuum& p = v.particles;
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < p.owned; i++)
    for (const std::uint64_t id : {p.piece[i], p.setLabel[i]})
      if (id != notRigid) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  constexpr std::size_t perPiece = 3;  // growth, growth of the sum of hashes, particles
  std::vector<std::int64_t> words(perPiece * ids.size(), 0);
  const auto add = [&](std::uint64_t id, std::uint64_t particle, std::int64_t sign) {
    if (id == notRigid) return;
    const auto k = static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    words[perPiece * k] += sign;
    words[perPiece * k + 1] += sign * static_cast<std::int64_t>(mixBits(particle) >> 32);
    words[perPiece * k + 2] += sign > 0;
  };
  for (std::size_t i = 0; i < p.owned; i++) {
    add(p.piece[i], p.id[i], -1);
    add(p.setLabel[i], p.id[i], 1);
  }
  RankPieceExchange exchange(all, ids, nullptr);
  exchange.sum(words, perPiece);
  NewPieces changed;
  for (std::size_t k = 0; k < ids.size(); k++) {
    const std::int64_t* const w = words.data() + perPiece * k;
    if (w[2] == 0) continue;
    const std::uint32_t row = v.pieces.rowOf(ids[k]);
    const bool left = row != noPieceRow && v.pieces.count[row] != static_cast<std::uint64_t>(w[2]);
    if (w[0] == 0 && w[1] == 0 && !left) continue;
    changed.ids.push_back(ids[k]);
    changed.count.push_back(static_cast<std::uint64_t>(w[2]));
  }
  return changed;
}

LeftSpins leftSpins(const RigidView& v, Reducer& all) {
  const Continuum& p = v.particles;
  LeftSpins left;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.piece[i] != notRigid) left.ids.push_back(p.piece[i]);
  std::sort(left.ids.begin(), left.ids.end());
  left.ids.erase(std::unique(left.ids.begin(), left.ids.end()), left.ids.end());
  constexpr std::size_t perPiece = 2;  // moments of particles that left, number of remaining particles
  std::vector<ExactSum> sums(perPiece * left.ids.size());
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.piece[i] == notRigid) continue;
    const auto at = std::lower_bound(left.ids.begin(), left.ids.end(), p.piece[i]);
    ExactSum* const s = sums.data() + perPiece * static_cast<std::size_t>(at - left.ids.begin());
    if (p.setLabel[i] == notRigid) s[0].add(inertiaOf(p, v.scene, i));
    else s[1].add(1);
  }
  RankPieceExchange exchange(all, left.ids, nullptr);
  sumOverRanks(exchange, sums, perPiece, v.work.words);
  for (std::size_t k = 0; k < left.ids.size(); k++) {
    const std::uint32_t row = v.pieces.rowOf(left.ids[k]);
    const double moment = sums[perPiece * k].value(), remain = sums[perPiece * k + 1].value();
    left.share.push_back(moment > 0 && remain > 0 && row != noPieceRow
                             ? spinOf(v.pieces, row, v.pieces.angularMomentum[row]) * (moment / remain)
                             : Vec3d{});
  }
  return left;
}

/// Calls use(row of the particle, row of its new piece) for owned particles of changed pieces.
template<class Use> void eachChanged(const RigidView& v, const NewPieces& n, Use&& use) {
  for (std::size_t i = 0; i < v.particles.owned; i++) {
    if (v.particles.setLabel[i] == notRigid) continue;
    if (const std::size_t k = n.rowOf(v.particles.setLabel[i]); k < n.ids.size()) use(i, k);
  }
}

/// Returns the position (m) of a particle in the same periodic image as its piece.
Vec3d placeIn(const RigidView& v, const NewPieces& n, std::size_t i, std::size_t k) {
  return n.reference[k] + minimumImage(v.particles.position[i] - n.reference[k], periodsOf(v.grid));
}

/// Returns true if the distance of a particle from its piece's reference may be half of a periodic domain.
/// Any connected piece of larger extent has such particles.
bool isFar(const RigidView& v, const Vec3d& place, const Vec3d& reference) {
  for (int a = 0; a < 3; a++)
    if (v.grid.periodic[a] &&
        std::abs(place[a] - reference[a]) > 0.5 * v.grid.period[a] - connectedDistance * v.scene.spacing)
      return true;
  return false;
}

constexpr std::size_t sectors = 64;  // along each periodic axis

std::size_t sectorOf(const CellGrid& g, const Vec3d& x, int a) {
  const double part = (x[a] - g.origin[a]) / g.period[a] * static_cast<double>(sectors);
  return static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(sectors - 1)));
}

/// Returns the middle (m) of the occupied part of a periodic axis, outside of the widest gap. count:
/// number of particles in each sector. Returns nothing without a gap of at least `least` (m).
std::optional<double> middleOf(const CellGrid& g, int a, std::span<const std::int64_t> count, double least) {
  std::size_t widest = 0, end = 0;  // number of empty sectors, and the first sector after them
  for (std::size_t run = 0, s = 0; s < 2 * sectors; s++) {
    run = count[s % sectors] == 0 ? run + 1 : 0;
    if (run <= widest) continue;
    widest = run;
    end = s + 1;
  }
  if (static_cast<double>(widest) / static_cast<double>(sectors) * g.period[a] < least) return {};
  const double middle = (static_cast<double>(end) + 0.5 * static_cast<double>(sectors - widest)) /
                        static_cast<double>(sectors);
  return g.origin[a] + g.period[a] * (middle - std::floor(middle));
}

/// Returns the rows of changed pieces that have a far particle on any rank.
std::vector<std::size_t> longPieces(const RigidView& v, const NewPieces& n, PieceExchange& exchange) {
  std::vector<std::int64_t> far(n.ids.size(), 0);
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    if (isFar(v, placeIn(v, n, i, k), n.reference[k])) far[k]++;
  });
  exchange.sum(far, 1);
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < far.size(); k++)
    if (far[k] > 0) rows.push_back(k);
  return rows;
}

/// Moves the reference of each piece that extends over half of a periodic domain to the piece's middle.
void centreReferences(const RigidView& v, NewPieces& n, PieceExchange& exchange, Reducer& all) {
  const std::vector<std::size_t> rows = longPieces(v, n, exchange);
  double any = rows.empty() ? 0 : 1;
  all.maximum({&any, 1});
  if (!(any > 0)) return;
  std::vector<std::uint64_t> ids;
  for (const std::size_t k : rows) ids.push_back(n.ids[k]);
  std::vector<std::int64_t> counts(3 * sectors * ids.size(), 0);
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    const auto at = std::lower_bound(rows.begin(), rows.end(), k);
    if (at == rows.end() || *at != k) return;
    const auto m = 3 * static_cast<std::size_t>(at - rows.begin());
    for (int a = 0; a < 3; a++)
      if (v.grid.periodic[a])
        counts[(m + static_cast<std::size_t>(a)) * sectors + sectorOf(v.grid, v.particles.position[i], a)]++;
  });
  RankPieceExchange(all, ids, nullptr).sum(counts, 3 * sectors);
  for (std::size_t m = 0; m < rows.size(); m++)
    for (int a = 0; a < 3; a++) {
      if (!v.grid.periodic[a]) continue;
      const std::span<const std::int64_t> count(&counts[(3 * m + static_cast<std::size_t>(a)) * sectors],
                                                sectors);
      double& reference = n.reference[rows[m]][a];
      reference = middleOf(v.grid, a, count, connectedDistance * v.scene.spacing).value_or(reference);
    }
}

/// Sets the reference of each piece. Particles are at the periodic images nearest to it. It is the particle
/// with the smallest id, or the middle of a long piece.
void findReferences(const RigidView& v, NewPieces& n, PieceExchange& exchange, Reducer& all) {
  std::vector<std::int64_t> words(3 * n.ids.size(), 0);
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    if (v.particles.id[i] + 1 != n.ids[k]) return;
    for (std::size_t a = 0; a < 3; a++)
      words[3 * k + a] = std::bit_cast<std::int64_t>(v.particles.position[i][static_cast<int>(a)]);
  });
  exchange.sum(words, 3);
  n.reference.resize(n.ids.size());
  for (std::size_t k = 0; k < words.size(); k++)
    n.reference[k / 3][static_cast<int>(k % 3)] = std::bit_cast<double>(words[k]);
  if (v.grid.periodic[0] || v.grid.periodic[1] || v.grid.periodic[2]) centreReferences(v, n, exchange, all);
}

void findCentres(const RigidView& v, NewPieces& n, PieceExchange& exchange) {
  constexpr std::size_t perPiece = 4;
  std::vector<ExactSum> sums(perPiece * n.ids.size());
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    const double m = v.particles.mass[i];
    const Vec3d x = placeIn(v, n, i, k);
    sums[perPiece * k].add(m);
    for (std::size_t a = 0; a < 3; a++) sums[perPiece * k + 1 + a].add(m * x[static_cast<int>(a)]);
  });
  sumOverRanks(exchange, sums, perPiece, v.work.words);
  for (std::size_t k = 0; k < n.ids.size(); k++) {
    const double m = sums[perPiece * k].value();
    n.mass.push_back(m);
    n.centre.push_back({sums[perPiece * k + 1].value() / m, sums[perPiece * k + 2].value() / m,
                        sums[perPiece * k + 3].value() / m});
  }
}

constexpr std::size_t motionSums = 27;  // inertia 6, momentum 3, angular momentum 3, force 3, torque 3,
                                        // kinetic energy, clamped particles, impulse of pressure 3, its
                                        // angular impulse 3, contact load

/// Returns the rotation of a particle about its own centre, from its former piece, or from its body at the
/// start.
FormerMotion ownMotion(const RigidView& v, std::size_t i, bool atStart) {
  if (!atStart) return formerMotion(v, i);
  const std::size_t body = v.particles.body[i];
  return body < v.scene.bodies.size() ? FormerMotion{v.scene.bodies[body].spin, {}, {}, 0} : FormerMotion{};
}

/// Adds a particle to the sums of its piece. extra: additional angular momentum (kg m^2/s) of the particle.
void addMotion(const RigidView& v, std::size_t i, const Vec3d& lever, const FormerMotion& former,
               const Vec3d& extra, ExactSum* sums) {
  const Continuum& p = v.particles;
  const double m = p.mass[i], own = inertiaOf(p, v.scene, i);
  const Vec3d& r = lever;
  const Vec3d momentum = p.velocity[i] * m, force = p.acceleration[i] * m;
  const Vec3d angular = cross(r, momentum) + former.spin * own + extra,
              torque = cross(r, force) + former.turning * own;
  const double inertia[6] = {m * (r.y * r.y + r.z * r.z) + own,
                             m * (r.x * r.x + r.z * r.z) + own,
                             m * (r.x * r.x + r.y * r.y) + own,
                             -m * r.x * r.y,
                             -m * r.y * r.z,
                             -m * r.x * r.z};
  for (std::size_t c = 0; c < 6; c++) sums[c].add(inertia[c]);
  for (int a = 0; a < 3; a++) {
    sums[6 + a].add(momentum[a]);
    sums[9 + a].add(angular[a]);
    sums[12 + a].add(force[a]);
    sums[15 + a].add(torque[a]);
  }
  sums[18].add(0.5 * (m * dot(p.velocity[i], p.velocity[i]) + own * dot(former.spin, former.spin)));
  if (p.clamped.active && (p.clamped[i] == fixedInPlace || p.clamped[i] == driven)) sums[19].add(1);
  sums[26].add(former.contactLoad);
  if (!p.pressureImpulse.active) return;
  const Vec3d pressure = p.pressureImpulse[i] * m, twist = cross(r, pressure) + former.spinChange * own;
  for (int a = 0; a < 3; a++) {
    sums[20 + a].add(pressure[a]);
    sums[23 + a].add(twist[a]);
  }
}

Vec3d vectorOf(const ExactSum* sums) { return {sums[0].value(), sums[1].value(), sums[2].value()}; }

/// Sets the row of a piece from its sums.
void setRow(Pieces& p, std::size_t row, const NewPieces& n, std::size_t k, const ExactSum* sums) {
  p.id[row] = n.ids[k];
  p.count[row] = n.count[k];
  p.contactLoad[row] = sums[26].value();
  p.restTime[row] = 0;
  p.sleeping[row] = 0;
  p.mass[row] = n.mass[k];
  p.centre[row] = n.centre[k];
  p.fixed[row] = sums[19].value() > 0;
  const SymEigen e = eigenOf(
      {sums[0].value(), sums[1].value(), sums[2].value(), sums[3].value(), sums[4].value(), sums[5].value()});
  const Vec3d x = normalized(e.vector[0]), y = normalized(e.vector[1] - x * dot(x, e.vector[1]));
  p.orientation[row] = quatOf(x, y, cross(x, y));
  // A straight row of elastic particles has no moment of inertia about its axis.
  const double least = 1e-9 * std::max({e.value[0], e.value[1], e.value[2]});
  p.inertia[row] = {std::max(e.value[0], least), std::max(e.value[1], least), std::max(e.value[2], least)};
  p.momentum[row] = p.fixed[row] ? Vec3d{} : vectorOf(sums + 6);
  p.angularMomentum[row] = p.fixed[row] ? Vec3d{} : vectorOf(sums + 9);
  p.force[row] = vectorOf(sums + 12);
  p.torque[row] = vectorOf(sums + 15);
  p.pressureImpulse[row] = p.fixed[row] ? Vec3d{} : vectorOf(sums + 20);
  p.pressureTwist[row] = p.fixed[row] ? Vec3d{} : vectorOf(sums + 23);
}

/// Records the kinetic energy lost when a piece forms, and the impulse of its clamps.
void recordJoining(const RigidView& v, std::size_t row, const ExactSum* sums) {
  Pieces& p = v.pieces;
  const Vec3d spin = spinOf(p, row, p.angularMomentum[row]);
  const double kinetic = p.fixed[row] ? 0
                                      : 0.5 * (dot(p.momentum[row], p.momentum[row]) / p.mass[row] +
                                               dot(p.angularMomentum[row], spin));
  v.ledger.dissipated.add(sums[18].value() - kinetic);
  for (int a = 0; a < 3 && p.fixed[row]; a++) v.ledger.wallImpulse[a].add(-sums[6 + a].value());
}

/// Records the energy of particles' own rotation, which is lost when particles of pieces melt.
void recordMelted(const RigidView& v) {
  const Continuum& p = v.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.piece[i] == notRigid || p.setLabel[i] != notRigid) continue;
    const Vec3d spin = formerMotion(v, i).spin;
    v.ledger.dissipated.add(0.5 * inertiaOf(p, v.scene, i) * dot(spin, spin));
  }
}

/// Rotates the surface elements of changed pieces from their former body frames to the axes of the domain.
void unturnElements(const RigidView& v, const NewPieces& n) {
  Continuum& p = v.particles;
  eachChanged(v, n, [&](std::size_t i, std::size_t) {
    const std::uint32_t row = p.piece[i] == notRigid ? noPieceRow : v.pieces.rowOf(p.piece[i]);
    if (row != noPieceRow) turnElement(p, i, v.pieces.orientation[row]);
  });
}

/// Sets position, velocity and constraint of the particles of new pieces.
void placeParticles(const RigidView& v, const NewPieces& n, std::span<const std::uint32_t> rows) {
  Continuum& p = v.particles;
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    const std::uint32_t row = rows[k];
    const Quat q = v.pieces.orientation[row];
    const Vec3d lever = placeIn(v, n, i, k) - n.centre[k];
    const Quat toBody = conjugate(q);
    p.bodyPosition[i] = rotated(toBody, lever);
    if (p.faceNormal.active) turnElement(p, i, toBody);
    p.velocity[i] = velocityOf(v.pieces, row) +
                    cross(spinOf(v.pieces, row, v.pieces.angularMomentum[row]), lever);
    if (!p.clamped.active) return;
    if (v.pieces.fixed[row] && p.clamped[i] == 0) {
      p.clamped[i] = fixedByPiece;
      for (int a = 0; a < 3; a++)  // the clamps also balance its force in the next half kick
        v.ledger.wallForce[a].add(-p.mass[i] * p.acceleration[i][a]);
    }
    if (!v.pieces.fixed[row] && p.clamped[i] == fixedByPiece) p.clamped[i] = 0;
  });
}

/// Assigns particles to their new pieces. Molten particles are released.
void adoptLabels(Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.setLabel[i] == notRigid && p.clamped.active && p.clamped[i] == fixedByPiece) p.clamped[i] = 0;
    p.piece[i] = p.setLabel[i];
  }
}

}  // namespace

void markRigidParticles(const Scene& scene, Continuum& p) {
  for (std::size_t i = 0; i < p.owned; i++) p.piece[i] = belongsToPiece(scene, p, i) ? p.id[i] + 1 : notRigid;
}

void updatePieces(const RigidView& v, const Halos& halos, bool atStart) {
  labelPieces(v, halos, atStart);
  if (v.modules.pieceSleep && !atStart) wakeNearChanges(v, halos.all);
  remakePieces(v, halos, atStart);
}

void remakePieces(const RigidView& v, const Halos& halos, bool atStart) {
  const bool elements = v.particles.faceNormal.active;
  if (atStart) std::fill_n(v.particles.piece.data(), v.particles.owned, notRigid);
  NewPieces n = findChanged(v, halos.all);
  RankPieceExchange exchange(halos.all, n.ids, nullptr);
  findReferences(v, n, exchange, halos.all);
  findCentres(v, n, exchange);
  const LeftSpins left = leftSpins(v, halos.all);
  std::vector<ExactSum> sums(motionSums * n.ids.size());
  eachChanged(v, n, [&](std::size_t i, std::size_t k) {
    addMotion(v, i, placeIn(v, n, i, k) - n.centre[k], ownMotion(v, i, atStart),
              left.of(v.particles.piece[i]), sums.data() + motionSums * k);
  });
  sumOverRanks(exchange, sums, motionSums, v.work.words);
  if (!atStart) {
    recordMelted(v);
    if (elements) {
      unturnElements(v, n);
      renewElements(v);
    }
  }
  // New rows replace former rows of the same id, because these are no longer needed for the motion of
  // particles.
  Pieces& p = v.pieces;
  std::vector<std::uint32_t> rows(n.ids.size());
  std::size_t end = p.owned;
  for (std::size_t k = 0; k < n.ids.size(); k++) {
    rows[k] = p.rowOf(n.ids[k]);
    if (rows[k] == noPieceRow) rows[k] = static_cast<std::uint32_t>(end++);
  }
  p.resize(end, 0);
  for (std::size_t k = 0; k < n.ids.size(); k++) {
    setRow(p, rows[k], n, k, sums.data() + motionSums * k);
    if (atStart) p.contactLoad[rows[k]] = unknownLoad;
  }
  placeParticles(v, n, rows);
  adoptLabels(v.particles);
  Continuum& c = v.particles;
  ColumnList changed{&c.piece, &c.phase, &c.velocity};
  if (c.clamped.active) changed.push_back(&c.clamped);
  if (elements)
    for (AnyColumn* column : std::initializer_list<AnyColumn*>{&c.faceNormal, &c.faceOffset, &c.faceRadius})
      changed.push_back(column);
  refresh(halos.cells, c, changed).wait();
  linkPieces(v, halos, PieceUsers::Owned);
  for (std::size_t k = 0; k < n.ids.size() && !atStart; k++)
    if (const std::uint32_t row = p.rowOf(n.ids[k]); row != noPieceRow && p.recordsEnergy[row])
      recordJoining(v, row, sums.data() + motionSums * k);
}

}  // namespace thaw
