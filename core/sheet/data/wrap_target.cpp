// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/wrap_target.hpp"

#include "core/geometry/basic/shape_error.hpp"

namespace thaw {

std::vector<WrapTarget> wrapTargets(const Scene& s, const std::string& name) {
  std::vector<WrapTarget> found;
  const auto look = [&](const auto& list, WrapKind kind, std::size_t first) {
    for (std::size_t k = 0; k < list.size(); k++)
      if (list[k].name == name) found.push_back({kind, static_cast<std::uint16_t>(first + k)});
  };
  look(s.obstacles, WrapKind::Obstacle, 0);
  look(s.bodies, WrapKind::Continuum, 0);
  look(s.emitters, WrapKind::Continuum, s.bodies.size());
  look(s.oriented, WrapKind::Oriented, 0);
  look(s.sheets, WrapKind::Sheet, 0);
  return found;
}

WrapTarget wrapTarget(const Scene& s, std::size_t sheet) {
  const SheetBody& b = s.sheets[sheet];
  if (b.shrinkWrapTo.empty()) return {};
  const std::vector<WrapTarget> found = wrapTargets(s, b.shrinkWrapTo);
  if (found.empty())
    throw ShapeError("shrink_wrap_to: unknown obstacle or body '" + b.shrinkWrapTo + "'", b.where);
  if (found.size() > 1)
    throw ShapeError(
        "shrink_wrap_to: '" + b.shrinkWrapTo + "' names several objects of the scene; expected a unique name",
        b.where);
  if (found[0] == WrapTarget{WrapKind::Sheet, static_cast<std::uint16_t>(sheet)})
    throw ShapeError(
        "shrink_wrap_to: a sheet cannot wrap around itself; omit `shrink_wrap_to` to shrink against its own "
        "normals",
        b.where);
  return found[0];
}

}  // namespace thaw
