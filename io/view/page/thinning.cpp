// SPDX-License-Identifier: Apache-2.0
#include "io/view/page/thinning.hpp"

#include <algorithm>

namespace thaw {

namespace {

std::size_t framesLeft(const PageSizes& sizes, std::size_t every) {
  return (sizes.frames + every - 1) / every;
}

/// Leaves fewer frames, but not below `least`.
bool fewerFrames(const PageSizes& sizes, std::size_t least, Thinning& t) {
  const std::size_t next = t.every + std::max<std::size_t>(1, t.every / 4);
  if (framesLeft(sizes, next) < least) return false;
  t.every = next;
  return true;
}

bool fewerPoints(const PageSizes& sizes, std::uint64_t least, Thinning& t) {
  const std::uint64_t next = std::min(sizes.points, t.most) * 3 / 4;
  if (next < least) return false;
  t.most = next;
  return true;
}

}  // namespace

bool thinFurther(const PageSizes& sizes, Thinning& t) {
  if (t.tensors && sizes.tensors) return t.tensors = false, true;
  if (fewerFrames(sizes, 60, t)) return true;
  if (t.particles && sizes.spare) return t.particles = false, true;
  if (fewerFrames(sizes, 8, t) || fewerPoints(sizes, 1500, t)) return true;
  if (fewerFrames(sizes, 2, t) || fewerPoints(sizes, 50, t)) return true;
  if (t.meshes && sizes.meshes) return t.meshes = false, true;
  return false;
}

}  // namespace thaw
