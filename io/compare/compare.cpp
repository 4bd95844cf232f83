// SPDX-License-Identifier: Apache-2.0
#include "io/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "core/simulation/world/body_types.hpp"

namespace thaw {
namespace {

template<class T> T load(const std::byte* at) {
  T v;
  std::memcpy(&v, at, sizeof(T));
  return v;
}

double numberAt(Element e, const std::byte* at) {
  switch (e) {
    case Element::F64: return load<double>(at);
    case Element::F32: return static_cast<double>(load<float>(at));
    case Element::U64: return static_cast<double>(load<std::uint64_t>(at));
    case Element::U32: return load<std::uint32_t>(at);
    case Element::U16: return load<std::uint16_t>(at);
    case Element::U8: return load<std::uint8_t>(at);
    case Element::I64: return static_cast<double>(load<std::int64_t>(at));
    case Element::I32: return load<std::int32_t>(at);
    case Element::Other: break;
  }
  return 0;
}

std::string textAt(Element e, const std::byte* at) {
  if (e == Element::F64) return fmt::format("{:.17g} (0x{:016x})", load<double>(at), load<std::uint64_t>(at));
  if (e == Element::F32) return fmt::format("{:.9g} (0x{:08x})", load<float>(at), load<std::uint32_t>(at));
  if (e == Element::U64) return fmt::format("{0} (0x{0:x})", load<std::uint64_t>(at));
  if (e == Element::I64) return fmt::format("{} (0x{:x})", load<std::int64_t>(at), load<std::uint64_t>(at));
  return fmt::format("{} (0x{:x})", numberAt(e, at), static_cast<std::uint64_t>(numberAt(e, at)));
}

bool floating(Element e) { return e == Element::F64 || e == Element::F32; }

/// |a - b|; infinite if exactly one is NaN.
double distance(double a, double b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) && std::isnan(b) ? 0 : std::numeric_limits<double>::infinity();
  return a == b ? 0 : std::abs(a - b);
}

bool within(double a, double b, double allowed) { return distance(a, b) <= allowed; }

/// One column of both files, in memory.
struct ColumnPair {
  const SnapshotColumn& column;
  std::vector<std::byte> a, b;
  double allowed = -1;  // < 0: bit by bit
  std::size_t bytes, components;

  ColumnPair(const Snapshot& fileA, const SnapshotColumn& ca, const Snapshot& fileB, const SnapshotColumn& cb,
             double tolerance)
      : column(ca),
        bytes(bytesOf(ca.shape.element)),
        components(static_cast<std::size_t>(std::max(ca.shape.components, 1))) {
    a.resize(ca.shape.rows * ca.shape.rowBytes());
    b.resize(cb.shape.rows * cb.shape.rowBytes());
    fileA.file.read(ca.path, {0, ca.shape.rows}, ca.shape.element, a.data());
    fileB.file.read(cb.path, {0, cb.shape.rows}, cb.shape.element, b.data());
    if (tolerance < 0 || !floating(ca.shape.element)) return;
    double scale = 0;
    for (const std::vector<std::byte>* v : {&a, &b})
      for (std::size_t k = 0; k < v->size(); k += bytes)
        if (const double x = std::abs(numberAt(ca.shape.element, v->data() + k)); std::isfinite(x))
          scale = std::max(scale, x);
    allowed = tolerance * scale;
  }

  bool same(const std::byte* x, const std::byte* y) const {
    if (std::memcmp(x, y, bytes) == 0) return true;
    return allowed >= 0 &&
           within(numberAt(column.shape.element, x), numberAt(column.shape.element, y), allowed);
  }

  /// Compares a row of each and adds differences to `d`. which: bond of the id, for the text. Returns true if
  /// they are equal.
  bool row(std::uint64_t rowA, std::uint64_t rowB, std::uint64_t id, const std::string& which,
           FieldDifference& d) const {
    bool equal = true;
    for (std::size_t c = 0; c < components; c++) {
      const std::byte *x = a.data() + (rowA * components + c) * bytes,
                      *y = b.data() + (rowB * components + c) * bytes;
      if (same(x, y)) continue;
      if (d.first.empty()) {
        d.firstId = id;
        const std::string part = components > 1 ? fmt::format(" component {}", c) : std::string();
        d.first = fmt::format("{}{} of id {}{}: A {}, B {}", d.field, part, id, which,
                              textAt(column.shape.element, x), textAt(column.shape.element, y));
      }
      const double far = distance(numberAt(column.shape.element, x), numberAt(column.shape.element, y));
      if (equal && d.rows == 0) d.largestId = id;
      if (far > d.largest) d.largest = far, d.largestId = id;
      equal = false;
    }
    return equal;
  }
};

/// Rows of A and B with the same id, ascending by id.
struct Match {
  std::uint64_t id, a, b;
};

/// Ids in only one of the files.
struct Unmatched {
  std::uint64_t count = 0, first = 0, row = 0;
  void add(std::uint64_t id, std::uint64_t at) {
    if (count++ == 0) first = id, row = at;
  }
};

/// Returns the position of the first unmatched row. Ids of born surfels are hashes without meaning to users.
std::string placeOf(const Snapshot& file, const SnapshotTable& t, const Unmatched& u) {
  const auto at = std::find_if(t.columns.begin(), t.columns.end(), [](const SnapshotColumn& c) {
    return c.name == "position" && c.shape.components == 3;
  });
  if (at == t.columns.end()) return {};
  double x[3] = {};
  file.file.read(at->path, {u.row, 1}, Element::F64, x);
  return fmt::format(" at ({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
}

std::vector<Match> matchIds(const Snapshot& fileA, const SnapshotTable& a, const Snapshot& fileB,
                            const SnapshotTable& b, Comparison& result) {
  std::vector<Match> both;
  Unmatched onlyA, onlyB;
  std::uint64_t twice = 0;
  std::size_t i = 0, k = 0;
  while (i < a.order.size() || k < b.order.size()) {
    const std::uint64_t x = i < a.order.size() ? a.ids[a.order[i]] : 0,
                        y = k < b.order.size() ? b.ids[b.order[k]] : 0;
    if (k == b.order.size() || (i < a.order.size() && x < y)) {
      onlyA.add(x, a.order[i]);
      i++;
    } else if (i == a.order.size() || y < x) {
      onlyB.add(y, b.order[k]);
      k++;
    } else {
      if (!both.empty() && both.back().id == x) twice++;
      both.push_back({x, a.order[i++], b.order[k++]});
    }
  }
  if (onlyA.count > 0)
    result.general.push_back(fmt::format("{}: {} ids are in A only, the first {}{}", a.title, onlyA.count,
                                         onlyA.first, placeOf(fileA, a, onlyA)));
  if (onlyB.count > 0)
    result.general.push_back(fmt::format("{}: {} ids are in B only, the first {}{}", a.title, onlyB.count,
                                         onlyB.first, placeOf(fileB, b, onlyB)));
  if (twice > 0) result.general.push_back(fmt::format("{}: {} ids are duplicates", a.title, twice));
  return both;
}

/// Calls use(column of A, column of B) for columns in both with the same type; reports the others.
template<class Use>
void eachColumn(const std::string& title, const std::vector<SnapshotColumn>& a,
                const std::vector<SnapshotColumn>& b, Comparison& result, Use&& use) {
  for (const SnapshotColumn& x : a) {
    const auto y = std::find_if(b.begin(), b.end(),
                                [&](const SnapshotColumn& c) { return c.name == x.name; });
    if (y == b.end()) result.general.push_back(fmt::format("{}: field {} is in A only", title, x.name));
    else if (y->shape.element != x.shape.element ||
             std::max(y->shape.components, 1) != std::max(x.shape.components, 1))
      result.general.push_back(fmt::format("{}: field {} is {} x {} in A and {} x {} in B", title, x.name,
                                           nameOf(x.shape.element), std::max(x.shape.components, 1),
                                           nameOf(y->shape.element), std::max(y->shape.components, 1)));
    else if (x.shape.element != Element::Other) use(x, *y);
  }
  for (const SnapshotColumn& y : b)
    if (std::none_of(a.begin(), a.end(), [&](const SnapshotColumn& c) { return c.name == y.name; }))
      result.general.push_back(fmt::format("{}: field {} is in B only", title, y.name));
}

void compareBonds(const Snapshot& a, const SnapshotTable& ta, const Snapshot& b, const SnapshotTable& tb,
                  const std::vector<Match>& both, const CompareRule& rule, Comparison& result) {
  std::vector<Match> same;  // with the same number of bonds in both
  FieldDifference count{ta.title, "number of bonds", "1", 0, 0, {}, 0, 0, both.size()};
  for (const Match& m : both) {
    const std::uint64_t na = ta.firstBond[m.a + 1] - ta.firstBond[m.a],
                        nb = tb.firstBond[m.b + 1] - tb.firstBond[m.b];
    if (na == nb) {
      same.push_back(m);
      continue;
    }
    if (count.rows++ == 0) {
      count.firstId = m.id;
      count.first = fmt::format("number of bonds of id {}: A {}, B {}", m.id, na, nb);
    }
    if (const double far = std::abs(static_cast<double>(na) - static_cast<double>(nb)); far > count.largest)
      count.largest = far, count.largestId = m.id;
  }
  if (count.rows > 0) result.fields.push_back(count);
  eachColumn(ta.title, ta.bonds, tb.bonds, result, [&](const SnapshotColumn& x, const SnapshotColumn& y) {
    const ColumnPair pair(a, x, b, y, rule.tolerance);
    FieldDifference d{ta.title, x.name, x.unit, 0, 0, {}, 0, 0, both.size()};
    for (const Match& m : same) {
      bool equal = true;
      const std::uint64_t fa = ta.firstBond[m.a], fb = tb.firstBond[m.b], n = ta.firstBond[m.a + 1] - fa;
      for (std::uint64_t k = 0; k < n; k++)
        if (!pair.row(fa + k, fb + k, m.id, fmt::format(" bond {}", k), d)) equal = false;
      d.rows += !equal;
    }
    result.columns++;
    if (d.rows > 0) result.fields.push_back(d);
  });
}

void compareNumbers(const Snapshot& a, const Snapshot& b, const CompareRule& rule, Comparison& result) {
  std::map<std::string, double> scale;  // largest value by unit
  for (const Snapshot* s : {&a, &b})
    for (const SnapshotNumber& n : s->numbers)
      if (std::isfinite(n.value)) scale[n.unit] = std::max(scale[n.unit], std::abs(n.value));
  for (const SnapshotNumber& x : a.numbers) {
    const auto y = std::find_if(b.numbers.begin(), b.numbers.end(),
                                [&](const SnapshotNumber& n) { return n.name == x.name; });
    if (y == b.numbers.end()) {
      result.general.push_back(fmt::format("{} is in A only", x.name));
      continue;
    }
    const bool bits = x.integer == y->integer && x.digits == y->digits &&
                      std::bit_cast<std::uint64_t>(x.value) == std::bit_cast<std::uint64_t>(y->value);
    if (bits ||
        (rule.tolerance >= 0 && !x.whole && within(x.value, y->value, rule.tolerance * scale[x.unit])))
      continue;
    if (x.whole) result.general.push_back(fmt::format("{}: A {}, B {}", x.name, x.integer, y->integer));
    else
      result.general.push_back(fmt::format("{}: A {:.17g} (0x{:016x}), B {:.17g} (0x{:016x}) {}{}", x.name,
                                           x.value, std::bit_cast<std::uint64_t>(x.value), y->value,
                                           std::bit_cast<std::uint64_t>(y->value), x.unit,
                                           x.value == y->value ? ", the exact sums differ" : ""));
  }
  for (const SnapshotNumber& y : b.numbers)
    if (std::none_of(a.numbers.begin(), a.numbers.end(),
                     [&](const SnapshotNumber& n) { return n.name == y.name; }))
      result.general.push_back(fmt::format("{} is in B only", y.name));
}

void compareValues(const Snapshot& a, const Snapshot& b, Comparison& result) {
  for (const auto& [name, text] : a.values) {
    const auto other = b.values.find(name);
    if (other == b.values.end()) result.general.push_back(name + " is in A only");
    else if (other->second != text)
      result.general.push_back(fmt::format("{}: A {}, B {}", name, text, other->second));
  }
  for (const auto& [name, text] : b.values)
    if (!a.values.contains(name)) result.general.push_back(name + " is in B only");
}

constexpr std::size_t mostPerGroup = 4;

/// Adds the first lines of each group, by first word, in order of appearance: dissimilar scenes differ in
/// hundreds of values.
void addFewPerGroup(const std::vector<std::string>& all, std::vector<std::string>& lines) {
  const auto kindOf = [](const std::string& line) { return line.substr(0, line.find_first_of(".: ") + 1); };
  std::map<std::string, std::size_t> shown;
  for (const std::string& line : all)
    if (shown[kindOf(line)]++ < mostPerGroup) lines.push_back(line);
  for (const auto& [kind, count] : shown)
    if (count > mostPerGroup)
      lines.push_back(fmt::format("... and {} more of {} (--all lists them)", count - mostPerGroup,
                                  kind.substr(0, kind.size() - 1)));
}

}  // namespace

Comparison compareSnapshots(const Snapshot& a, const Snapshot& b, const CompareRule& rule) {
  Comparison result;
  if (a.kind != b.kind) {
    result.general.push_back(fmt::format("A is a {}, B a {}", a.kind, b.kind));
    return result;
  }
  compareNumbers(a, b, rule, result);
  compareValues(a, b, result);
  for (const SnapshotTable& ta : a.tables) {
    const auto tb = std::find_if(b.tables.begin(), b.tables.end(),
                                 [&](const SnapshotTable& t) { return t.title == ta.title; });
    if (tb == b.tables.end()) {
      if (!ta.ids.empty()) result.general.push_back(ta.title + " are in A only");
      continue;
    }
    const std::vector<Match> both = matchIds(a, ta, b, *tb, result);
    // first table with common ids
    if (result.rows == 0 && (&ta == a.tables.data() || !both.empty()))
      result.rows = both.size(), result.title = ta.title;
    else if (ta.title == "surfels" || ta.title == bodyTypeNames[orientedType] ||
             ta.title == bodyTypeNames[sheetType])
      result.compared.push_back({ta.title, both.size()});
    if (ta.ids.empty() && tb->ids.empty()) continue;
    eachColumn(ta.title, ta.columns, tb->columns, result,
               [&](const SnapshotColumn& x, const SnapshotColumn& y) {
                 const ColumnPair pair(a, x, b, y, rule.tolerance);
                 FieldDifference d{ta.title, x.name, x.unit, 0, 0, {}, 0, 0, both.size()};
                 for (const Match& m : both)
                   if (!pair.row(m.a, m.b, m.id, {}, d)) d.rows++;
                 result.columns++;
                 if (d.rows > 0) result.fields.push_back(d);
               });
    if (!ta.firstBond.empty() && !tb->firstBond.empty()) compareBonds(a, ta, b, *tb, both, rule, result);
  }
  for (const SnapshotTable& tb : b.tables)
    if (!tb.ids.empty() && std::none_of(a.tables.begin(), a.tables.end(),
                                        [&](const SnapshotTable& t) { return t.title == tb.title; }))
      result.general.push_back(tb.title + " are in B only");
  return result;
}

std::vector<std::string> describe(const Comparison& c, bool all) {
  std::string compared = fmt::format("{} {}", c.rows, c.title);
  for (const auto& [title, rows] : c.compared) compared += fmt::format(", {} {}", rows, title);
  compared += fmt::format(", {} fields", c.columns);
  if (c.equal()) return {"equal: " + compared};
  std::vector<std::string> lines{"different"};
  if (all) lines.insert(lines.end(), c.general.begin(), c.general.end());
  else addFewPerGroup(c.general, lines);
  if (!c.fields.empty()) {
    const auto first = std::min_element(
        c.fields.begin(), c.fields.end(),
        [](const FieldDifference& a, const FieldDifference& b) { return a.firstId < b.firstId; });
    lines.push_back("first difference: " + first->first);
    for (const FieldDifference& d : c.fields)
      lines.push_back(fmt::format("{} {}: {} of {} ids differ, by at most {:.3g} {} at id {}", d.table,
                                  d.field, d.rows, d.ids, d.largest, d.unit, d.largestId));
  }
  if (c.columns > 0) lines.push_back("compared, of ids in both: " + compared);
  return lines;
}

}  // namespace thaw
