// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/splat_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/image/parallel_for.hpp"

namespace thaw {

namespace {

constexpr float none = std::numeric_limits<float>::infinity();
// Samples: least drawn radius of a disc, for small or edge-on ones.
constexpr float leastRadius = 0.75f;

/// Samples that a disc may cover.
struct Box {
  int x0, x1, y0, y1;
};

struct Range {
  float low, high;
};
/// Returns the range of centre +- half over depths between nearest and farthest.
Range projected(float centre, float half, float nearest, float farthest) {
  const float a = centre - half, b = centre + half;
  return {a / (a < 0 ? nearest : farthest), b / (b > 0 ? nearest : farthest)};
}

/// Disc in camera axes: right, up, forward.
struct CameraDisc {
  Vec3f centre, normal;
  float radius;
};

Vec3f toCamera(const View& view, const Vec3f& d) {
  return {dot(d, view.right), dot(d, view.up), dot(d, view.forward)};
}

CameraDisc cameraDisc(const Discs& discs, const View& view, std::size_t i) {
  CameraDisc d{toCamera(view, discs.positions[i] - view.origin), toCamera(view, discs.normals[i]),
               discs.radius(i)};
  d.radius = std::max(d.radius, leastRadius * d.centre.z / view.focal);
  return d;
}

/// Computes the box of a disc; false if it is outside of the picture.
bool boxOf(const CameraDisc& d, const View& view, int width, int height, float near, Box& box) {
  const auto half = [&](float n) { return d.radius * std::sqrt(std::max(0.0f, 1 - n * n)); };
  box = {0, -1, 0, -1};
  const float hz = half(d.normal.z), nearest = d.centre.z - hz, farthest = d.centre.z + hz;
  if (!(nearest > near)) return false;
  const Range u = projected(d.centre.x, half(d.normal.x), nearest, farthest),
              v = projected(d.centre.y, half(d.normal.y), nearest, farthest);
  const float left = view.centreX + view.focal * u.low - leastRadius,
              right = view.centreX + view.focal * u.high + leastRadius;
  const float top = view.centreY - view.focal * v.high - leastRadius,
              bottom = view.centreY - view.focal * v.low + leastRadius;
  if (!(right > 0 && bottom > 0 && left < static_cast<float>(width) && top < static_cast<float>(height)))
    return false;
  box = {static_cast<int>(std::max(0.0f, left)),
         static_cast<int>(std::min(static_cast<float>(width - 1), right)),
         static_cast<int>(std::max(0.0f, top)),
         static_cast<int>(std::min(static_cast<float>(height - 1), bottom))};
  return true;
}

bool isClipped(const DiscClip& c, const Vec3f& q) {
  if (dot(q, c.normal) <= c.reach) return false;
  const Vec3f d = q - c.other;
  return dot(d, d) < c.radius2;
}

/// Calls hit(sample, depth, kept) for each sample of a tile that a disc covers. kept is false where it is
/// clipped.
template<class Hit>
void forSamples(const CameraDisc& d, std::span<const DiscClip> clips, const View& view, const Box& box,
                const SurfelTile& tile, Hit hit) {
  const float over = 1 / view.focal, plane = dot(d.normal, d.centre), r2 = d.radius * d.radius;
  const bool isCentreKept = std::ranges::none_of(clips, [](const DiscClip& c) { return isClipped(c, {}); });
  const float screenX = view.centreX + view.focal * d.centre.x / d.centre.z,
              screenY = view.centreY - view.focal * d.centre.y / d.centre.z;
  const int x0 = std::max(box.x0, tile.x), x1 = std::min(box.x1, tile.x + tile.width - 1);
  const int y0 = std::max(box.y0, tile.y), y1 = std::min(box.y1, tile.y + tile.height - 1);
  for (int y = y0; y <= y1; y++) {
    const float sy = static_cast<float>(y) + 0.5f, ry = (view.centreY - sy) * over, dy = sy - screenY;
    const int row = (y - tile.y) * tile.width - tile.x;
    const float slopeRow = d.normal.y * ry + d.normal.z;
    for (int x = x0; x <= x1; x++) {
      const float sx = static_cast<float>(x) + 0.5f, rx = (sx - view.centreX) * over;
      const float t = plane / (d.normal.x * rx + slopeRow);
      const Vec3f q{t * rx - d.centre.x, t * ry - d.centre.y, t - d.centre.z};
      if (dot(q, q) < r2) {  // false for not-a-number
        bool kept = true;
        for (const DiscClip& c : clips) kept = kept && !isClipped(c, q);
        hit(row + x, t, kept);
      } else {
        const float dx = sx - screenX;
        if (dx * dx + dy * dy < leastRadius * leastRadius) hit(row + x, d.centre.z, isCentreKept);
      }
    }
  }
}

/// Returns samples without a disc that a clipped one would cover, amid samples with one: gaps between
/// clips of several discs. A rim that protrudes from an edge is open to at least one side.
std::vector<std::size_t> gapsOf(const SurfelTile& tile, const std::vector<float>& clippedDepth) {
  constexpr int reach = 3;  // samples: wider gaps belong to the surface
  std::vector<std::size_t> gaps;
  for (int y = 0; y < tile.height; y++)
    for (int x = 0; x < tile.width; x++) {
      const std::size_t s = static_cast<std::size_t>(y) * tile.width + x;
      if (tile.depth[s] < none || !(clippedDepth[s] < none)) continue;
      const auto closed = [&](int dx, int dy) {
        for (int n = 1; n <= reach; n++) {
          const int i = x + n * dx, j = y + n * dy;
          if (i < 0 || j < 0 || i >= tile.width || j >= tile.height ||
              tile.depth[static_cast<std::size_t>(j) * tile.width + i] < none)
            return true;
        }
        return false;
      };
      if (closed(-1, 0) && closed(1, 0) && closed(0, -1) && closed(0, 1)) gaps.push_back(s);
    }
  return gaps;
}

/// Calls add(sample, weight) for each sample of a tile whose visible point lies in the sphere around a disc.
template<class Add>
void forSphere(const CameraDisc& d, const View& view, const Box& box, const SurfelTile& tile, Add add) {
  const float over = 1 / view.focal, r2 = d.radius * d.radius, overR2 = 1 / r2;
  const int x0 = std::max(box.x0, tile.x), x1 = std::min(box.x1, tile.x + tile.width - 1);
  const int y0 = std::max(box.y0, tile.y), y1 = std::min(box.y1, tile.y + tile.height - 1);
  for (int y = y0; y <= y1; y++) {
    const float ry = (view.centreY - static_cast<float>(y) - 0.5f) * over;
    const int row = (y - tile.y) * tile.width - tile.x;
    for (int x = x0; x <= x1; x++) {
      const float t = tile.depth[row + x], dz = t - d.centre.z;
      if (!(dz * dz < r2)) continue;
      const float dx = t * ((static_cast<float>(x) + 0.5f - view.centreX) * over) - d.centre.x,
                  dy = t * ry - d.centre.y;
      const float far2 = (dx * dx + dy * dy + dz * dz) * overR2;
      if (far2 < 1) add(row + x, (1 - far2) * (1 - far2));
    }
  }
}

/// Discs or faces of each tile, ascending.
struct TileLists {
  int across = 0, down = 0;
  std::vector<std::uint32_t> first, members;
  std::span<const std::uint32_t> of(std::size_t tile) const {
    return {members.data() + first[tile], first[tile + 1] - first[tile]};
  }
};

TileLists tileLists(std::span<const Box> boxes, int width, int height) {
  constexpr int side = SurfelTile::side;
  TileLists lists;
  lists.across = (width + side - 1) / side;
  lists.down = (height + side - 1) / side;
  lists.first.assign(static_cast<std::size_t>(lists.across) * lists.down + 1, 0);
  const auto each = [&](auto f) {
    for (std::size_t k = 0; k < boxes.size(); k++)
      for (int j = boxes[k].y0 / side; j <= boxes[k].y1 / side; j++)
        for (int i = boxes[k].x0 / side; i <= boxes[k].x1 / side; i++)
          f(static_cast<std::size_t>(j) * lists.across + i, static_cast<std::uint32_t>(k));
  };
  each([&](std::size_t tile, std::uint32_t) { lists.first[tile + 1]++; });
  for (std::size_t t = 0; t + 1 < lists.first.size(); t++) lists.first[t + 1] += lists.first[t];
  lists.members.resize(lists.first.back());
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  each([&](std::size_t tile, std::uint32_t k) { lists.members[next[tile]++] = k; });
  return lists;
}

/// Visible discs of a scene, in camera axes.
struct CameraDiscs {
  std::vector<std::uint32_t> surfel;  ///< index in the scene
  std::vector<CameraDisc> disc;
  std::vector<Box> box, sphereBox;  ///< samples of the disc, and of the sphere around it
  std::vector<DiscClip> clips;
  std::vector<std::uint32_t> firstClip{0};
  std::span<const DiscClip> clipsOf(std::uint32_t k) const {
    return {clips.data() + firstClip[k], firstClip[k + 1] - firstClip[k]};
  }
};

CameraDiscs visibleDiscs(const SurfelScene& scene, std::span<const std::uint8_t> seen, const View& view,
                         int width, int height) {
  CameraDiscs all;
  for (std::size_t i = 0; i < seen.size(); i++)
    if (seen[i]) all.surfel.push_back(static_cast<std::uint32_t>(i));
  all.box.resize(all.surfel.size());
  all.sphereBox.resize(all.surfel.size());
  for (std::size_t k = 0; k < all.surfel.size(); k++) {
    const std::uint32_t i = all.surfel[k];
    const CameraDisc d = cameraDisc(scene.discs, view, i);
    all.disc.push_back(d);
    boxOf(d, view, width, height, 0, all.box[k]);
    boxOf({d.centre, {}, d.radius}, view, width, height, 0, all.sphereBox[k]);
    for (std::uint32_t c = scene.clips.first[i]; c < scene.clips.first[i + 1]; c++)
      all.clips.push_back({toCamera(view, scene.clips.list[c].normal), scene.clips.list[c].reach,
                           toCamera(view, scene.clips.list[c].other), scene.clips.list[c].radius2});
    all.firstClip.push_back(static_cast<std::uint32_t>(all.clips.size()));
  }
  return all;
}

SurfelTile emptyTile(std::size_t number, const TileLists& lists, int width, int height) {
  constexpr int side = SurfelTile::side;
  SurfelTile tile;
  tile.x = static_cast<int>(number % static_cast<std::size_t>(lists.across)) * side;
  tile.y = static_cast<int>(number / static_cast<std::size_t>(lists.across)) * side;
  tile.width = std::min(side, width - tile.x);
  tile.height = std::min(side, height - tile.y);
  tile.depth.assign(static_cast<std::size_t>(tile.width) * tile.height, none);
  return tile;
}

/// Draws the discs and faces of one tile.
struct TilePainter {
  const SurfelScene& scene;
  const CameraDiscs& discs;
  const View& view;
  SurfelTile& tile;
  std::vector<std::uint32_t> front{};  ///< by sample: the front disc
  std::vector<std::uint8_t> ofFace{};  ///< by sample: 1 where a face is in front

  /// Sets depths and front discs.
  void drawFront(std::span<const std::uint32_t> here) {
    front.assign(tile.depth.size(), 0);
    std::vector<std::uint32_t> clippedFront(tile.depth.size(), 0);
    std::vector<float> clippedDepth(tile.depth.size(), none);
    for (std::uint32_t k : here)
      forSamples(discs.disc[k], discs.clipsOf(k), view, discs.box[k], tile,
                 [&](int s, float depth, bool drawn) {
                   float& nearest = drawn ? tile.depth[s] : clippedDepth[s];
                   if (depth < nearest) nearest = depth, (drawn ? front : clippedFront)[s] = k;
                 });
    for (const std::size_t s : gapsOf(tile, clippedDepth))
      tile.depth[s] = clippedDepth[s], front[s] = clippedFront[s];
  }

  void drawFacesOf(std::span<const std::uint32_t> faces) {
    tile.shade.assign(tile.depth.size(), {{}, {}, {}, 0});
    ofFace.assign(tile.depth.size(), 0);
    drawFaces(scene.faces, faces, scene.corners, view, tile, ofFace);
  }

  /// Sums the shades of all surfels of the same side and body around the visible points. Returns the weights
  /// by sample.
  std::vector<float> sumShades(std::span<const std::uint32_t> here) {
    std::vector<float> weight(tile.depth.size(), 0.0f);
    for (std::uint32_t k : here) {
      const std::size_t i = discs.surfel[k];
      const SurfelShade& own = scene.shades[i];
      forSphere(discs.disc[k], view, discs.sphereBox[k], tile, [&](int s, float w) {
        if (ofFace[s]) return;
        const std::uint32_t f = front[s];
        const float alike = dot(discs.disc[f].normal, discs.disc[k].normal);
        if (alike <= 0 ||
            (!scene.components.empty() && scene.components[discs.surfel[f]] != scene.components[i]))
          return;
        w *= alike * alike;
        SurfelShade& sum = tile.shade[s];
        sum.normal += w * own.normal;
        sum.fromSky += w * own.fromSky;
        sum.ofSun += w * own.ofSun;
        sum.sun += w * own.sun;
        weight[s] += w;
      });
    }
    return weight;
  }

  /// Divides sums of shades by their weights. Samples without weight get the shade of the front disc.
  void normaliseShades(const std::vector<float>& weight) {
    for (std::size_t s = 0; s < weight.size(); s++) {
      if (!(tile.depth[s] < none) || ofFace[s]) continue;
      SurfelShade& sum = tile.shade[s];
      const SurfelShade& ofFront = scene.shades[discs.surfel[front[s]]];
      if (!(weight[s] > 0)) {
        sum = ofFront;
        continue;
      }
      const float over = 1 / weight[s], length2 = dot(sum.normal, sum.normal);
      sum.normal = length2 > 0 ? sum.normal / std::sqrt(length2) : ofFront.normal;
      sum.fromSky = over * sum.fromSky;
      sum.ofSun = over * sum.ofSun;
      sum.sun *= over;
    }
  }
};

}  // namespace

std::vector<std::uint8_t> facingDiscs(const Discs& discs, const View& view, int width, int height,
                                      float near) {
  std::vector<std::uint8_t> seen(discs.positions.size(), 0);
  Box box;
  for (std::size_t i = 0; i < seen.size(); i++) {
    const CameraDisc d = cameraDisc(discs, view, i);
    seen[i] = d.centre.z > near && dot(d.normal, d.centre) < 0 && boxOf(d, view, width, height, near, box);
  }
  return seen;
}

void splatSurfels(const SurfelScene& scene, std::span<const std::uint8_t> seen, const SampleGrid& samples,
                  int threads, const std::function<void(const SurfelTile&)>& take) {
  const View& view = samples.view;
  const int width = samples.width, height = samples.height;
  const CameraDiscs discs = visibleDiscs(scene, seen, view, width, height);
  const TileLists lists = tileLists(discs.sphereBox, width, height);
  std::vector<Box> faceBoxes;
  for (const CameraFaces::Face& f : scene.faces.faces) faceBoxes.push_back({f.x0, f.x1, f.y0, f.y1});
  const TileLists faceLists = tileLists(faceBoxes, width, height);
  parallelFor(lists.first.size() - 1, threads, [&](std::size_t t) {
    SurfelTile tile = emptyTile(t, lists, width, height);
    const std::span<const std::uint32_t> here = lists.of(t), facesHere = faceLists.of(t);
    if (!here.empty() || !facesHere.empty()) {
      TilePainter painter{scene, discs, view, tile};
      painter.drawFront(here);
      painter.drawFacesOf(facesHere);
      painter.normaliseShades(painter.sumShades(here));
    }
    take(tile);
  });
}

}  // namespace thaw
