// Bodies that are placed into each other.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/signed_distance.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// Samples of body a that lie inside body b, for each pair of bodies whose boxes meet
/// (OverlapTest::noCounts). Counts of several ranks are added pair by pair.
struct OverlapCounts {
  std::vector<std::pair<std::size_t, std::size_t>> pair;  ///< (a, b), ascending
  std::vector<std::int64_t> count;                        ///< of each pair
  std::int64_t of(std::size_t a, std::size_t b) const;    ///< 0 of other pairs
  std::int64_t total() const;
};

/// Which bodies' bounding boxes meet, so that only those are looked at.
class OverlapTest {
 public:
  /// period: m, of the domain along its periodic axes, 0 along others; bodies meet across periodic sides,
  /// too.
  explicit OverlapTest(std::vector<std::shared_ptr<const SignedDistance>> bodies, const Vec3d& period = {});
  /// All pairs, with counts of 0.
  OverlapCounts noCounts() const;
  /// Counts the bodies that contain a sample of body a at x (m), and returns whether the rule keeps it: Error
  /// and Keep keep all, RemoveLater takes a sample away if an earlier body contains it, RemoveEarlier if a
  /// later one does. With Error the caller stops the run if the counts over all ranks are not zero.
  bool keeps(std::size_t a, const Vec3d& x, OverlapRule rule, OverlapCounts& counts) const;
  /// Does an image of a sample of body a lie inside that body again, which reaches round the domain?
  bool meetsItself(std::size_t a, const Vec3d& x) const;

 private:
  template<class Is> bool anyImage(std::size_t b, const Vec3d& x, Is&& is) const;
  std::vector<std::shared_ptr<const SignedDistance>> bodies_;
  std::vector<Bounds> bounds_;
  Vec3d period_;
  std::vector<std::size_t> near_;   ///< other bodies whose boxes meet that of each body, ascending
  std::vector<std::size_t> first_;  ///< those of body a: near_[first_[a]] to near_[first_[a + 1]]
};

/// "bodies 'a' and 'b' overlap: 12 particles of 'a' lie inside 'b', 10 of 'b' inside 'a'", one sentence a
/// pair. Counts of all ranks.
std::vector<std::string> describeOverlaps(const OverlapCounts& counts, const std::vector<Body>& bodies);

}  // namespace thaw
