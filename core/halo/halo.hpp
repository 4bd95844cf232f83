// SPDX-License-Identifier: Apache-2.0
// Interface of the time step to other ranks. Physics code includes this file and never mpi.h. parallel/
// implements it over MPI; tests and single-process tools use the serial implementation (serial.hpp).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/word_streams.hpp"
#include "core/neighbours/grid.hpp"
#include "core/neighbours/migration.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/solids.hpp"

namespace thaw {

/// Exact collective sums, minima and maxima, independent of the number of ranks, and sparse exchange of
/// lists.
class Reducer {
 public:
  virtual ~Reducer() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void maximum(std::span<double> values) = 0;    ///< element-wise over ranks; for minima, reduce
                                                         ///< negated values
  virtual void sum(std::span<std::int64_t> values) = 0;  ///< element-wise over ranks
  /// Sends each list to its rank, at most one per rank; returns the received lists, ascending by rank.
  /// Collective.
  virtual std::vector<WordStream> sparseAllToAll(std::vector<WordStream> lists) = 0;
};

/// Cells: ownership, migration of particles, and copies of the surrounding cells ("ghosts").
class CellHalo {
 public:
  virtual ~CellHalo() = default;

  /// Returns the size of the message buffers in bytes.
  virtual std::size_t bufferBytes() const { return 0; }

  /// Sends particles in cells of other ranks to the owners of these cells. keys[row]: cell key of each owned
  /// row, or noCell. Collective. Ensures: ghosts are dropped. Arrivals are appended (particles.owned grows).
  /// Departed rows are listed and remain in the table. Arrivals have their State columns. Local and Transient
  /// columns are zero (solidIndex: noSolid), so the caller computes their cell keys before the sort.
  virtual Migration migrate(Table& particles, std::span<const std::uint64_t> keys) = 0;

  /// Copies all particles in the cells that touch this rank's cells, periodic images included. Requires:
  /// particles sorted by (cell, id), and `cells` of the owned ones. begin starts the exchange of these
  /// columns. finish appends the ghost rows and merges the ghost cells into `cells`, ascending by key. A
  /// periodic image has a cell key outside of the domain. Its column "position" (if sent) is shifted by the
  /// period. Between begin and finish, owned rows may be read, but no rows may be added.
  virtual void beginGhosts(Table& particles, const CellTable& cells, std::span<AnyColumn* const> columns) = 0;
  virtual void finishGhosts(Table& particles, CellTable& cells) = 0;

  /// Sends these columns to the existing ghosts again. Requires: owned rows of the columns do not change
  /// between begin and finish.
  virtual void beginRefresh(Table& particles, std::span<AnyColumn* const> columns) = 0;
  virtual void finishRefresh(Table& particles) = 0;

  /// Assigns new owners to cells by weighted recursive bisection over the occupied cells. cost[c] > 0, in any
  /// unit, belongs to owned cell c, in order, also in a table with merged ghost cells. Without `force`, cells
  /// get new owners only if the imbalance exceeds a threshold and the gain is worth the migration. Returns
  /// true if owners changed; the next migrate then moves the particles. Collective.
  virtual bool rebalance(const CellTable& ownedCells, std::span<const double> cost, bool force) = 0;

  /// Adopts the cell ownership of another halo over the same grid; the next migrate moves the particles. It
  /// does not communicate, but either all ranks or none must call it.
  virtual void follow(const CellHalo& leader) = 0;

  /// Returns true if this rank owns the cell. Every cell of the grid has exactly one owner.
  virtual bool owns(std::uint64_t key) const = 0;
  /// Returns true if all 26 cells around an owned cell are owned here and no periodic image touches it: its
  /// sums need no ghosts.
  virtual bool inner(std::uint64_t key) const = 0;
};

/// View of the table whose rows are connected by bonds: vertices of sheets, or continuum particles, some of
/// which are solid. Make a new view for each call, since a reorder moves the columns and invalidates the
/// pointers.
struct BondedRows {
  std::size_t owned = 0;
  bool active = false;  ///< the table has solid indices
  const std::uint64_t* id = nullptr;
  std::uint32_t* solidIndex = nullptr;
  const std::uint16_t* material = nullptr;  ///< copied to Solids::material
  const std::uint8_t* phase = nullptr;      ///< null: all rows are solid
  const std::uint64_t* piece = nullptr;     ///< null: no row belongs to a rigid piece, which has no bonds
  BondedRows(Continuum& p)
      : owned(p.owned),
        active(p.solidIndex.active),
        id(p.id.data()),
        solidIndex(p.solidIndex.data()),
        material(p.material.data()),
        phase(p.phase.data()),
        piece(p.piece.active ? p.piece.data() : nullptr) {}
  BondedRows(std::size_t owned, const std::uint64_t* id, std::uint32_t* solidIndex,
             const std::uint16_t* material)
      : owned(owned), active(true), id(id), solidIndex(solidIndex), material(material) {}
  /// Returns true if a row has no bonds: a liquid particle, or one of a rigid piece.
  bool unbonded(std::size_t i) const {
    return (phase && phase[i] == Liquid) || (piece && piece[i] != notRigid);
  }
};

/// A bond to make from an owned solid to the solid particle with this id on any rank.
struct BondRequest {
  std::uint32_t solidIndex;
  std::uint64_t neighbourId;
  Vec3d reference;  ///< X_ij, m, in this end's frame
  Vec3d reverse;    ///< X_ji, m, in the other end's frame (-X_ij unless the frames differ)
  double weight;
  std::uint32_t other = noSolid;  ///< index of the other end if it is owned here and the caller has it; saves
                                  ///< the look-up
};

/// A bond to make if bonds have no vectors (Bonds::vectors). Such scenes make all bonds at once, and a pair
/// takes a fifth of the bytes of a BondRequest.
struct BondPair {
  std::uint64_t neighbourId;
  std::uint32_t solidIndex, other = noSolid;
};

/// Changes for a bond update that are not visible in the tables.
struct BondUpdate {
  std::span<const BondRequest> requests;  ///< bonds to make, appended in this order to the existing bonds of
                                          ///< their solids
  bool changedHere = false;  ///< on this rank, a particle's phase changed or a solid particle left the
                             ///< domain
  std::span<const BondPair> pairs = {};  ///< further bonds, appended behind the requests; only if bonds have
                                         ///< no vectors
  int mostToCome = 0;             ///< upper bound of bonds per solid after all parts of the initial bonds; 0:
                                  ///< unknown
  std::size_t remotesToCome = 0;  ///< upper bound of remote rows after all parts of the initial bonds; 0:
                                  ///< unknown

  bool asks() const { return !requests.empty() || !pairs.empty(); }
};

/// Bonds across ranks. It migrates bonds with their solid particles and exchanges fields along bonds. It
/// keeps a copy ("remote row") of every solid particle of another rank that is bonded to an owned one, at any
/// distance.
class BondHalo {
 public:
  virtual ~BondHalo() = default;

  /// Sends the rows of solids and the bonds of departed particles to their new ranks. Call it after
  /// CellHalo::migrate and before particles are reordered. The tables change at the next bond update.
  /// Collective.
  virtual void migrate(const BondedRows& particles, Solids& solids, Bonds& bonds,
                       const Migration& migration) = 0;

  /// Updates the table of solids to match the particles. Owned solid particles without a row get one, with
  /// the bonds from their former rank if they migrated. Solids of liquid or departed particles are removed,
  /// with all bonds to them on every rank. Requests become bonds, unless the neighbour is no longer solid.
  /// Remote rows are updated and rows renumbered, with BondedRows::solidIndex and Solids::particle. Newly
  /// solid particles have volume 0; the caller sets their volume. Remote rows then contain only the id.
  /// Requires: sorted particles without departed rows, whose phase changed at most once since the last bond
  /// update. Collective. Returns false at once if nothing changed on any rank.
  virtual bool rebuildBonds(const BondedRows& particles, Solids& solids, Bonds& bonds,
                            const BondUpdate& work) = 0;

  /// Sends columns of Solids from owned rows to their remote copies. The rules of beginRefresh apply.
  virtual void begin(Solids& solids, std::span<AnyColumn* const> columns) = 0;
  virtual void finish(Solids& solids) = 0;
};

/// Sets Solids::particle of owned solids from BondedRows::solidIndex. Call it after every sort.
inline void linkSolids(const BondedRows& particles, Solids& solids) {
  for (std::size_t i = 0; i < particles.owned; i++)
    if (particles.solidIndex[i] != noSolid)
      solids.particle[particles.solidIndex[i]] = static_cast<std::uint32_t>(i);
}

}  // namespace thaw
