#include "core/surface/point_bins.hpp"

namespace thaw {

void PointBins::build(const Vec3d* at, std::size_t n, double edge) {
  edge_ = edge;
  key_.clear();
  first_.clear();
  row_.resize(n);
  at_.resize(n);
  if (n == 0) return;
  low_ = at[0];
  for (std::size_t i = 1; i < n; i++)
    for (int a = 0; a < 3; a++) low_[a] = std::min(low_[a], at[i][a]);
  sorted_.resize(n);
  for (std::size_t i = 0; i < n; i++) sorted_[i] = {key(bin(at[i])), static_cast<std::uint32_t>(i)};
  std::sort(sorted_.begin(), sorted_.end());
  for (std::size_t k = 0; k < n; k++) {
    if (key_.empty() || key_.back() != sorted_[k].first) {
      key_.push_back(sorted_[k].first);
      first_.push_back(static_cast<std::uint32_t>(k));
    }
    row_[k] = sorted_[k].second;
    at_[k] = at[row_[k]];
  }
  first_.push_back(static_cast<std::uint32_t>(n));
}

}  // namespace thaw
