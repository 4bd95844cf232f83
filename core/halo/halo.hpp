// What the time step needs of other ranks. Physics includes this and never mpi.h; parallel/ implements it
// over MPI, tests and single-process tools use the serial implementation beside it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/word_lists.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/solid/solids.hpp"

namespace thaw {

/// Rows that left this rank in a migration and rows that arrived (appended behind the rows that were owned
/// before).
struct Migration {
  std::vector<std::uint32_t> departed;  ///< rows, ascending; still in the table until it is reordered
  std::vector<int> departedTo;          ///< rank, beside departed
  std::size_t arrivals = 0;             ///< the last `arrivals` owned rows are new
};

/// Collective sums, minima and maxima that are exact, so that they do not depend on the number of ranks; and
/// lists from some ranks to others.
class Reducer {
 public:
  virtual ~Reducer() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void maximum(std::span<double> values) = 0;  ///< element by element over ranks (minima: of negated
                                                       ///< values)
  virtual void sum(std::span<std::int64_t> values) = 0;  ///< element by element over ranks
  /// to their ranks, one for each at most; returns what came, ascending by rank. Collective
  virtual std::vector<WordList> deliver(std::vector<WordList> lists) = 0;
};

/// Cells: who owns which, migration of particles, copies of the cells around a rank's own ("ghosts").
class CellHalo {
 public:
  virtual ~CellHalo() = default;

  /// Bytes of the messages' buffers.
  virtual std::size_t bufferBytes() const { return 0; }

  /// Sends particles whose cell another rank owns to that rank. keys[row]: cell key of each owned row, or
  /// noCell. Collective. Guarantees: ghosts dropped, arrivals appended (particles.owned grows), departed rows
  /// listed and still in place. Arrivals have their State columns; Local and Transient ones are zero (slot:
  /// noSlot), so their cell keys are to be computed before the sort.
  virtual Migration migrate(Table& particles, std::span<const std::uint64_t> keys) = 0;

  /// Copies of all particles in the cells that touch this rank's cells, periodic images included. Needs
  /// particles sorted by (cell, id) and `cells` of the owned ones. begin starts the exchange of these
  /// columns; finish appends the ghost rows and merges the ghost cells into `cells`, ascending by key. A
  /// periodic image has its cell's key outside of the domain and the column named "position" (if sent)
  /// shifted by the period. Between the two, owned rows may be read but rows not added.
  virtual void beginGhosts(Table& particles, const CellTable& cells, std::span<AnyColumn* const> columns) = 0;
  virtual void finishGhosts(Table& particles, CellTable& cells) = 0;

  /// Sends these columns of the same ghosts again. The column's owned rows must not change between begin and
  /// finish.
  virtual void beginRefresh(Table& particles, std::span<AnyColumn* const> columns) = 0;
  virtual void finishRefresh(Table& particles) = 0;

  /// New owners for cells, by weighted recursive bisection over the occupied cells: cost[c] of owned cell c
  /// in any unit (> 0); in a table that ghost cells were merged into, of the owned ones in their order. Does
  /// nothing and returns false unless force, or the imbalance is above a threshold and the gain worth it.
  /// After true, the next migrate moves the particles. Collective.
  virtual bool rebalance(const CellTable& ownedCells, std::span<const double> cost, bool force) = 0;

  /// Takes over which rank owns which cell from another halo over the same grid; the next migrate moves the
  /// particles. Not collective, but all ranks do it or none.
  virtual void follow(const CellHalo& leader) = 0;

  /// True if this rank owns the cell (the same answer on no other rank); every cell of the grid has exactly
  /// one owner.
  virtual bool owns(std::uint64_t key) const = 0;
  /// True if all 26 cells around an owned cell are owned here and no periodic image touches it: its sums need
  /// no ghosts.
  virtual bool inner(std::uint64_t key) const = 0;
};

/// What bonds need of the table whose rows they join: vertices of sheets, or particles of the continuum of
/// which some are solid. Names columns as they are now: made anew for each call, since a table that is
/// reordered moves them.
struct BondedRows {
  std::size_t owned = 0;
  bool active = false;  ///< the table has slots at all
  const std::uint64_t* id = nullptr;
  std::uint32_t* slot = nullptr;
  const std::uint16_t* material = nullptr;  ///< copied to Solids::material
  const std::uint8_t* phase = nullptr;      ///< without one all rows are solid
  BondedRows(Continuum& p)
      : owned(p.owned),
        active(p.slot.active),
        id(p.id.data()),
        slot(p.slot.data()),
        material(p.material.data()),
        phase(p.phase.data()) {}
  BondedRows(std::size_t owned, const std::uint64_t* id, std::uint32_t* slot, const std::uint16_t* material)
      : owned(owned), active(true), id(id), slot(slot), material(material) {}
  bool liquid(std::size_t i) const { return phase && phase[i] == Liquid; }
};

/// A bond to make: from an owned slot to the solid particle with this id, wherever that is.
struct BondRequest {
  std::uint32_t slot;
  std::uint64_t neighbourId;
  Vec3d reference;  ///< X_ij, m, in this end's frame
  Vec3d reverse;    ///< X_ji, m, in the other end's frame (-X_ij unless the frames differ)
  double weight;
  std::uint32_t other = noSlot;  ///< slot of the other end, where it is owned here and the caller knows it:
                                 ///< it need not be looked for
};

/// The same where a bond is its other end alone (Bonds::vectors): a scene makes all its bonds at once, and
/// this is a fifth of the bytes.
struct BondPair {
  std::uint64_t neighbourId;
  std::uint32_t slot, other = noSlot;
};

/// What a relink is to do beside what the tables say.
struct Relink {
  std::span<const BondRequest> requests;  ///< bonds to make, appended to their slots in this order
  bool changedHere = false;  ///< a particle's phase changed, or a particle with a slot left the domain, on
                             ///< this rank
  std::span<const BondPair> pairs = {};  ///< bonds to make as well, behind the requests; only where bonds
                                         ///< have no vectors
  int mostToCome = 0;  ///< more bonds than this no slot will have when all parts of a start are made; 0: not
                       ///< known
  std::size_t remotesToCome = 0;  ///< remote rows of all parts of a start, at most; 0: not known

  bool asks() const { return !requests.empty() || !pairs.empty(); }
};

/// Bonds: follows solid particles in migration, keeps a copy ("remote row") of every solid particle that an
/// owned one is bonded to, however far away it is, and sends fields along the bonds.
class BondHalo {
 public:
  virtual ~BondHalo() = default;

  /// After CellHalo::migrate and before particles are reordered: sends the slots (and bonds) of departed
  /// particles to where they went. The tables change at the next relink. Collective.
  virtual void migrate(const BondedRows& particles, Solids& solids, Bonds& bonds,
                       const Migration& migration) = 0;

  /// Makes the table of solids agree with the particles: owned particles of phase Solid without a slot get
  /// one (with the bonds they had where they came from, else none), slots of particles that are liquid now,
  /// or gone, are removed with all bonds to them on every rank, requests become bonds (one whose neighbour is
  /// not solid any more is dropped), remote rows are renewed, rows renumbered (BondedRows::slot and
  /// Solids::particle follow). Slots of particles that have just become solid have volume 0, for the caller
  /// to fill in. Remote rows then have their id; other columns are to be sent. Needs sorted particles without
  /// departed rows, whose phase has changed once at most since the last relink. Collective. Returns false, at
  /// once, where nothing changed on any rank.
  virtual bool relink(const BondedRows& particles, Solids& solids, Bonds& bonds, const Relink& work) = 0;

  /// Sends columns of Solids from owned rows to the remote rows that copy them. The same rules as refresh of
  /// ghosts.
  virtual void begin(Solids& solids, std::span<AnyColumn* const> columns) = 0;
  virtual void finish(Solids& solids) = 0;
};

/// Solids::particle of owned slots from the rows' slots; after every sort.
inline void linkSlots(const BondedRows& particles, Solids& solids) {
  for (std::size_t i = 0; i < particles.owned; i++)
    if (particles.slot[i] != noSlot) solids.particle[particles.slot[i]] = static_cast<std::uint32_t>(i);
}

}  // namespace thaw
