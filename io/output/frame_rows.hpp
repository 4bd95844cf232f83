// Fields of a frame, filled row by row.
#pragma once
#include <cstring>

#include "io/output/frame_fields.hpp"

namespace thaw {

/// Adds a field whose row i is fill(i, T out[components]).
template<class T, class Fill> void addRows(WorldFrame& f, const char* name, const char* unit, int components, Fill&& fill) {
  const std::size_t width = static_cast<std::size_t>(components) * sizeof(T);
  std::vector<std::byte> bytes(f.frame.count * width);
  T row[9] = {};
  for (std::size_t i = 0; i < f.frame.count; i++) {
    fill(i, row);
    std::memcpy(bytes.data() + i * width, row, width);
  }
  f.storage.push_back(std::move(bytes));
  f.frame.fields.push_back({name, unit, FieldType<T>::scalar, components, f.storage.back().data()});
}

template<class V> void put3(const V& v, float* to) {
  to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z);
}

/// A frame of now with the places and ids of a table's owned rows.
template<class Rows> WorldFrame startFrame(const World& w, const Rows& rows) {
  WorldFrame f;
  f.frame.time = w.clock.time;
  f.frame.step = w.clock.step;
  f.frame.count = rows.owned;
  addRows<float>(f, "position", "m", 3, [&](std::size_t i, float* to) { put3(rows.position[i], to); });
  f.frame.positions = f.frame.fields[0];
  f.frame.fields.clear();
  addRows<std::uint64_t>(f, "id", "1", 1, [&](std::size_t i, std::uint64_t* to) { *to = rows.id[i]; });
  return f;
}

}  // namespace thaw
