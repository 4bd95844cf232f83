// SPDX-License-Identifier: Apache-2.0
// Fields of a frame, row by row.
#pragma once
#include <cstring>

#include "io/frames/frame_fields.hpp"

namespace thaw {

/// Adds a field whose row i is fill(i, T out[components]), called when the frame is written. Its references
/// must live until then.
template<class T, class Fill>
void addRows(Frame& f, const std::string& name, const char* unit, int components, Fill fill) {
  f.fields.push_back({name, unit, FieldType<T>::scalar, components, nullptr,
                      [components, fill](const RowRange& local, std::byte* to) {
                        const std::size_t width = static_cast<std::size_t>(components) * sizeof(T);
                        T row[9] = {};
                        for (std::uint64_t i = local.first; i < local.first + local.count; i++, to += width) {
                          fill(static_cast<std::size_t>(i), row);
                          std::memcpy(to, row, width);
                        }
                      }});
}

template<class V> void put3(const V& v, float* to) {
  to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z);
}

/// Returns a frame of the current time with the positions and ids of a table's owned rows.
template<class Rows> Frame startFrame(const Clock& clock, const Rows& rows) {
  Frame f;
  f.time = clock.time;
  f.step = clock.step;
  f.count = rows.owned;
  addRows<float>(f, "position", "m", 3, [&rows](std::size_t i, float* to) { put3(rows.position[i], to); });
  f.positions = std::move(f.fields[0]);
  f.fields.clear();
  addRows<std::uint64_t>(f, "id", "1", 1, [&rows](std::size_t i, std::uint64_t* to) { *to = rows.id[i]; });
  return f;
}

}  // namespace thaw
