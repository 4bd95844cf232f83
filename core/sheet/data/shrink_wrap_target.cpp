// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/shrink_wrap_target.hpp"

#include "core/geometry/basic/shape_error.hpp"

namespace thaw {

std::vector<ShrinkWrapTarget> shrinkWrapTargets(const Scene& s, const std::string& name) {
  std::vector<ShrinkWrapTarget> found;
  const auto look = [&](const auto& list, ShrinkWrapKind kind, std::size_t first) {
    for (std::size_t k = 0; k < list.size(); k++)
      if (list[k].name == name) found.push_back({kind, static_cast<std::uint16_t>(first + k)});
  };
  look(s.obstacles, ShrinkWrapKind::Obstacle, 0);
  look(s.bodies, ShrinkWrapKind::Continuum, 0);
  look(s.emitters, ShrinkWrapKind::Continuum, s.bodies.size());
  look(s.oriented, ShrinkWrapKind::Oriented, 0);
  look(s.sheets, ShrinkWrapKind::Sheet, 0);
  return found;
}

ShrinkWrapTarget shrinkWrapTarget(const Scene& s, std::size_t sheet) {
  const SheetBody& b = s.sheets[sheet];
  if (b.shrinkWrapTo.empty()) return {};
  const std::vector<ShrinkWrapTarget> found = shrinkWrapTargets(s, b.shrinkWrapTo);
  if (found.empty())
    throw ShapeError("shrink_wrap_to: unknown obstacle or body '" + b.shrinkWrapTo + "'", b.where);
  if (found.size() > 1)
    throw ShapeError(
        "shrink_wrap_to: '" + b.shrinkWrapTo + "' names several objects of the scene; expected a unique name",
        b.where);
  if (found[0] == ShrinkWrapTarget{ShrinkWrapKind::Sheet, static_cast<std::uint16_t>(sheet)})
    throw ShapeError(
        "shrink_wrap_to: a sheet cannot wrap around itself; omit `shrink_wrap_to` to shrink against its own "
        "normals",
        b.where);
  return found[0];
}

}  // namespace thaw
