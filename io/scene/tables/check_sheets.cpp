// SPDX-License-Identifier: Apache-2.0
// Checks sheets against the rest of the scene, and their coefficients against each other.
#include <fmt/format.h>

#include <algorithm>

#include "core/sheet/data/shrink_wrap_target.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/nearest_word.hpp"

namespace thaw {
namespace {

void checkWrap(const Scene& s, std::size_t n, std::vector<SceneError>& errors) {
  const SheetBody& b = s.sheets[n];
  if (b.shrinkWrapTo.empty()) return;
  const std::vector<ShrinkWrapTarget> found = shrinkWrapTargets(s, b.shrinkWrapTo);
  const auto refuse = [&](const std::string& text) {
    errors.push_back({b.where, "sheet '" + b.name + "': shrink_wrap_to: " + text});
  };
  if (found.empty()) {
    std::set<std::string> names;
    const auto add = [&](const auto& list) {
      for (const auto& item : list) names.insert(item.name);
    };
    add(s.obstacles), add(s.bodies), add(s.emitters), add(s.oriented), add(s.sheets);
    names.erase(b.name);
    refuse("unknown obstacle or body '" + b.shrinkWrapTo + "'" + suggestion(b.shrinkWrapTo, names));
  } else if (found.size() > 1) {
    refuse("'" + b.shrinkWrapTo + "' is the name of several objects of the scene; expected a unique name");
  } else if (found[0] == ShrinkWrapTarget{ShrinkWrapKind::Sheet, static_cast<std::uint16_t>(n)}) {
    refuse("a sheet cannot wrap around itself; omit `shrink_wrap_to` to shrink against its own normals");
  }
}

/// Returns the name of a force on a vertex that depends on its position, other than the spring to its rest
/// position. Returns "" if there is none.
std::string positionDependentForce(const Scene& s, const SheetBody& b) {
  if (b.warp > 0 || b.weft > 0 || b.shear > 0 || b.bending > 0 || b.volumeStiffness > 0 || b.repulsion > 0 ||
      b.attraction > 0)
    return "forces of its neighbours";
  if (!b.pressureBrushes.empty()) return "the pressure of a pressure brush";
  if (b.shrinkWrap != 0) return "the pressure of the shrink-wrap";
  if (!s.obstacles.empty()) return "contact with obstacles";
  for (const auto& axis : s.domain.side)
    for (const Side side : axis)
      if (side == Side::Wall) return "contact with walls of the domain";
  if (!s.bodies.empty() || !s.emitters.empty() || !s.oriented.empty() || s.sheets.size() > 1)
    return "contact with other bodies";
  if (b.selfContact) return "contact with other vertices";
  return "";
}

/// Checks mass, damping and stiffness of a sheet or a region, at their smallest in time.
void checkInertia(const Scene& s, const SheetBody& b, const SheetRegion* r, std::vector<SceneError>& errors) {
  const auto factor = [&](SheetFactor f) { return r ? r->factor[placeOf(f)] : 1.0; };
  const auto least = [&](SheetFactor f) {
    return b.inTime[placeOf(f)].least(0, never) * factor(f) * b.*sheetCoefficients[placeOf(f)].value;
  };
  if (b.mass * factor(SheetFactor::Mass) > 0) return;
  const std::string who = r ? fmt::format("sheet '{}': this region", b.name)
                            : fmt::format("sheet '{}': mass", b.name);
  const SourcePlace where = r ? r->where : b.massWhere;
  const bool damped = least(SheetFactor::Damping) > 0;
  if (!damped && !(least(SheetFactor::Stiffness) > 0)) {
    errors.push_back({where, who + (r ? ": mass, damping and stiffness must not all be zero at the same time"
                                      : ": must not be zero while damping and stiffness are: set one of the "
                                        "three")});
    return;
  }
  if (const std::string force = positionDependentForce(s, b); !damped && !force.empty())
    errors.push_back({where, who + ": a massless, undamped vertex has no stable step under " + force +
                                 ": expected mass, or damping at all times"});
  if (r && b.windDensity * factor(SheetFactor::Wind) > 0)
    errors.push_back({where, who + ": the air's drag on vertices without mass has no stable step: expected "
                                   "mass > 0, or `wind_density = 0` there"});
}

}  // namespace

void checkSheets(const Scene& s, std::vector<SceneError>& errors) {
  for (std::size_t n = 0; n < s.sheets.size(); n++) {
    const SheetBody& b = s.sheets[n];
    checkWrap(s, n, errors);
    checkInertia(s, b, nullptr, errors);
    if (b.mass > 0)  // otherwise the error of the whole sheet is enough
      for (const SheetRegion& r : b.regions) checkInertia(s, b, &r, errors);
  }
}

}  // namespace thaw
