// SPDX-License-Identifier: Apache-2.0
// Comparison of two frames or checkpoints, bit by bit for every id.
#pragma once
#include <string>
#include <vector>

#include "io/compare/snapshot.hpp"

namespace thaw {

struct CompareRule {
  /// < 0: bit by bit. Otherwise floating-point values may differ by this times the largest magnitude of their
  /// field in either file. Integers must be equal. NaN equals NaN only.
  double tolerance = -1;
};

/// Differences of one field.
struct FieldDifference {
  std::string table, field, unit;
  std::uint64_t rows = 0;     ///< ids with a difference
  std::uint64_t firstId = 0;  ///< smallest such id
  std::string first;          ///< both values there, in full precision and in hex
  double largest = 0;         ///< largest |a - b|
  std::uint64_t largestId = 0;
  std::uint64_t ids = 0;  ///< ids in both files
};

struct Comparison {
  std::vector<std::string> general;     ///< different types, times, sets of ids, missing fields, numbers
  std::vector<FieldDifference> fields;  ///< fields with differences
  std::uint64_t rows = 0, columns = 0;  ///< ids in both files (first table), fields compared
  std::string title = "particles";      ///< title of the first table
  std::vector<std::pair<std::string, std::uint64_t>> compared;  ///< title and common ids of surfels, oriented
                                                                ///< particles and sheets, if not the first
                                                                ///< table
  bool equal() const { return general.empty() && fields.empty(); }
};

/// Throws IoError for files that cannot be read.
Comparison compareSnapshots(const Snapshot& a, const Snapshot& b, const CompareRule& rule);

/// Returns lines of text: general differences, the first difference of a field, and the largest difference of
/// each field. Unless `all`, general differences are a few per type and a count of the rest.
std::vector<std::string> describe(const Comparison& comparison, bool all = false);

}  // namespace thaw
