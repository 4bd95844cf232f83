// One rank's part of the graph of bonds: which slot has which id, which rows copy solid particles of other
// ranks, who names whom. All changes go through an edit, whose cost is that of what changes and not that of
// the whole table: slots that go are refilled by slots that come or by the last ones, so that few rows get a
// new number, and only groups of slots that can name one of these rows are walked. How often each row is
// named is counted: it says when a remote row is of no use any more, and whether the walk has met every bond
// that it was to change.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/solid/bond_records.hpp"
#include "core/solid/id_table.hpp"

namespace thaw {

inline constexpr std::uint32_t noRow = IdTable::none;

struct SolidTables {
  BondedRows particles;
  Solids& solids;
  Bonds& bonds;
};

/// A slot to be: of the owned particle in this row, with the State columns packed in `state` (all zero if
/// nullptr).
struct NewSlot {
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
  /// A remote row that nobody here names any more.
  struct Released {
    std::uint64_t id;
    int owner;
  };

  explicit BondGraph(int rank = 0) : rank_(rank) {}

  // between edits
  std::size_t owned() const { return owned_; }
  std::size_t rows() const { return ids_.size(); }
  /// Owned slot or remote row of a solid particle; noRow. During an edit: its number as `bond` knows it.
  std::uint32_t rowOf(std::uint64_t id) const { return rowOf_.find(id); }
  std::uint64_t idOf(std::uint32_t row) const { return ids_[row]; }
  int ownerOf(std::uint32_t row) const { return owner_[row]; }
  /// A remote row's particle is owned by that rank now, or an owned one is about to go there.
  void setOwner(std::uint32_t row, int rank) { owner_[row] = rank; }

  // An edit, in this order. Rows are called by their number before the edit, new slots by rows() + their
  // place in the list.
  void begin();
  /// Bonds that were cut go; the order of the others stays.
  void dropBroken(const SolidTables& t);
  /// The slot's particle went to ownerOf(slot); bonds to it stay, unless by finish that is negative: not
  /// solid any more.
  void depart(const Bonds& bonds, std::uint32_t slot);
  /// The slot's particle is not solid any more, on this rank or (removeRemote) where it is owned; bonds to it
  /// go.
  void remove(const Bonds& bonds, std::uint32_t slot);
  void removeRemote(std::uint32_t row) { forget(row); }
  bool leaves(std::uint32_t slot) const { return now_[slot] == noRow; }
  /// Fills the holes and makes the new slots, in the order given. BondedRows::slot follows. Makes room for so
  /// many remote rows, if more than there are.
  void place(const SolidTables& t, std::span<const NewSlot> fresh, std::size_t remotesToCome = 0);
  /// The most bonds that a slot has with those that are asked for; requests of a slot follow each other.
  std::size_t mostBonds(std::span<const BondRequest> requests) const;
  std::size_t mostBonds(std::span<const BondPair> pairs) const;
  /// Makes room for so many bonds a slot.
  void reserve(Bonds& bonds, int capacity) const;
  /// Appends a bond to a slot. The other end is owned here, or has a remote row, or gets one if owner is
  /// another rank (>= 0); else there is no bond, as there is none to itself or of a slot that leaves. A new
  /// slot that brings a bond to nobody has lost it, as it would have where it came from: Solids::bared.
  /// known: the owned slot of the other end, if the caller knows it.
  void bond(const SolidTables& t, std::uint32_t slot, const BondRecord& record, int owner,
            std::uint32_t known = noRow);
  /// The same for many at once, of bonds without vectors; ownerOf(pair) of an end that has no row here, and
  /// of one that leaves.
  template<class OwnerOf>
  void bond(const SolidTables& t, std::span<const BondPair> pairs, OwnerOf&& ownerOf) {
    for (std::size_t i = 0; i < pairs.size();) {
      i = bondOwned(t, pairs, i);
      if (i < pairs.size())
        bond(t, pairs[i].slot, {pairs[i].neighbourId, {}, {}, 0}, ownerOf(pairs[i]), pairs[i].other), i++;
    }
  }
  /// Renumbers. Afterwards the tables are as BondHalo promises; Solids::changed is set where bonds changed,
  /// where a slot is new or has moved, and where the other end of a bond became remote or owned.
  void finish(const SolidTables& t);

  // after an edit
  /// Row now of a row before the edit; noRow if it is gone.
  std::uint32_t now(std::uint32_t before) const { return now_[before]; }
  bool isRemote(std::uint32_t row) const { return row >= owned_ && row != noRow; }
  /// Remote rows made in this edit, and those given up (other than by removeRemote or because the particle
  /// came here).
  std::span<const std::uint32_t> newRemoteRows() const { return newRemotes_; }
  std::span<const Released> released() const { return released_; }
  /// Of memory, buffers of edits included.
  std::size_t bytes() const;
  /// Throws std::logic_error unless the graph agrees with the tables. For tests: walks through everything.
  void check(const SolidTables& t) const;

 private:
  struct Alias {
    std::uint32_t row, stands;
  };  // bonds that name `row` mean `stands`
  template<class Asked> std::size_t mostWith(std::span<const Asked> asked) const;
  std::size_t bondOwned(const SolidTables& t, std::span<const BondPair> pairs, std::size_t first);
  void forget(std::uint32_t row);
  void leave(const Bonds& bonds, std::uint32_t slot);
  void mark(std::size_t group);
  void markOthers(const Bonds& bonds, std::uint32_t slot);
  bool renumbers(std::size_t row) const { return now_[row] != row || (row < before_ && turned_[row]); }
  std::uint32_t addRemote(std::uint64_t id, int owner);
  std::uint32_t addRow(std::uint64_t id, int owner);
  void placeRemotes();
  void moveColumns(const SolidTables& t);
  void walk(const SolidTables& t);
  std::int64_t walkGroup(const SolidTables& t, std::size_t g);
  void renumber();

  int rank_ = 0;
  std::size_t owned_ = 0;
  IdTable rowOf_;
  std::vector<std::uint64_t> ids_;         // of all rows
  std::vector<int> owner_;                 // of all rows
  std::vector<std::uint32_t> references_;  // of all rows: bonds here that name it
  std::vector<std::uint16_t> used_;  // of slots and the lanes behind them: places taken by bonds, broken ones
                                     // included
  std::vector<std::uint8_t> boundary_;  // of groups: some bond names a remote row
  // of the edit
  std::size_t newOwned_ = 0, newRows_ = 0, before_ = 0;  // before_: rows before it
  std::vector<std::uint32_t> now_;  // new number of each old one; of remote rows made in the edit at the end
                                    // of it
  std::vector<std::uint32_t> leaving_, departed_, movers_, unnamed_, relocated_, newRemotes_;
  std::vector<std::uint32_t> bereft_;  // new slots, as `bond` knows them, that came with a bond to a particle
                                       // that is solid no more
  std::vector<Alias> aliases_;
  std::vector<Released> released_;
  std::vector<NewSlot> fresh_;
  std::vector<std::uint32_t> marked_;
  std::vector<std::uint8_t> isMarked_, touched_, isAlias_;
  std::vector<std::uint8_t> turned_;  // of rows before it: was remote and is owned now, or the reverse
                                      // (perhaps with the same number)
  struct Renumbered {
    std::uint32_t to, references;
    std::uint64_t id;
    int owner;
    bool alias;
  };
  std::vector<Renumbered> renumbered_;
};

/// What the particles say of slots since the last edit: Solids::particle is set for all slots that stay;
/// `unslotted` are rows of solid particles without a slot; BondedRows::slot of particles that became liquid
/// is noSlot. Needs sorted particles without departed rows.
void findUnslotted(const BondedRows& particles, Solids& solids, std::vector<std::uint32_t>& unslotted);

}  // namespace thaw
