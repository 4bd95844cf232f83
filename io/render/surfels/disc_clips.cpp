// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/disc_clips.hpp"

#include <algorithm>
#include <cmath>

#include "io/image/linear_light.hpp"
#include "io/render/light/surface_normals.hpp"

namespace thaw {

namespace {

constexpr float alike = 0.96f;  // cosine: normals within 16 degrees belong to one smooth face

/// Returns the extent of a clip around the neighbour, in its radii. On a curved surface it ends with the
/// neighbour, or a gap would open to the next disc. Along a straight edge it extends farther.
float reachOf(float cosine) { return 2.2f - 1.4f * ramp(0.3f, 0.75f, cosine); }
/// Returns the allowed protrusion beyond the neighbour's plane, in radii, so that faces meet without a gap.
float slackOf(float cosine) { return 0.015f + 0.12f * ramp(0.2f, 0.6f, cosine); }
float square(float x) { return x * x; }

struct Candidate {
  float away;
  DiscClip clip;
};  // away: from the centre to the clip, along the disc

}  // namespace

DiscClips clipDiscs(const Discs& discs, std::span<const std::uint8_t> wanted,
                    std::span<const std::uint32_t> components) {
  DiscClips clips;
  const std::size_t count = discs.positions.size();
  clips.first.assign(count + 1, 0);
  float edge = 0;
  for (std::size_t i = 0; i < count; i++) edge = std::max(edge, discs.radius(i));
  if (!(edge > 0)) return clips;
  // Bins follow the 90th percentile, since radii may vary widely.
  std::vector<float> radii;
  for (std::size_t i = 0; i < count; i++) radii.push_back(discs.radius(i));
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(count * 9 / 10), radii.end());
  const CellBins bins = binParticles(discs.positions, 2 * radii[count * 9 / 10]);
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < count; i++) {
    clips.first[i] = static_cast<std::uint32_t>(clips.list.size());
    if (!wanted[i]) continue;
    found.clear();
    const Vec3f &x = discs.positions[i], &n = discs.normals[i];
    const float r = discs.radius(i);
    forNeighbours(discs.positions, bins, x, [&](std::uint32_t j, const Vec3f& d, float) {
      const float cosine = dot(n, discs.normals[j]);
      if (cosine > alike || cosine < -0.5f) return;  // -0.5: another sheet, or the other side of a thin one
      if (!components.empty() && components[i] != components[j]) return;
      const float larger = 2 * std::max(r, discs.radius(j));
      if (dot(d, d) > larger * larger) return;
      const float behind = -dot(d, discs.normals[j]);  // distance of the centre behind the neighbour's plane
      if (behind < 0 || dot(d, n) < -0.05f * r)
        return;  // valley or saddle: a protruding rim is hidden below, or closes a gap
      const float away = behind / std::sqrt(1 - cosine * cosine);
      if (away < r)
        found.push_back({away,
                         {discs.normals[j], behind + slackOf(cosine) * r, -d,
                          square(reachOf(cosine) * discs.radius(j))}});
    });
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.away < b.away; });
    // The nearest clip, then those with a different face.
    for (const Candidate& c : found) {
      const std::size_t have = clips.list.size() - clips.first[i];
      if (have == DiscClips::most) break;
      bool fresh = true;
      for (std::size_t k = 0; k < have && fresh; k++) {
        const DiscClip& other = clips.list[clips.first[i] + k];
        const Vec3f apart = other.other - c.clip.other;
        fresh = dot(other.normal, c.clip.normal) < alike || dot(apart, apart) > 0.25f * c.clip.radius2;
      }
      if (fresh) clips.list.push_back(c.clip);
    }
  }
  clips.first[count] = static_cast<std::uint32_t>(clips.list.size());
  return clips;
}

}  // namespace thaw
