// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/thinning.hpp"

#include <algorithm>

namespace thaw {

bool thinFurther(const PageSizes& sizes, Thinning& t) {
  if (t.tensors && sizes.tensors) return t.tensors = false, true;
  const std::size_t frames = (sizes.frames + t.every - 1) / t.every;
  const std::uint64_t points = std::min(sizes.points, t.most);
  struct Floor {
    std::size_t frames;
    std::uint64_t points;
  };
  for (const Floor floor : {Floor{60, 12500}, Floor{12, 1500}, Floor{2, 50}}) {
    if (frames / 2 >= floor.frames) return t.every *= 2, true;
    if (points / 2 >= floor.points) return t.most = points / 2, true;
  }
  if (t.meshes && sizes.meshes) return t.meshes = false, true;
  return false;
}

}  // namespace thaw
