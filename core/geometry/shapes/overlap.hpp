// SPDX-License-Identifier: Apache-2.0
// Detection of overlapping bodies.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Number of samples of body a inside body b, for each pair of bodies with intersecting boxes
/// (OverlapTest::noCounts). Counts of all ranks are added for each pair.
struct OverlapCounts {
  std::vector<std::pair<std::size_t, std::size_t>> pair;  ///< (a, b), ascending
  std::vector<std::int64_t> count;                        ///< one per pair
  std::int64_t of(std::size_t a, std::size_t b) const;    ///< 0 for other pairs
  std::int64_t total() const;
};

/// Tests samples only against bodies with intersecting bounding boxes.
class OverlapTest {
 public:
  /// period: m, of the domain along periodic axes, 0 along other axes. Overlaps across periodic sides count.
  explicit OverlapTest(std::vector<std::shared_ptr<const SignedDistance>> bodies, const Vec3d& period = {});
  /// Returns all pairs with counts of 0.
  OverlapCounts noCounts() const;
  /// Counts the bodies that contain a sample of body a at x (m). Returns true if the rule keeps the sample.
  /// Error and Keep keep all samples. RemoveLater removes a sample inside an earlier body, RemoveEarlier a
  /// sample inside a later body. With Error, the caller stops the run if the counts over all ranks are not
  /// zero.
  bool keeps(std::size_t a, const Vec3d& x, OverlapRule rule, OverlapCounts& counts) const;
  /// Returns true if a periodic image of a sample of body a lies inside the same body.
  bool meetsItself(std::size_t a, const Vec3d& x) const;

 private:
  template<class Test> bool anyImage(std::size_t b, const Vec3d& x, Test&& test) const;
  std::vector<std::shared_ptr<const SignedDistance>> bodies_;
  std::vector<Bounds> bounds_;
  Vec3d period_;
  std::vector<std::size_t> near_;   ///< for each body the other bodies with intersecting boxes, ascending
  std::vector<std::size_t> first_;  ///< neighbours of body a: near_[first_[a]] to near_[first_[a + 1]]
};

/// Two bodies that overlap.
struct BodyOverlap {
  std::size_t first, second;  ///< bodies, in the order of the scene
  std::string text;           ///< "bodies 'a' and 'b' overlap: 12 particles of 'a' lie inside 'b', 10 of 'b'
                              ///< inside 'a'"
};

/// Returns all pairs that overlap. Requires: counts summed over all ranks.
std::vector<BodyOverlap> describeOverlaps(const OverlapCounts& counts, const std::vector<Body>& bodies);

}  // namespace thaw
