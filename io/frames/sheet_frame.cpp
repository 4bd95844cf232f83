// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/sheet/forces/inner_forces.hpp"
#include "io/frames/body_type_frame.hpp"
#include "io/frames/frame_rows.hpp"

namespace thaw {

void addSheetFields(const World& w, Frame& f) {
  const SheetBodies& b = w.sheets;
  const Sheets& s = b.rows;
  addRows<float>(f, "displacement", "m", 3,
                 [&s](std::size_t i, float* to) { put3(s.position[i] - s.rest[i], to); });
  addRows<std::uint8_t>(f, "color", "1", 3, [&w, &s](std::size_t i, std::uint8_t* to) {
    for (int c = 0; c < 3; c++)
      to[c] = static_cast<std::uint8_t>(w.scene.sheets[s.body[i]].colour >> 8 * c & 255);
  });
  addRows<std::uint32_t>(f, "part", "1", 1, [&s](std::size_t i, std::uint32_t* to) { *to = s.part[i]; });
  if (s.flow.active)
    addRows<float>(f, "plastic", "m", 3, [&s](std::size_t i, float* to) { put3(s.flow[i], to); });
  if (s.temperature.active)
    addRows<float>(f, "temperature", "K", 1,
                   [&s](std::size_t i, float* to) { *to = static_cast<float>(s.temperature[i]); });
}

void addSheetTriangles(SheetBodies& b, BondHalo& halo, std::uint64_t firstRow, Frame& f) {
  Solids& e = b.edges.ends;
  f.meshed = true;
  // Sends row numbers in place of positions. The force evaluation exchanges the positions again before use.
  for (std::size_t solidIndex = 0; solidIndex < e.owned; solidIndex++)
    e.position[solidIndex] = {static_cast<double>(firstRow + e.particle[solidIndex]), 0, 0};
  const std::array<AnyColumn*, 1> columns{&e.position};
  halo.begin(e, columns);
  halo.finish(e);
  for (std::size_t solidIndex = 0; solidIndex < e.owned; solidIndex++)
    for (int k = 0; k < b.edges.bonds.capacity; k++) {
      const int next = triangleWith(b.edges.bonds, solidIndex, k);
      if (next < 0) continue;
      const std::uint32_t p = b.edges.bonds.neighbour[b.edges.bonds.at(solidIndex, k)],
                          q = b.edges.bonds.neighbour[b.edges.bonds.at(solidIndex, next)];
      if (e.id[solidIndex] > e.id[p] || e.id[solidIndex] > e.id[q])
        continue;  // each triangle once, from its first corner
      for (const std::size_t row : {solidIndex, static_cast<std::size_t>(p), static_cast<std::size_t>(q)})
        f.triangles.push_back(static_cast<std::uint64_t>(e.position[row].x));
    }
}

}  // namespace thaw
