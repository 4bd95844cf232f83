// SPDX-License-Identifier: Apache-2.0
#include "io/run/body_type_failure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/simulation/world/body_types.hpp"
#include "io/run/failure_text.hpp"

namespace thaw {

std::string bodyTypeFailure(const World& w, const StepTools& t, const StepOutcome& failed, Reducer& all) {
  const Failure failure = failed.failure;
  const Limit limitedBy = failed.limitedBy;
  if (!w.modules.bodyTypes()) return {};
  double continuum = static_cast<double>(w.particles.owned);
  all.maximum({&continuum, 1});
  double exceededReach = w.oriented.exceededReach ? 1 : 0;
  all.maximum({&exceededReach, 1});
  const bool byLimit = (failure == Failure::Step &&
                        (limitedBy == Limit::Oriented || limitedBy == Limit::Sheet)) ||
                       (failure == Failure::NotFinite && exceededReach > 0);
  const BodyTypeRows* rows = nullptr;
  std::size_t row = 0, kind = 0;
  double most = -1;
  forEachBodyType(w, [&](std::size_t number, const BodyTypeRows& r, const CellTable&) {
    for (std::size_t i = 0; i < r.owned; i++) {
      const Vec3d &x = r.position[i], &v = r.velocity[i];
      const bool bad = !std::isfinite(x.x + x.y + x.z + v.x + v.y + v.z);
      if (!bad && continuum > 0 && !byLimit) continue;
      const double g = bad ? never : dot(v, v);
      if (g < most || (g == most && rows && (number > kind || (number == kind && r.id[i] > rows->id[row]))))
        continue;
      rows = &r, row = i, kind = number, most = g;
    }
  });
  double worst = most;
  all.maximum({&worst, 1});
  bool here = rows && most == worst;
  // Finds the lowest type, then the lowest id. The upper and lower halves of the id are compared in turn,
  // since a double has 53 bits.
  for (int part = 0; part < 3; part++) {
    const double value = !here ? -never
                               : -static_cast<double>(
                                     part == 0 ? kind : rows->id[row] >> (part == 1 ? 32 : 0) & 0xffffffffu);
    double lowest = value;
    all.maximum({&lowest, 1});
    here = here && value == lowest;
  }
  if (!here) return {};
  const std::uint16_t body = rows->body[row];
  const bool oriented = kind == orientedType;
  std::string what = failedCheck(w, t, failed) + "; the fastest one";
  if (exceededReach > 0)
    what = "oriented particles moved further in a step than their forces reach; the fastest remaining one";
  if (most == never) what = "a value that is not a finite number";
  return fmt::format("{}: {} {} of '{}' at {} m has a velocity of {} m/s", what,
                     oriented ? "oriented particle" : "vertex",
                     rows->id[row] & ((std::uint64_t(1) << 40) - 1),
                     oriented ? w.scene.oriented[body].name : w.scene.sheets[body].name,
                     shortVectorText(rows->position[row]), shortVectorText(rows->velocity[row]));
}

}  // namespace thaw
