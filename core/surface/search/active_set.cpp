// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/active_set.hpp"

#include <cstring>
#include <limits>

#include "core/surface/data/surfels.hpp"

namespace thaw {
namespace {

/// Appends rows of one table of surfels to the owned rows of another, whose fields include those of the
/// first.
template<class Row> void appendRows(const Surfels& from, std::size_t n, Row row, Surfels& to) {
  const std::size_t first = to.owned;
  to.resize(first + n, 0);
  for (std::size_t c = 0; c < from.columns.size(); c++) {
    const AnyColumn& in = *from.columns[c];
    AnyColumn& out = *to.columns[c];
    if (!in.active || !out.active || in.keep != Keep::State) continue;
    for (std::size_t k = 0; k < n; k++)
      std::memcpy(out.bytes.data() + (first + k) * in.elementBytes,
                  in.bytes.data() + row(k) * in.elementBytes, in.elementBytes);
  }
}

}  // namespace

void extractActiveSet(Surface& s, const Bins& bins, const std::vector<std::uint8_t>& open, double radius,
                      double reach, ActiveSet& r) {
  Surfels& f = s.surfels;
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<double> depth2(f.size(), far);
  // Surfels this close to a tested surfel are not tested.
  const double beside2 = 2.25 * s.spacing * s.spacing;
  for (std::size_t i = 0; i < f.size(); i++)
    if (open[i] && depth2[i] > beside2)
      forRowsWithin(bins, f.position[i], radius,
                    [&](std::uint32_t j, double d2) { depth2[j] = std::min(depth2[j], d2); });
  f.resize(f.owned, 0);
  r.rows.clear();
  for (std::uint32_t i = 0; i < f.owned; i++)
    if (depth2[i] < far) r.rows.push_back(i);
  Surfels& to = r.surfels;
  for (std::size_t c = 0; c < f.columns.size(); c++) {
    if (f.columns[c]->active) to.activate(*to.columns[c]);
    else deactivate(*to.columns[c]);
  }
  to.activate(to.depth);
  to.resize(to.owned, 0);
  to.resize(0, 0);
  appendRows(
      f, r.rows.size(), [&](std::size_t k) { return r.rows[k]; }, to);
  for (std::size_t k = 0; k < r.rows.size(); k++) to.depth[k] = std::sqrt(depth2[r.rows[k]]);
  r.deepest = radius - reach;
  r.taken = true;
}

bool activeSetSuffices(const ActiveSet& r, Reducer& all) {
  double out = 0;
  for (std::size_t i = 0; i < r.surfels.owned; i++)
    if (r.surfels.resampleMargin[i] == 0 && r.surfels.depth[i] > r.deepest) out = 1;
  all.maximum({&out, 1});
  return out == 0;
}

void returnActiveSet(Surface& s, ActiveSet& r) {
  if (!r.taken) return;
  Surfels& f = s.surfels;
  std::vector<std::uint32_t> kept;
  auto at = r.rows.begin();
  for (std::uint32_t i = 0; i < f.owned; i++)
    if (at != r.rows.end() && *at == i) ++at;
    else kept.push_back(i);
  f.resize(f.owned, 0);
  f.reorder(kept);
  r.surfels.resize(r.surfels.owned, 0);
  appendRows(
      r.surfels, r.surfels.owned, [](std::size_t k) { return k; }, f);
  r.taken = false;
}

}  // namespace thaw
