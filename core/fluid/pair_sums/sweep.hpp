// SPDX-License-Identifier: Apache-2.0
// The only loop over neighbours. A Term defines the data of a particle, the contribution of a pair and the
// final step. Lanes are particles, so vectorisation, rank count and domain decomposition do not change a
// particle's summation order.
#pragma once
#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/simd/lanes.hpp"

namespace thaw {
namespace THAW_ISA {

/// Groups that a sum covers. Fluid: cells around the group contain liquid. NonFluid: no liquid is near, so
/// sums over liquid are zero.
enum class Groups { All, Fluid, NonFluid };

/// Adds the neighbours of a group. Its list of n entries starts at `at`.
template<class Term>
THAW_INLINE void addNeighbours(const Term& term, const typename Term::Data& own, const std::uint32_t* at,
                               std::uint32_t n, typename Term::Sum& sum) {
  if constexpr (requires { typename Term::Pair; }) {
    if (n == 0) return;
    typename Term::Pair next = term.begin(own, term.load(at));
    for (; n > 1; n--) {
      at += 8;
      __builtin_prefetch(at + listAhead);
      const typename Term::Pair now = next;
      next = term.begin(own, term.load(at));
      term.add(own, now, sum);
    }
    term.add(own, next, sum);
  } else {
    for (; n > 0; n--, at += 8) {
      __builtin_prefetch(at + listAhead);
      term.pair(own, term.load(at), at, sum);
    }
  }
}

/// Sums a term over the neighbours of all groups in `range`. A Term has structs Data and Sum, and:
/// - load(entries): the data of eight rows; entries are twice the rows, the record offsets of loadListed.
/// - pair(own, other, entries, sum): adds one neighbour in each lane. Lanes of short lists get the dummy row.
///   Alternatively, if the latency of a pair is long: begin(own, other), which returns a Pair, and add(own,
///   pair, sum). The next pair then begins before the last one is added.
/// - optional: prefetch(rows), called before the neighbours are added, for columns that finish uses.
/// - finish(rows, own, sum, dummy): writes the sums. Lanes with rows[l] == dummy hold no particle.
template<class Term>
THAW_INLINE void sweep(const NeighbourLists& lists, GroupRange range, Term& term, Groups groups) {
  const std::uint32_t* const list = lists.list.data();
  const std::uint32_t* const self = lists.self.data();
  for (std::size_t g = range.begin; g < range.end; g++) {
    if (groups != Groups::All && (lists.fluid[g] != 0) != (groups == Groups::Fluid)) continue;
    const std::uint32_t* rows = self + 8 * g;
    alignas(32) std::uint32_t ownEntries[8];
    for (int l = 0; l < 8; l++) ownEntries[l] = 2 * rows[l];
    const typename Term::Data own = term.load(ownEntries);
    if constexpr (requires { term.prefetch(rows); }) term.prefetch(rows);
    typename Term::Sum sum{};
    addNeighbours(term, own, list + lists.first[g], lists.count[g], sum);
    const typename Term::Sum total = sum;  // a copy in memory that is read lane by lane, so that `sum` stays
                                           // in registers
    term.finish(rows, own, total, lists.dummy);
  }
}

}  // namespace THAW_ISA
}  // namespace thaw
