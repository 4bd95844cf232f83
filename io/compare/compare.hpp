// Whether two frames or checkpoints have the same bits for every id, and where not.
#pragma once
#include <string>
#include <vector>

#include "io/compare/snapshot.hpp"

namespace thaw {

struct CompareRule {
  /// < 0: bit by bit. Else floating-point values may differ by this times the largest magnitude of their
  /// field in either file; integers must be equal even so. NaN equals NaN only.
  double tolerance = -1;
};

/// Differences of one field.
struct FieldDifference {
  std::string table, field, unit;
  std::uint64_t rows = 0;     ///< ids with a difference
  std::uint64_t firstId = 0;  ///< the smallest of them
  std::string first;          ///< both values there, in full precision and in hex
  double largest = 0;         ///< largest |a - b|
  std::uint64_t largestId = 0;
  std::uint64_t ids = 0;  ///< in both files
};

struct Comparison {
  std::vector<std::string> general;     ///< different kinds, times, sets of ids, missing fields, numbers
  std::vector<FieldDifference> fields;  ///< those that differ
  std::uint64_t rows = 0, columns = 0;  ///< ids in both (of the first table), fields compared
  std::string title = "particles";      ///< of the first table
  std::vector<std::pair<std::string, std::uint64_t>> kinds;  ///< title and ids in both, of surfels, oriented
                                                             ///< particles and sheets that are not the first
                                                             ///< table
  bool equal() const { return general.empty() && fields.empty(); }
};

/// IoError for files that cannot be read.
Comparison compareSnapshots(const Snapshot& a, const Snapshot& b, const CompareRule& rule);

/// Lines for people: what is different in general, unless `all` a few lines of each kind and a count of the
/// others; the first difference of fields, then the largest of each.
std::vector<std::string> describe(const Comparison& comparison, bool all = false);

}  // namespace thaw
