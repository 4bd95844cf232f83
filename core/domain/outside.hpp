// What of a body begins outside of the domain: how much, beyond which sides, and how far.
#pragma once
#include <cstdint>
#include <string>

#include "core/halo/halo.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Outside {
  std::int64_t count = 0;
  double beyond[3][2] = {{-1, -1}, {-1, -1}, {-1, -1}};  ///< m, [axis][low, high], of the farthest; below 0:
                                                         ///< none
  /// Notes a place that is outside, and says whether it is.
  bool look(const Domain& domain, const Vec3d& x);
};

/// Over all ranks, for each of a list. Collective.
void addUp(std::span<Outside> all, Reducer& reducer);

/// "60 of its 125 particles lie outside of the domain, up to 0.05 m beyond its side x = 0.5 m; enlarge the
/// domain or move the body". rows: what they are called, what: what is to be moved.
std::string outsideText(const Outside& outside, const Domain& domain, std::int64_t all, const char* rows,
                        const char* what);

}  // namespace thaw
