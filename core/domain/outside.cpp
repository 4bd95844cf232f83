// SPDX-License-Identifier: Apache-2.0
#include "core/domain/outside.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace thaw {

bool Outside::look(const Domain& d, const Vec3d& x) {
  if (d.holds(x)) return false;
  count++;
  for (int a = 0; a < 3; a++) {
    if (x[a] < d.min[a]) beyond[a][0] = std::max(beyond[a][0], d.min[a] - x[a]);
    if (x[a] >= d.max[a]) beyond[a][1] = std::max(beyond[a][1], x[a] - d.max[a]);
  }
  return true;
}

void addUp(std::span<Outside> all, Reducer& reducer) {
  std::vector<std::int64_t> counts;
  std::vector<double> farthest;
  for (const Outside& o : all) {
    counts.push_back(o.count);
    for (const auto& axis : o.beyond) farthest.insert(farthest.end(), axis, axis + 2);
  }
  reducer.sum(counts);
  reducer.maximum(farthest);
  std::size_t n = 0;
  for (Outside& o : all) {
    o.count = counts[n / 6];
    for (auto& axis : o.beyond)
      for (double& side : axis) side = farthest[n++];
  }
}

std::string outsideText(const Outside& o, const Domain& d, std::int64_t all, const char* rows,
                        const char* what) {
  std::string sides;
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++) {
      if (o.beyond[a][high] < 0) continue;
      char text[120];
      std::snprintf(text, sizeof text, "%s %.3g m beyond its side %c = %g m",
                    sides.empty() ? ", up to" : " and", o.beyond[a][high], "xyz"[a],
                    high ? d.max[a] : d.min[a]);
      sides += text;
    }
  return std::to_string(o.count) + " of its " + std::to_string(all) + " " + rows +
         (o.count == 1 ? " lies" : " lie") + " outside of the domain" + sides +
         "; enlarge the domain or move the " + what;
}

}  // namespace thaw
