#include "core/oriented/made_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "core/geometry/placed_mesh.hpp"
#include "core/geometry/point_tree.hpp"
#include "core/geometry/pose.hpp"
#include "core/geometry/sampling.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/given_surface.hpp"
#include "core/oriented/oriented.hpp"
#include "core/surface/blue_noise.hpp"
#include "core/surface/mesh_normals.hpp"

namespace thaw {
namespace {

constexpr double rowHeight = 0.86602540378443865;
// of thinning
constexpr double evenReach = 0.95;      // of the mean distance to the nearest: of even points there is one this near to any place
constexpr double chosenByError = 0.33;  // share of the kept points
constexpr int rounds = 4;

void add(MadePoints& m, const Vec3d& x, const Vec3d& n, std::uint8_t held = 0) {
  m.places.push_back(x);
  m.normals.push_back(n);
  m.held.push_back(held);
}

/// Hexagonal lattice over a rectangle around the origin, of points that `wanted` takes: use(x, y).
template<class Use> void eachOfLattice(double width, double depth, double spacing, Use&& use) {
  const auto rows = static_cast<std::int64_t>(std::floor(depth / (rowHeight * spacing) + 1e-9)), columns = static_cast<std::int64_t>(std::floor(width / spacing + 1e-9));
  for (std::int64_t j = 0; j <= rows; j++)
    for (std::int64_t i = 0; i <= columns; i++) {
      const double x = (static_cast<double>(i) - 0.5 * static_cast<double>(columns) + (j % 2 ? 0.25 : -0.25)) * spacing;
      use(x, (static_cast<double>(j) - 0.5 * static_cast<double>(rows)) * rowHeight * spacing);
    }
}

MadePoints flatPatch(const OrientedBody& b, double spacing) {
  MadePoints m;
  const bool disc = b.source == OrientedSource::Disc;
  Pose pose = poseOf(b.shape.move, b.shape.rotate);
  pose.moved = true;
  const double scale = b.shape.scale, radius = scale * b.radius, width = disc ? 2 * radius : scale * b.width, depth = disc ? width : scale * b.depth;
  eachOfLattice(width, depth, spacing, [&](double x, double y) {
    if (!disc || x * x + y * y <= radius * radius * (1 + 1e-9)) add(m, fromRest(pose, {x, y, 0}), directionFromRest(pose, {0, 0, 1}));
  });
  return m;
}

bool inHull(const std::vector<double>& x, const std::vector<double>& y, double px, double py) {  // of points around: some direction has all on one side
  for (int k = 0; k < 72; k++) {
    const double c = std::cos(k * 0.0872664625997165), s = std::sin(k * 0.0872664625997165), mine = c * px + s * py;
    double most = -1e300;
    for (std::size_t i = 0; i < x.size(); i++) most = std::max(most, c * x[i] + s * y[i]);
    if (mine > most + 1e-9) return false;
  }
  return true;
}

/// A thin plate through the points, over their hull; the particle nearest to a control point takes its place and is held.
MadePoints plateThrough(const OrientedBody& b, double spacing) {
  const ThinPlate plate = thinPlate(b.points);
  MadePoints m;
  double reach = 0;
  for (std::size_t k = 0; k < plate.x.size(); k++) reach = std::max({reach, std::abs(plate.x[k]), std::abs(plate.y[k])});
  eachOfLattice(2 * reach + spacing, 2 * reach + spacing, spacing, [&](double x, double y) {
    if (inHull(plate.x, plate.y, x, y)) add(m, plate.at(x, y), plate.normal(x, y));
  });
  for (std::size_t k = 0; k < b.points.size(); k++) {
    std::size_t nearest = m.places.size();
    double least = 0.6 * spacing;
    for (std::size_t i = 0; i < m.places.size(); i++)
      if (const double far = length(m.places[i] - b.points[k]); far < least && !m.held[i]) least = far, nearest = i;
    const Vec3d n = plate.normal(plate.x[k], plate.y[k]);
    if (nearest == m.places.size()) add(m, b.points[k], n, heldPlace);
    else m.places[nearest] = b.points[k], m.normals[nearest] = n, m.held[nearest] = heldPlace;
  }
  return m;
}

/// A parabola in y = 0, particles a spacing apart along it.
MadePoints curve(const OrientedBody& b, double spacing) {
  MadePoints m;
  const Vec3d chord = b.to - b.from, up{-chord.z / length(chord), 0, chord.x / length(chord)};
  const auto at = [&](double s) { return b.from + s * chord + (4 * b.bulge * s * (1 - s)) * up; };
  constexpr int fine = 20000;
  double total = 0;
  std::vector<double> arc(fine + 1, 0);
  for (int k = 1; k <= fine; k++) arc[static_cast<std::size_t>(k)] = total += length(at(static_cast<double>(k) / fine) - at((k - 1.0) / fine));
  const auto pieces = std::max<std::int64_t>(1, std::llround(total / spacing));
  for (std::int64_t k = 0; k <= pieces; k++) {
    const auto where = std::lower_bound(arc.begin(), arc.end(), total * static_cast<double>(k) / static_cast<double>(pieces) * (1 - 1e-12)) - arc.begin();
    const double s = k == pieces ? 1 : static_cast<double>(where) / fine;
    const Vec3d along = normalized(chord + (4 * b.bulge * (1 - 2 * s)) * up);
    add(m, at(s), {-along.z, 0, along.x});
  }
  return m;
}

}  // namespace

namespace {

/// Points push each other apart along the surface, within a spacing: all at once from their last places, so that their order does not matter.
void spreadOut(const SignedDistance& shape, double spacing, MadePoints& m) {
  constexpr int passes = 60;
  for (int pass = 0; pass < passes; pass++) {
    const PointTree tree(m.places);
    for (std::size_t i = 0; i < m.places.size(); i++) {
      Vec3d push{};
      for (const std::uint32_t j : tree.within(tree.points()[i], 1.05 * spacing)) {
        if (j == i || !(dot(m.normals[i], m.normals[j]) > 0)) continue;
        const Vec3d r = tree.points()[i] - tree.points()[j];
        const double far = length(r);
        if (far > 0) push += ((1.05 * spacing - far) / far) * r;
      }
      Vec3d n = m.normals[i];
      m.places[i] += 0.25 * (push - dot(push, n) * n);
      for (int k = 0; k < 2; k++) {
        const double d = shape.distanceWithin(m.places[i], spacing, &n);
        m.places[i] -= d * n;
      }
    }
    for (std::size_t i = 0; i < m.places.size(); i++) shape.distanceWithin(m.places[i], spacing, &m.normals[i]);
  }
}

constexpr int mostAlong = 1 << 20;  // points of the lattice along an axis: bins of them have 21 bits

Vec3i latticeOf(const Vec3d& size, double fine) {
  Vec3i count;
  for (int a = 0; a < 3; a++) {
    const double points = std::ceil(size[a] / fine) + 3;
    if (!(points < mostAlong)) throw std::invalid_argument("its spacing is too small for its size: it may be 300000 spacings long at most");
    count[a] = static_cast<int>(points);
  }
  return count;
}

/// Calls use(i, j, k) for all points of a lattice [low, high) but for those that are certainly not within `fine` of the surface: blocks of points are cut in half
/// as long as the distance of their middle does not rule them out.
template<class At, class Use> void eachNearSurface(const SignedDistance& shape, double fine, const Vec3i& low, const Vec3i& high, const At& at, const Use& use) {
  const Vec3i size{high.x - low.x, high.y - low.y, high.z - low.z};
  const int longest = std::max({size.x, size.y, size.z});
  if (longest > 4) {
    const Vec3d a = at(low.x, low.y, low.z), b = at(high.x - 1, high.y - 1, high.z - 1);
    const double reach = 0.5 * length(b - a) * (1 + 1e-9) + fine;
    if (std::abs(shape.distanceWithin(0.5 * (a + b), reach)) >= reach) return;
    Vec3i middleHigh = high, middleLow = low;
    const int axis = size.x == longest ? 0 : size.y == longest ? 1 : 2;
    middleHigh[axis] = middleLow[axis] = low[axis] + longest / 2;
    eachNearSurface(shape, fine, low, middleHigh, at, use);
    eachNearSurface(shape, fine, middleLow, high, at, use);
    return;
  }
  for (int k = low.z; k < high.z; k++)
    for (int j = low.y; j < high.y; j++)
      for (int i = low.x; i < high.x; i++) use(i, j, k);
}

}  // namespace

MadePoints coverSurface(const SignedDistance& shape, double spacing, std::uint64_t seed) {
  const double fine = spacing / 3, apart = 0.75 * spacing;
  const Bounds box = shape.bounds();
  const Vec3d size = box.max - box.min;
  if (!std::isfinite(size.x + size.y + size.z)) throw std::invalid_argument("a surface without end cannot be covered with particles");
  const Vec3i count = latticeOf(size, fine);
  struct Sample { std::uint64_t rank; Vec3d place, normal; };
  std::vector<Sample> samples;
  const auto at = [&](int i, int j, int k) { return box.min + Vec3d{(i - 1) * fine, (j - 1) * fine, (k - 1) * fine}; };
  eachNearSurface(shape, fine, {0, 0, 0}, count, at, [&](int i, int j, int k) {
    Vec3d x = at(i, j, k), n;
    double d = shape.distanceWithin(x, fine, &n);
    if (std::abs(d) >= fine) return;
    for (int pass = 0; pass < 4; pass++) {
      x -= d * n;
      d = shape.distanceWithin(x, fine, &n);
    }
    if (std::abs(d) > 0.05 * spacing) return;
    const std::uint64_t number = (static_cast<std::uint64_t>(k) * static_cast<std::uint64_t>(count.y) + static_cast<std::uint64_t>(j)) * static_cast<std::uint64_t>(count.x) + static_cast<std::uint64_t>(i);
    samples.push_back({randomBits(seed, Purpose::OrientedSample, number), x, n});
  });
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.rank < b.rank; });
  MadePoints m;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> bins;
  const auto binOf = [&](const Vec3d& x, int a) { return static_cast<std::int64_t>(std::floor((x[a] - box.min[a]) / apart)) + 4; };
  const auto key = [](std::int64_t x, std::int64_t y, std::int64_t z) { return static_cast<std::uint64_t>(z) << 42 | static_cast<std::uint64_t>(y) << 21 | static_cast<std::uint64_t>(x); };
  for (const Sample& s : samples) {
    const std::int64_t bx = binOf(s.place, 0), by = binOf(s.place, 1), bz = binOf(s.place, 2);
    bool free = true;
    for (std::int64_t z = bz - 1; z <= bz + 1 && free; z++)
      for (std::int64_t y = by - 1; y <= by + 1 && free; y++)
        for (std::int64_t x = bx - 1; x <= bx + 1 && free; x++) {
          const auto there = bins.find(key(x, y, z));
          if (there == bins.end()) continue;
          for (const std::uint32_t q : there->second) {
            const Vec3d d = m.places[q] - s.place;
            if (dot(d, d) < apart * apart && dot(m.normals[q], s.normal) > 0) free = false;  // thin bodies have two sides
          }
        }
    if (!free) continue;
    bins[key(bx, by, bz)].push_back(static_cast<std::uint32_t>(m.places.size()));
    add(m, s.place, s.normal);
  }
  spreadOut(shape, spacing, m);
  return m;
}

MadePoints sampleMesh(const Shape& shape, double spacing, std::uint64_t seed, const MeshLoader& load) {
  const PlacedMesh placed = makePlacedMesh(shape, load);
  const MeshNormals normals(placed.mesh);
  MadePoints m;
  for (const MeshSample& s : blueNoise(placed.mesh, spacing, seed)) add(m, s.position, normals.at(s.position, s.triangle));
  return m;
}

namespace {

/// Of points in the order of a hash those that have none kept within a distance (Poisson discs), for which their number is right; ascending.
std::vector<std::uint32_t> evenly(const MadePoints& m, const PointTree& tree, std::size_t wanted, std::uint64_t seed) {
  std::vector<std::uint32_t> order(m.places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<std::uint64_t> rank;
  for (std::size_t k = 0; k < order.size(); k++) rank.push_back(randomBits(seed, Purpose::OrientedSample, k, 1));
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return rank[a] < rank[b]; });
  const auto keptAt = [&](double apart) {
    std::vector<std::uint8_t> covered(m.places.size(), 0);
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t k : order) {
      if (covered[k]) continue;
      kept.push_back(k);
      for (const std::uint32_t q : tree.within(m.places[k], apart)) covered[q] |= dot(m.normals[k], m.normals[q]) > 0;  // thin bodies have two sides
    }
    return kept;
  };
  double low = 0, high = 1e-3;
  for (const Vec3d& x : m.places) high = std::max(high, length(x - m.places[0]));
  std::vector<std::uint32_t> kept = keptAt(low);
  for (int k = 0; k < 40 && kept.size() != wanted; k++) {
    const double apart = 0.5 * (low + high);
    std::vector<std::uint32_t> these = keptAt(apart);
    (these.size() > wanted ? low : high) = apart;
    if (these.size() >= wanted || k == 39) kept = std::move(these);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

GivenPoints givenBy(const MadePoints& m, const std::vector<std::uint32_t>& kept) {
  GivenPoints g;
  for (const std::uint32_t k : kept) {
    g.points.push_back(m.places[k]);
    g.normals.push_back(m.normals[k]);
  }
  readyGiven(g);
  return g;
}

/// Keeps a share of the points, held: most of them evenly, the others where the surface through those that are kept already is farthest from the points (the
/// greedy choice of centres of Carr et al. 2001, section 4), a few at a time.
MadePoints thinned(const MadePoints& m, double share, std::uint64_t seed) {
  const PointTree tree(m.places);
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(m.places.size()) - 1e-9));
  std::vector<std::uint32_t> kept = evenly(m, tree, wanted - static_cast<std::size_t>(chosenByError * static_cast<double>(wanted)), seed);
  MadePoints thin;
  for (int round = rounds; round > 0 && kept.size() < wanted; round--) {
    const GivenPoints given = givenBy(m, kept);
    if (round == rounds) thin.reach = evenReach * given.apart;
    std::vector<std::pair<double, std::uint32_t>> far;
    for (std::uint32_t k = 0; k < m.places.size(); k++) {
      Vec3d x = m.places[k], n = m.normals[k];
      far.push_back({projectOnGiven(given, x, n) && dot(n, m.normals[k]) > 0 ? length(x - m.places[k]) : given.apart, k});
    }
    std::sort(far.begin(), far.end(), [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
    // what is near to a new one waits until its surface is known
    std::vector<std::uint8_t> waits(m.places.size(), 0);
    std::size_t more = (wanted - kept.size() + static_cast<std::size_t>(round) - 1) / static_cast<std::size_t>(round);
    for (const std::uint32_t k : kept) waits[k] = 1;
    for (const auto& [error, k] : far) {
      if (more == 0) break;
      if (waits[k]) continue;
      kept.push_back(k);
      more--;
      for (const std::uint32_t q : tree.within(m.places[k], 0.5 * given.apart)) waits[q] |= dot(m.normals[k], m.normals[q]) > 0;
    }
    std::sort(kept.begin(), kept.end());
  }
  if (thin.reach == 0) thin.reach = evenReach * givenBy(m, kept).apart;
  for (const std::uint32_t k : kept) add(thin, m.places[k], m.normals[k], heldPlace | heldNormal);
  return thin;
}

}  // namespace

MadePoints makePoints(const OrientedBody& b, double spacing, std::uint64_t seed, const MeshLoader& load) {
  MadePoints m;
  switch (b.source) {
    case OrientedSource::Surface:
      if (b.thin < 1 && b.shape.kind == ShapeKind::Mesh) m = sampleMesh(b.shape, spacing, seed, load);
      else m = coverSurface(*makeSignedDistance(b.shape, load), spacing, seed);
      break;
    case OrientedSource::Patch:
    case OrientedSource::Disc: m = flatPatch(b, spacing); break;
    case OrientedSource::Control: m = plateThrough(b, spacing); break;
    case OrientedSource::Curve: m = curve(b, spacing); break;
    case OrientedSource::Points: {
      const std::vector<Vec3d> normals = b.normals.empty() ? normalsOf(b.points) : b.normals;
      for (std::size_t k = 0; k < b.points.size(); k++) add(m, b.points[k], normalized(normals[k]), b.growth != OrientedGrowth::None ? heldPlace | heldNormal : 0);
    }
  }
  if (b.thin < 1 && !m.places.empty()) m = thinned(m, b.thin, seed);
  if (m.places.empty()) throw std::invalid_argument("it has no particle: it is too small for its spacing, or empty");
  return m;
}

}  // namespace thaw
