// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_places.hpp"

#include <fmt/format.h>

namespace thaw {
namespace {

/// The longest key of a scene table that begins a text.
struct Search {
  const std::string& text;
  std::size_t longest = 0;
  SourcePlace where{};
  void table(const std::string& key, const SourcePlace& place) {
    if (key.size() < longest || text.compare(0, key.size(), key) != 0 || place.line <= 0) return;
    longest = key.size();
    where = place;
  }
  template<class List> void list(const std::string& key, const List& items) {
    for (std::size_t k = 0; k < items.size(); k++) table(fmt::format("{}{}.", key, k), items[k].where);
  }
};

}  // namespace

std::string placeOfRecordKey(const Scene& s, const std::string& text) {
  Search search{text};
  for (const Material& m : s.materials) search.table("material." + m.name + ".", m.where);
  for (const Emitter& e : s.emitters) search.table("emitter." + e.name + ".", e.where);
  for (const Obstacle& o : s.obstacles) search.table("obstacle." + o.name + ".", o.where);
  for (const Body& b : s.bodies) {
    const std::string at = "body." + b.name + ".";
    search.table(at, b.where);
    search.list(at + "clamp.", b.clamp);
  }
  for (const SheetBody& b : s.sheets) {
    const std::string at = "sheet." + b.name + ".";
    search.table(at, b.where);
    search.list(at + "clamp.", b.clamp);
    search.list(at + "region.", b.regions);
    search.list(at + "brush.", b.brushes);
  }
  for (const OrientedBody& b : s.oriented) {
    const std::string at = "oriented." + b.name + ".";
    search.table(at, b.where);
    search.list(at + "anchor.", b.anchors);
    search.list(at + "field.", b.fields);
    search.list(at + "event.", b.events);
  }
  if (text.starts_with("surface.")) search.table("surface.", s.surface.where);
  return search.where.line > 0 ? fmt::format(" ({}:{})", search.where.file, search.where.line) : "";
}

}  // namespace thaw
