// SPDX-License-Identifier: Apache-2.0
// Rigid pieces of lattice particles with contacts in a single process, without the other parts of a step.
#pragma once
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/geometry/sampling/sampling.hpp"
#include "core/geometry/shapes/primitives.hpp"
#include "core/halo/serial.hpp"
#include "core/math/quat.hpp"
#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/contact/solve_contacts.hpp"
#include "core/rigid/contact/surface_element.hpp"

namespace thaw {

struct RigPiece {
  double mass = 0;
  Vec3d inertia{};  ///< kg m^2, along the axes of the body frame
  Vec3d centre{};
  Quat orientation;
  Vec3d velocity{}, angularMomentum{};
  std::vector<Vec3d> points;  ///< m, body frame
  std::vector<SurfaceElement> elements;
  std::vector<std::uint64_t> partner;
  std::vector<Vec3d> guess, rollingGuess;

  Sym3d inverseInertia() const {
    Sym3d sum{};
    for (int a = 0; a < 3; a++) {
      Vec3d axis{};
      axis[a] = 1;
      const Vec3d n = rotated(orientation, axis);
      sum = sum + (1 / inertia[a]) * Sym3d{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.x * n.z};
    }
    return sum;
  }
  Vec3d spin() const { return inverseInertia() * angularMomentum; }
};

/// A piece that fills a shape around the origin. Its mass is that of its points.
inline RigPiece pieceOf(const SignedDistance& shape, double spacing, double density) {
  RigPiece piece;
  const SampleLattice lattice = sampleLattice(shape, spacing);
  KnownSides known;
  const double mass = density * spacing * spacing * spacing, own = mass * spacing * spacing / 6;
  for (std::int64_t row = 0; row < lattice.rows(); row++)
    for (const std::int64_t i : insideOfRow(shape, lattice, row, known)) {
      const Vec3d x = lattice.at(i, row % lattice.count[1], row / lattice.count[1]);
      piece.points.push_back(x);
      piece.elements.push_back(elementOfShape(shape, x, spacing));
      piece.mass += mass;
      const double xx = mass * x.x * x.x, yy = mass * x.y * x.y, zz = mass * x.z * x.z;
      piece.inertia += Vec3d{yy + zz + own, zz + xx + own, xx + yy + own};
    }
  piece.partner.resize(piece.points.size());
  piece.guess.resize(piece.points.size());
  piece.rollingGuess.resize(piece.points.size());
  return piece;
}

struct RigidRig {
  std::vector<RigPiece> pieces;
  Scene scene;
  Walls walls;
  CellGrid grid;
  Vec3d gravity{0, 0, -9.81};
  ContactSettings settings;
  ContactResult last;
  std::vector<FoundContact> contacts;
  long iterations = 0;
  double lifted = 0;  ///< J, potential energy by displacements out of overlap

  /// A cube of edge 2 extent around the origin, with a floor at z = 0.
  RigidRig(double spacing, double extent, double step) {
    scene.spacing = spacing;
    scene.materials.resize(1);
    grid.support = 2 * spacing;
    for (int a = 0; a < 3; a++) {
      grid.origin[a] = -extent;
      grid.cells[a] = static_cast<int>(2 * extent / grid.support);
      grid.edge[a] = 2 * extent / grid.cells[a];
    }
    addWall({0, 0, 0}, {0, 0, 1});
    settings.step = step;
    settings.tolerance = 1e-2 * 9.81 * step;
    settings.impactSpeed = 2 * 9.81 * step;
    settings.slop = 0.01 * spacing;
    settings.mostCorrection = 0.05 * spacing;
  }
  void addWall(const Vec3d& point, const Vec3d& normal) {
    Wall wall;
    // the solid is on the other side of the normal
    wall.shape = std::make_shared<HalfSpaceDistance>(point, normal);
    wall.bounds = wall.shape->bounds();
    walls.list.push_back(wall);
  }
  void setFriction(double friction, double restitution) {
    for (Material& m : scene.materials) m.friction = friction, m.restitution = restitution;
    for (Wall& w : walls.list) w.properties.friction = friction, w.properties.restitution = restitution;
  }
  double kineticEnergy() const {
    double e = 0;
    for (const RigPiece& p : pieces)
      e += 0.5 * p.mass * dot(p.velocity, p.velocity) + 0.5 * dot(p.angularMomentum, p.spin());
    return e;
  }
  double energy() const {
    double e = kineticEnergy();
    for (const RigPiece& p : pieces) e -= p.mass * dot(gravity, p.centre);
    return e;
  }

  void step() {
    for (RigPiece& p : pieces) p.velocity += gravity * settings.step;
    build();
    std::vector<PieceMotion> motion;
    for (const RigPiece& p : pieces)
      motion.push_back({1 / p.mass, p.inverseInertia(), p.centre, p.velocity, p.spin()});
    SerialReducer all;
    SerialPieceExchange exchange;
    contacts = findContacts({scene, grid, *particles, cells, *table, walls, settings.step}, motion, all);
    std::vector<RigidContact> solved;
    for (const FoundContact& f : contacts) solved.push_back(f.contact);
    std::vector<PieceChange> changes(pieces.size());
    last = solveContacts(motion, solved, settings, exchange, all, changes);
    iterations += last.iterations;
    for (std::size_t i = 0; i < solved.size(); i++) contacts[i].contact = solved[i];
    keepImpulses(contacts, *table, *particles);
    for (std::size_t i = 0; i < origin.size(); i++) {
      const auto [k, at] = origin[i];
      pieces[k].partner[at] = particles->contactPartner[i];
      pieces[k].guess[at] = particles->contactImpulse[i];
      pieces[k].rollingGuess[at] = particles->rollingImpulse[i];
    }
    for (std::size_t k = 0; k < pieces.size(); k++) {
      move(pieces[k], changes[k]);
      lifted -= pieces[k].mass * dot(gravity, changes[k].shift);
    }
  }

 private:
  std::unique_ptr<Continuum> particles;
  std::unique_ptr<Pieces> table;
  CellTable cells;
  std::vector<std::pair<std::size_t, std::size_t>> origin;  // piece and point of each row

  void move(RigPiece& p, const PieceChange& change) const {
    p.velocity += change.impulse / p.mass;
    p.angularMomentum += change.angularImpulse;
    const Vec3d spin = p.spin();
    p.centre += p.velocity * settings.step + change.shift;
    p.orientation = unitQuat(rotationBy(spin * settings.step + change.turn) * p.orientation);
  }

  void build() {
    particles = std::make_unique<Continuum>();
    table = std::make_unique<Pieces>();
    Continuum& c = *particles;
    for (AnyColumn* column : std::initializer_list<AnyColumn*>{
             &c.id, &c.position, &c.material, &c.piece, &c.pieceRow, &c.faceNormal, &c.faceOffset,
             &c.faceRadius, &c.contactPartner, &c.contactImpulse, &c.rollingImpulse})
      c.activate(*column);
    activatePieces(*table);
    struct Row {
      std::uint64_t cell;
      std::size_t piece, point;
      Vec3d x;
    };
    std::vector<Row> rows;
    for (std::size_t k = 0; k < pieces.size(); k++)
      for (std::size_t m = 0; m < pieces[k].points.size(); m++) {
        const Vec3d x = pieces[k].centre + rotated(pieces[k].orientation, pieces[k].points[m]);
        rows.push_back({cellKey(cellOf(grid, x)), k, m, x});
      }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.cell < b.cell; });
    c.resize(rows.size(), 0);
    table->resize(pieces.size(), 0);
    for (std::size_t k = 0; k < pieces.size(); k++) {
      table->id[k] = (std::uint64_t{k} << 40) + 1;
      table->orientation[k] = pieces[k].orientation;
    }
    cells = {};
    origin.clear();
    for (std::size_t i = 0; i < rows.size(); i++) {
      const Row& r = rows[i];
      const RigPiece& p = pieces[r.piece];
      origin.emplace_back(r.piece, r.point);
      c.id[i] = (std::uint64_t{r.piece} << 40) + r.point;
      c.position[i] = r.x;
      c.piece[i] = table->id[r.piece];
      c.pieceRow[i] = static_cast<std::uint32_t>(r.piece);
      c.faceNormal[i] = p.elements[r.point].normal;
      c.faceOffset[i] = p.elements[r.point].offset;
      c.faceRadius[i] = p.elements[r.point].radius;
      c.contactPartner[i] = p.partner[r.point];
      c.contactImpulse[i] = p.guess[r.point];
      c.rollingImpulse[i] = p.rollingGuess[r.point];
      if (cells.key.empty() || cells.key.back() != r.cell) {
        cells.key.push_back(r.cell);
        cells.first.push_back(static_cast<std::uint32_t>(i));
        cells.count.push_back(0);
      }
      cells.count.back()++;
    }
    cells.ownedCells = cells.key.size();
  }
};

}  // namespace thaw
