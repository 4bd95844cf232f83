// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/measure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/halo/gather_words.hpp"
#include "core/math/exact_sum.hpp"
#include "core/surface/measures/enclosed_volume.hpp"
#include "core/surface/measures/periodic_unwrap.hpp"

namespace thaw {
namespace {

/// Component with intermediate results.
struct Record {
  SurfaceComponent measured;
  Vec3d anchor{};     // m, position of the particle that labels the component
  int ranks = 0;      // number of ranks with rows of the component
  Sectors sectors{};  // occupied sectors of periodic axes
  PeriodicCut piece;  // position across periodic sides
};

enum Sum {
  Mass,
  ParticleVolume,
  TargetVolume,
  MomentX,
  MomentY,
  MomentZ,
  Area,
  VolumeX,
  VolumeY,
  VolumeZ,
  MixedX,
  MixedY,
  MixedZ,
  NormalX,
  NormalY,
  NormalZ,
  FreeArea,
  PlainArea,
  HeldArea,
  Rim,
  RimX,
  RimY,
  RimZ,
  RimXX,
  RimYY,
  RimZZ,
  RimYZ,
  RimZX,
  RimXY,
  sums
};

/// Rows of one component on this rank.
struct Group {
  std::uint64_t label = 0;
  // ranges in the sorted orders
  std::size_t particlesFrom = 0, particlesTo = 0, surfelsFrom = 0, surfelsTo = 0;
};

/// Returns rows in the order of their components.
std::vector<std::uint32_t> orderByLabel(const std::uint64_t* label, std::size_t n) {
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; i++) order[i] = static_cast<std::uint32_t>(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return label[a] != label[b] ? label[a] < label[b] : a < b;
  });
  return order;
}

std::vector<Group> groupsOf(const Surface& s, const std::vector<std::uint32_t>& particles,
                            const std::vector<std::uint32_t>& surfels) {
  const std::uint64_t *ofParticle = s.particles.component.data(), *ofSurfel = s.surfels.component.data();
  std::vector<Group> groups;
  for (std::size_t p = 0, f = 0; p < particles.size() || f < surfels.size();) {
    Group g;
    g.label = std::min(p < particles.size() ? ofParticle[particles[p]] : ~std::uint64_t{0},
                       f < surfels.size() ? ofSurfel[surfels[f]] : ~std::uint64_t{0});
    g.particlesFrom = p;
    while (p < particles.size() && ofParticle[particles[p]] == g.label) p++;
    g.particlesTo = p;
    g.surfelsFrom = f;
    while (f < surfels.size() && ofSurfel[surfels[f]] == g.label) f++;
    g.surfelsTo = f;
    groups.push_back(g);
  }
  return groups;
}

/// Returns the smallest width (m) of empty sectors at which a component may be cut open.
double gapOf(const Surface& s) { return 2 * s.spacing; }

/// Returns all components of all ranks, with counts, anchors and positions across periodic sides, ascending
/// by label.
std::vector<Record> recordsOf(const Surface& s, const std::vector<std::uint32_t>& particles,
                              const std::vector<std::uint32_t>& surfels, const std::vector<Group>& groups,
                              Reducer& all) {
  constexpr std::size_t words = 10;
  std::vector<std::uint64_t> mine;
  for (const Group& g : groups) {
    Vec3d anchor{};
    bool has = false;
    for (std::size_t k = g.particlesFrom; k < g.particlesTo; k++)
      if (s.particles.id[particles[k]] + 1 == g.label) {
        anchor = s.particles.position[particles[k]];
        has = true;
      }
    Sectors sectors{};
    for (std::size_t k = g.particlesFrom; k < g.particlesTo; k++)
      addToSectors(s.grid, gapOf(s), s.particles.position[particles[k]], sectors);
    for (std::size_t k = g.surfelsFrom; k < g.surfelsTo; k++)
      addToSectors(s.grid, gapOf(s), s.surfels.position[surfels[k]], sectors);
    mine.insert(mine.end(),
                {g.label, g.particlesTo - g.particlesFrom, g.surfelsTo - g.surfelsFrom, has ? 1ull : 0ull,
                 std::bit_cast<std::uint64_t>(anchor.x), std::bit_cast<std::uint64_t>(anchor.y),
                 std::bit_cast<std::uint64_t>(anchor.z), sectors[0], sectors[1], sectors[2]});
  }
  const std::vector<std::uint64_t> theirs = gatherWords(all, mine);
  std::vector<std::size_t> order(theirs.size() / words);
  for (std::size_t k = 0; k < order.size(); k++) order[k] = k * words;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return theirs[a] < theirs[b]; });
  std::vector<Record> records;
  for (const std::size_t at : order) {
    const std::uint64_t* w = &theirs[at];
    if (records.empty() || records.back().measured.label != w[0]) {
      records.push_back({});
      records.back().measured.label = w[0];
    }
    Record& r = records.back();
    r.measured.particles += static_cast<std::int64_t>(w[1]);
    r.measured.surfels += static_cast<std::int64_t>(w[2]);
    if (w[3])
      r.anchor = {std::bit_cast<double>(w[4]), std::bit_cast<double>(w[5]), std::bit_cast<double>(w[6])};
    for (std::size_t a = 0; a < 3; a++) r.sectors[a] |= w[7 + a];
    r.ranks++;
  }
  for (Record& r : records) {
    r.piece = findPeriodicCut(s.grid, gapOf(s), r.sectors);
    r.anchor = unwrappedPosition(s.grid, r.piece, r.anchor);
  }
  return records;
}

std::size_t indexOf(const std::vector<Record>& records, std::uint64_t label) {
  return static_cast<std::size_t>(
      std::lower_bound(records.begin(), records.end(), label,
                       [](const Record& r, std::uint64_t l) { return r.measured.label < l; }) -
      records.begin());
}

/// Next and previous axis.
int next(int axis) { return (axis + 1) % 3; }
int last(int axis) { return (axis + 2) % 3; }

/// Adds a component's exact sums over this rank's rows.
void addRows(const Surface& s, const Group& g, const std::vector<std::uint32_t>& particles,
             const std::vector<std::uint32_t>& surfels, const Record& r, std::array<ExactSum, sums>& sum) {
  const SurfaceParticles& p = s.particles;
  const Surfels& f = s.surfels;
  sum.fill({});
  for (std::size_t k = g.particlesFrom; k < g.particlesTo; k++) {
    const std::uint32_t i = particles[k];
    const Vec3d d = unwrappedPosition(s.grid, r.piece, p.position[i]) - r.anchor;
    sum[Mass].add(p.mass[i]);
    sum[ParticleVolume].add(p.volume[i]);
    sum[TargetVolume].add(p.volumeRatio[i] * p.volume[i]);
    for (std::size_t a = 0; a < 3; a++) sum[MomentX + a].add(p.mass[i] * d[static_cast<int>(a)]);
  }
  for (std::size_t k = g.surfelsFrom; k < g.surfelsTo; k++) {
    const std::uint32_t i = surfels[k];
    const Vec3d d = unwrappedPosition(s.grid, r.piece, f.position[i]) - r.anchor, facets = f.facets[i];
    sum[Area].add(f.area[i]);
    if (const double liquid = liquidShare(f, i); liquid > 0) sum[FreeArea].add(liquid * f.area[i]);
    if (const double frozen = frozenShare(f, i); frozen > 0) sum[PlainArea].add(frozen * f.area[i]);
    if (liesOnWall(f, i)) sum[HeldArea].add(f.area[i]);
    for (int a = 0; a < 3; a++) {
      const auto c = static_cast<std::size_t>(a);
      sum[VolumeX + c].add(d[a] * facets[a] + f.bulge[i]);
      sum[MixedX + c].add(d[next(a)] * facets[last(a)] + d[last(a)] * facets[next(a)]);
      sum[NormalX + c].add(facets[a]);
    }
    if (f.rim[i] > 0) {
      sum[Rim].add(f.rim[i]);
      for (int a = 0; a < 3; a++) {
        const auto c = static_cast<std::size_t>(a);
        sum[RimX + c].add(f.rim[i] * d[a]);
        sum[RimXX + c].add(f.rim[i] * d[a] * d[a]);
        sum[RimYZ + c].add(f.rim[i] * d[next(a)] * d[last(a)]);
      }
    }
  }
}

void finish(const Surface& s, Record& r, const std::array<double, sums>& v) {
  const CellGrid& grid = s.grid;
  SurfaceComponent& c = r.measured;
  c.mass = v[Mass];
  c.particleVolume = v[ParticleVolume];
  c.targetVolume = v[TargetVolume];
  c.area = v[Area];
  c.liquidArea = v[FreeArea];
  c.frozenArea = v[PlainArea];
  c.wallArea = v[HeldArea];
  c.open = c.area > 0 ? length(Vec3d{v[NormalX], v[NormalY], v[NormalZ]}) / c.area : 0;
  const Vec3d centroid = c.mass > 0 ? Vec3d{v[MomentX], v[MomentY], v[MomentZ]} / c.mass : Vec3d{};
  c.centroid = r.anchor + centroid;
  for (int a = 0; a < 3; a++)
    if (grid.periodic[a]) c.centroid[a] = grid.origin[a] + withinPeriod(grid, a, c.centroid[a]);
  const auto three = [&](Sum first) { return Vec3d{v[first], v[first + 1], v[first + 2]}; };
  FacetSums facets{three(VolumeX), three(MixedX),
                   three(NormalX), v[Rim],
                   three(RimX),    {v[RimXX], v[RimYY], v[RimZZ], v[RimXY], v[RimYZ], v[RimZX]}};
  c.volume = enclosedVolume(facets, centroid, r.piece.round, s.spacing);
}

/// Sums of a component that spans several ranks.
struct SharedValues {
  std::size_t record;
  std::array<double, sums> value;
};

/// Reduces the exact sums of shared components over ranks, a few at a time because they are long.
std::vector<SharedValues> sumShared(const Surface& s, const std::vector<std::uint32_t>& particles,
                                    const std::vector<std::uint32_t>& surfels,
                                    const std::vector<Group>& groups, std::vector<Record>& records,
                                    Reducer& all) {
  constexpr std::size_t together = 64, digits = ExactSum::digits, each = sums * digits;
  std::vector<SharedValues> shared;
  for (std::size_t k = 0; k < records.size(); k++)
    if (records[k].ranks > 1) shared.push_back({k, {}});
  std::array<ExactSum, sums> sum;
  std::vector<std::int64_t> digit;
  auto group = groups.begin();
  for (std::size_t first = 0; first < shared.size(); first += together) {
    const std::size_t last = std::min(shared.size(), first + together);
    digit.assign((last - first) * each, 0);
    for (std::size_t n = first; n < last; n++) {
      Record& r = records[shared[n].record];
      while (group != groups.end() && group->label < r.measured.label) ++group;
      if (group == groups.end() || group->label != r.measured.label) continue;
      addRows(s, *group, particles, surfels, r, sum);
      for (std::size_t q = 0; q < sums; q++) {
        sum[q].carry();
        std::copy(sum[q].digit.begin(), sum[q].digit.end(), &digit[(n - first) * each + q * digits]);
      }
    }
    all.sum(digit);
    for (std::size_t n = first; n < last; n++)
      for (std::size_t q = 0; q < sums; q++) {
        ExactSum total;
        std::copy_n(&digit[(n - first) * each + q * digits], digits, total.digit.begin());
        shared[n].value[q] = total.value();
      }
  }
  return shared;
}

}  // namespace

void measureComponents(Surface& s, Reducer& all) {
  const std::vector<std::uint32_t> particles = orderByLabel(s.particles.component.data(), s.particles.owned);
  const std::vector<std::uint32_t> surfels = orderByLabel(s.surfels.component.data(), s.surfels.owned);
  const std::vector<Group> groups = groupsOf(s, particles, surfels);
  std::vector<Record> records = recordsOf(s, particles, surfels, groups, all);

  // Components on this rank only are finished here.
  std::vector<std::uint64_t> finished;
  std::array<ExactSum, sums> sum;
  for (const Group& g : groups) {
    const std::size_t k = indexOf(records, g.label);
    if (records[k].ranks > 1) continue;
    addRows(s, g, particles, surfels, records[k], sum);
    finished.push_back(g.label);
    for (const ExactSum& q : sum) finished.push_back(std::bit_cast<std::uint64_t>(q.value()));
  }
  const std::vector<std::uint64_t> results = gatherWords(all, finished);
  const std::vector<SharedValues> shared = sumShared(s, particles, surfels, groups, records, all);

  std::array<double, sums> value;
  for (std::size_t at = 0; at < results.size(); at += 1 + sums) {
    for (std::size_t q = 0; q < sums; q++) value[q] = std::bit_cast<double>(results[at + 1 + q]);
    finish(s, records[indexOf(records, results[at])], value);
  }
  for (const SharedValues& v : shared) finish(s, records[v.record], v.value);
  const std::vector<SurfaceComponent> before = std::move(s.components);
  s.components.clear();
  std::size_t old = 0;
  for (const Record& r : records) {
    s.components.push_back(r.measured);
    while (old < before.size() && before[old].label < r.measured.label) old++;
    if (old < before.size() && before[old].label == r.measured.label)
      s.components.back().isoOffset = before[old].isoOffset;
  }
}

const SurfaceComponent* findComponent(const Surface& s, std::uint64_t label) {
  const auto at = std::lower_bound(s.components.begin(), s.components.end(), label,
                                   [](const SurfaceComponent& c, std::uint64_t l) { return c.label < l; });
  return at != s.components.end() && at->label == label ? &*at : nullptr;
}

}  // namespace thaw
