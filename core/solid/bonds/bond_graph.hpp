// SPDX-License-Identifier: Apache-2.0
// One rank's part of the bond graph: ids of solids, copies of other ranks' solid particles, and references
// between rows. All changes are made in an edit. Its cost is proportional to the size of the change and
// not of the table. New solids, or else the last solids, fill the holes of removed solids, so few rows are
// renumbered. Only groups of solids that can refer to renumbered rows are visited. The reference count of
// each row shows when a remote row is unused, and whether every bond to change was found.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/particles/id_table.hpp"
#include "core/solid/bonds/bond_records.hpp"

namespace thaw {

inline constexpr std::uint32_t noRow = IdTable::none;

struct SolidTables {
  BondedRows particles;
  Solids& solids;
  Bonds& bonds;
};

/// A solid to create for the owned particle in this row. state: its packed State columns; nullptr: all zero.
struct NewSolid {
  std::uint32_t particle = 0;
  const std::byte* state = nullptr;
};

inline BondRecord bondOf(const BondRequest& q) {
  return {q.neighbourId,
          {q.reference.x, q.reference.y, q.reference.z},
          {q.reverse.x, q.reverse.y, q.reverse.z},
          q.weight};
}

class BondGraph {
 public:
  /// A remote row that is no longer referenced on this rank.
  struct Released {
    std::uint64_t id;
    int owner;
  };

  explicit BondGraph(int rank = 0) : rank_(rank) {}

  // Between edits.
  std::size_t owned() const { return owned_; }
  std::size_t rows() const { return ids_.size(); }
  /// Returns the owned solid or remote row of a solid particle, else noRow. During an edit, returns the
  /// number that `bond` uses.
  std::uint32_t rowOf(std::uint64_t id) const { return rowOf_.find(id); }
  std::uint64_t idOf(std::uint32_t row) const { return ids_[row]; }
  int ownerOf(std::uint32_t row) const { return owner_[row]; }
  /// Sets the owner of a remote row, or the new owner of a departing owned row.
  void setOwner(std::uint32_t row, int rank) { owner_[row] = rank; }

  // An edit, in this order. Rows keep their numbers from before the edit; new solids are rows() + their index
  // in the list.
  void begin();
  /// Removes broken bonds; the order of the others stays.
  void dropBroken(const SolidTables& t);
  /// Removes a solid whose particle moved to rank ownerOf(solid). Bonds to it stay, unless the owner is
  /// negative at `finish`, which means that the particle is no longer solid.
  void depart(const Bonds& bonds, std::uint32_t solidIndex);
  /// Removes a particle that is no longer solid, on this rank or (removeRemote) on its owner, with all bonds
  /// to it.
  void remove(const Bonds& bonds, std::uint32_t solidIndex);
  void removeRemote(std::uint32_t row) { removeRow(row); }
  bool leaves(std::uint32_t solidIndex) const { return now_[solidIndex] == noRow; }
  /// Fills the holes and creates the new solids in the given order; BondedRows::solidIndex is updated.
  /// Reserves remotesToCome remote rows if that exceeds the present number.
  void place(const SolidTables& t, std::span<const NewSolid> fresh, std::size_t remotesToCome = 0);
  /// Returns the largest number of bonds per solid, requests included. Requests of a solid are contiguous.
  std::size_t largestBondCount(std::span<const BondRequest> requests) const;
  std::size_t largestBondCount(std::span<const BondPair> pairs) const;
  /// Reserves this many bonds per solid.
  void reserve(Bonds& bonds, int capacity) const;
  /// Appends a bond to a solid. The other end is owned here, has a remote row, or gets one if owner is
  /// another rank (>= 0). Otherwise no bond is made. No bond is made to the solid itself, or for a departing
  /// solid. A new solid that arrives with a bond to a vanished particle has lost that bond. Solids::exposed
  /// is then set. known: owned solid at the other end, if the caller has it.
  void bond(const SolidTables& t, std::uint32_t solidIndex, const BondRecord& record, int owner,
            std::uint32_t known = noRow);
  /// Appends many bonds without vectors. ownerOf(pair) is called for ends without a row here and for
  /// departing ends.
  template<class OwnerOf>
  void bond(const SolidTables& t, std::span<const BondPair> pairs, OwnerOf&& ownerOf) {
    for (std::size_t i = 0; i < pairs.size();) {
      i = bondOwned(t, pairs, i);
      if (i < pairs.size())
        bond(t, pairs[i].solidIndex, {pairs[i].neighbourId, {}, {}, 0}, ownerOf(pairs[i]), pairs[i].other),
            i++;
    }
  }
  /// Renumbers rows. Ensures: the tables satisfy BondHalo::rebuildBonds. Solids::changed is set for solids
  /// with changed bonds, for new or moved solids, and where the other end of a bond became remote or owned.
  void finish(const SolidTables& t);

  // After an edit.
  /// Returns the new number of a row that existed before the edit; noRow if it was removed.
  std::uint32_t now(std::uint32_t before) const { return now_[before]; }
  bool isRemote(std::uint32_t row) const { return row >= owned_ && row != noRow; }
  /// Remote rows created in this edit, and remote rows released in it. Rows released by removeRemote or by
  /// arrival of the particle are excluded.
  std::span<const std::uint32_t> newRemoteRows() const { return newRemotes_; }
  std::span<const Released> released() const { return released_; }
  /// Returns the memory in bytes, edit buffers included.
  std::size_t bytes() const;
  /// Throws std::logic_error if the graph and the tables disagree. It visits everything, so it is meant for
  /// tests.
  void check(const SolidTables& t) const;

 private:
  struct Alias {
    std::uint32_t row, replacement;
  };  // bonds to `row` are redirected to `replacement`
  template<class Asked> std::size_t largestRowCount(std::span<const Asked> asked) const;
  std::size_t bondOwned(const SolidTables& t, std::span<const BondPair> pairs, std::size_t first);
  void removeRow(std::uint32_t row);
  void leave(const Bonds& bonds, std::uint32_t solidIndex);
  void mark(std::size_t group);
  void markOthers(const Bonds& bonds, std::uint32_t solidIndex);
  bool renumbers(std::size_t row) const { return now_[row] != row || (row < before_ && turned_[row]); }
  std::uint32_t addRemote(std::uint64_t id, int owner);
  std::uint32_t addRow(std::uint64_t id, int owner);
  void placeRemotes();
  void moveColumns(const SolidTables& t);
  void rebuildGroups(const SolidTables& t);
  std::int64_t rebuildGroup(const SolidTables& t, std::size_t g);
  void renumber();

  int rank_ = 0;
  std::size_t owned_ = 0;
  IdTable rowOf_;
  std::vector<std::uint64_t> ids_;         // by row
  std::vector<int> owner_;                 // by row
  std::vector<std::uint32_t> references_;  // by row: number of local bonds that refer to the row
  std::vector<std::uint16_t> used_;     // by solid, padding lanes included: number of entries in use, broken
                                        // bonds included
  std::vector<std::uint8_t> boundary_;  // by group: 1 if a bond refers to a remote row
  // State of the current edit.
  std::size_t newOwned_ = 0, newRows_ = 0, before_ = 0;  // before_: number of rows before the edit
  std::vector<std::uint32_t> now_;  // new number of each old row; remote rows created in the edit get their
                                    // numbers at its end
  std::vector<std::uint32_t> leaving_, departed_, movers_, unnamed_, relocated_, newRemotes_;
  std::vector<std::uint32_t> lostBonds_;  // new solids that arrived with a bond to a particle that is no
                                          // longer solid, numbered as in `bond`
  std::vector<Alias> aliases_;
  std::vector<Released> released_;
  std::vector<NewSolid> fresh_;
  std::vector<std::uint32_t> marked_;
  std::vector<std::uint8_t> isMarked_, touched_, isAlias_;
  std::vector<std::uint8_t> turned_;  // by old row: 1 if it changed between remote and owned, possibly with
                                      // the same number
  struct Renumbered {
    std::uint32_t to, references;
    std::uint64_t id;
    int owner;
    bool alias;
  };
  std::vector<Renumbered> renumbered_;
};

/// Compares solids with particles after an edit. Sets Solids::particle of all remaining solids, and
/// BondedRows::solidIndex of melted particles to noSolid. withoutIndex receives the solid particles that have
/// no solid index. Requires: sorted particles without departed rows.
void findWithoutIndex(const BondedRows& particles, Solids& solids, std::vector<std::uint32_t>& withoutIndex);

}  // namespace thaw
