#include "core/oriented/follow_given.hpp"

#include "core/oriented/population.hpp"

namespace thaw {
namespace {

constexpr double lost = 0.8;     // spacings
constexpr double strength = 4;   // of the spring, over the body's stiffness

bool follows(const World& w, const StepTools& t, std::size_t i) {
  const Oriented& o = w.oriented.rows;
  return !t.oriented.given[o.body[i]].points.empty() && !(o.flags[i] & heldPlace);
}

}  // namespace

std::int64_t findPlacesOnGiven(World& w, const StepTools& t) {
  Oriented& o = w.oriented.rows;
  std::int64_t dead = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!follows(w, t, i)) continue;
    Vec3d place = o.position[i], normal = axisOf(o.orientation[i]);
    const double far = lost * t.oriented.potentials[o.body[i]].spacing;
    if (projectOnGiven(t.oriented.given[o.body[i]], place, normal) && dot(place - o.position[i], place - o.position[i]) < far * far) {
      o.home[i] = place;
      o.homeTurn[i] = towards(normal);
      continue;
    }
    letGo(w, i, 0);
    dead++;
  }
  w.counters.orientedDeaths += dead;
  return dead;
}

void followGiven(const World& w, const StepTools& t, std::vector<Vec3d>& force, std::vector<Vec3d>& torque) {
  const Oriented& o = w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!follows(w, t, i)) continue;
    const double k = strength * w.scene.oriented[o.body[i]].stiffness, s = t.oriented.potentials[o.body[i]].spacing;
    const Vec3d n = axisOf(o.homeTurn[i]);
    force[i] -= (k * dot(o.position[i] - o.home[i], n)) * n;
    torque[i] += (k * s * s) * cross(o.normal[i], n);
  }
}

}  // namespace thaw
