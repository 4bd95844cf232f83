#include "core/oriented/relax_progress.hpp"

#include <cmath>

namespace thaw {
namespace {

constexpr double halved = 0.5, grown = 1.01;
constexpr double fewest = 2000, perLength = 50;  // iterations; per particle along the surface

}  // namespace

std::int64_t relaxPatience(std::int64_t particles) { return static_cast<std::int64_t>(fewest + perLength * std::sqrt(static_cast<double>(particles))); }

bool getsAnywhere(RelaxProgress& p, std::int64_t done, double force, std::int64_t particles) {
  if (static_cast<double>(particles) > grown * static_cast<double>(p.most)) {  // what was at rest was so with less
    p = {force, particles, done};
  } else if (force < halved * p.least) {
    p.least = force;
    p.gained = done;
  }
  return done - p.gained < relaxPatience(p.most);
}

}  // namespace thaw
