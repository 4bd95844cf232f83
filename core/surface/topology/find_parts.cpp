// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <numbers>

#include "core/particles/id_table.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/search/multi_label_bins.hpp"
#include "core/surface/topology/components.hpp"

namespace thaw {
namespace {

constexpr std::uint64_t surfelsOnly = std::uint64_t{1} << 63;
constexpr double cosRest = std::numbers::sqrt2 / 2;  // pi/4
constexpr std::uint64_t noParticle = ~std::uint64_t{0};
/// Links of surfels require that the distance of their nearest particles is within this factor times the
/// longest particle link. The factor for liquids is larger, because falling streams stretch lengthwise (by
/// 2.4 from 2 to 5 m/s) but remain connected. The distance for solids exceeds the length of their bonds.
constexpr double solidLinkFactor = 5.0 / 3, liquidLinkFactor = 2;

/// Returns the body in the id of a mesh surfel, before its component is known.
std::uint64_t bodyOf(std::uint64_t surfelId) { return surfelId >> 40 & 0x7fffff; }

/// Returns whether two rows may be linked: they belong to one component, or, without components, to one body.
bool mayLink(const Surfels& f, std::size_t i, std::size_t j) {
  return f.component[i] == f.component[j] &&
         (f.component[i] != noComponent || bodyOf(f.id[i]) == bodyOf(f.id[j]));
}
bool mayLink(const SurfaceParticles& p, std::size_t i, std::size_t j) {
  return p.component[i] == p.component[j] && (p.component[i] != noComponent || p.body[i] == p.body[j]);
}
bool mayLink(const Surfels& f, std::size_t i, const SurfaceParticles& p, std::size_t j) {
  return f.component[i] == p.component[j] && (f.component[i] != noComponent || bodyOf(f.id[i]) == p.body[j]);
}

/// Returns whether a new particle may take the component of particle j. The scene's merge rule decides, as
/// for surfaces in contact (merge.cpp).
bool mayTake(const Scene& scene, const Surface& surface, std::size_t fresh, std::size_t j) {
  const SurfaceParticles& p = surface.particles;
  if (p.body[fresh] == p.body[j]) return true;
  const auto liquid = [&](std::size_t i) { return p.liquid.active && p.liquid[i] > 0.5f; };
  const MergeRule rule = scene.surface.merge;
  return rule == MergeRule::All || (rule == MergeRule::Liquid && (liquid(fresh) || liquid(j)));
}

/// Smallest distance found so far. Ties go to the smaller id.
struct Nearest {
  double d2 = std::numeric_limits<double>::infinity();
  std::uint64_t id = ~std::uint64_t{0};
  std::uint32_t row = 0xffffffffu;
  void update(double r2, std::uint64_t i, std::uint32_t at) {
    if (r2 < d2 || (r2 == d2 && i < id)) *this = {r2, i, at};
  }
  bool found() const { return row != 0xffffffffu; }
};

class UnionFind {
 public:
  explicit UnionFind(ComponentTools& t) : parent_(t.parent), least_(t.least) {}
  void add(std::uint64_t label) {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    least_.push_back(label);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i == j) return;
    if (j < i) std::swap(i, j);
    parent_[j] = i;
    least_[i] = std::min(least_[i], least_[j]);
  }
  std::uint64_t least(std::uint32_t i) { return least_[root(i)]; }
  /// Lowers the label of a set. Returns whether it changed.
  bool lower(std::uint32_t i, std::uint64_t label) {
    std::uint64_t& l = least_[root(i)];
    if (label >= l) return false;
    l = label;
    return true;
  }

 private:
  std::vector<std::uint32_t>& parent_;
  std::vector<std::uint64_t>& least_;
};

bool onAnyRank(Reducer& all, bool here) {
  double value[1] = {here ? 1.0 : 0.0};
  all.maximum(value);
  return value[0] > 0;
}

/// Lists rows of a block within a radius that may be linked to row i in `near`.
template<class Rows>
void listNear(const Rows& rows, std::uint32_t i, const RowBlock& block, double r2,
              std::vector<ComponentTools::Near>& near) {
  near.clear();
  const Vec3d x = rows.position[i];
  for (std::size_t k = 0; k < block.count; k++) {
    const Vec3d d = block.at[k] - x;
    const double d2 = dot(d, d);
    if (d2 <= r2 && block.row[k] != i && mayLink(rows, i, block.row[k])) near.push_back({d2, block.row[k]});
  }
}

/// Radius that contains ten neighbours of most surfels, in surfel radii.
constexpr double usualReach = 2.2;

/// Finds Surfels::nearest: the nearest particle that may be linked.
void findNearestParticles(const Scene& scene, Surface& s, ComponentTools& t) {
  Surfels& f = s.surfels;
  const SurfaceParticles& p = s.particles;
  const double first = std::min(scene.spacing, s.particleSupport);
  forBlocks(t.surfelBins, t.particleBins, first, t.block, [&](std::uint32_t i, const RowBlock& block) {
    if (i >= f.owned) return;
    Nearest best;
    for (std::size_t k = 0; k < block.count; k++) {
      const Vec3d d = block.at[k] - f.position[i];
      const double d2 = dot(d, d);
      if (d2 <= first * first && d2 <= best.d2 && mayLink(f, i, p, block.row[k]))
        best.update(d2, p.id[block.row[k]], block.row[k]);
    }
    if (!best.found())
      forRowsWithin(t.particleBins, f.position[i], s.particleSupport, [&](std::uint32_t j, double d2) {
        if (mayLink(f, i, p, j)) best.update(d2, p.id[j], j);
      });
    f.nearest[i] = best.id;
    if (best.found()) f.toNearest[i] = p.position[best.row] - f.position[i];
  });
}

/// Finds Surfels::linkRadius2: the squared distance to the k-th nearest surfel that may be linked. It is sent
/// to the other end of a link. 0 if all surfels within h_ss already belong to the part.
void findReach(Surface& s, ComponentTools& t, const std::vector<std::uint8_t>& mixed) {
  Surfels& f = s.surfels;
  const auto closer = [](const ComponentTools::Near& a, const ComponentTools::Near& b) {
    return a.d2 < b.d2;
  };
  const double usual = std::min(usualReach * s.spacing, s.surfelSupport),
               all2 = s.surfelSupport * s.surfelSupport;
  std::fill_n(f.linkRadius2.data(), f.owned, 0.0);
  for (std::size_t b = 0; b < t.surfelBins.size(); b++) {
    if (!mixed[b]) continue;
    t.block.find(t.surfelBins, boxOf(t.surfelBins, b), usual);
    for (std::uint32_t k = t.surfelBins.first[b]; k < t.surfelBins.first[b + 1]; k++) {
      const std::uint32_t i = t.surfelBins.row[k];
      if (i >= f.owned) continue;
      listNear(f, i, t.block, usual * usual, t.near);
      if (t.near.size() < nearestSurfels) {
        t.near.clear();
        forRowsWithin(t.surfelBins, f.position[i], s.surfelSupport, [&](std::uint32_t j, double d2) {
          if (j != i && mayLink(f, i, j)) t.near.push_back({d2, j});
        });
      }
      // With fewer than ten surfels, all within h_ss count.
      if (t.near.size() < nearestSurfels) f.linkRadius2[i] = all2;
      else
        std::nth_element(t.near.begin(), t.near.begin() + nearestSurfels - 1, t.near.end(), closer),
            f.linkRadius2[i] = t.near[nearestSurfels - 1].d2;
    }
  }
}

/// Joins surfels of these bins, ghosts included, with surfels within their link radius. This covers the
/// links of both ends.
void joinSurfels(const Scene& scene, const Surface& s, ComponentTools& t,
                 const std::vector<std::uint8_t>& mixed, UnionFind& sets) {
  const Surfels& f = s.surfels;
  const double link1 = scene.surface.linkLength * scene.spacing,
               solid2 = solidLinkFactor * solidLinkFactor * link1 * link1,
               liquid2 = liquidLinkFactor * liquidLinkFactor * link1 * link1;
  // Surfels on distant particles lie on two sides of a crack or of a parted neck.
  const auto supported = [&](std::uint32_t i, std::uint32_t j) {
    if (f.nearest[i] == noParticle || f.nearest[j] == noParticle) return true;
    const Vec3d d = f.position[j] - f.position[i] + f.toNearest[j] - f.toNearest[i];
    const double d2 = dot(d, d);
    return d2 <= solid2 || (d2 <= liquid2 && f.liquid.active && f.liquid[i] + f.liquid[j] > 1);
  };
  forMultiLabel(t.surfelBins, mixed, [&](std::uint32_t i) {
    if (f.linkRadius2[i] == 0) return;
    forRowsWithin(t.surfelBins, f.position[i], std::sqrt(f.linkRadius2[i]) * (1 + 1e-12),
                  [&](std::uint32_t j, double d2) {
                    if (j != i && d2 <= f.linkRadius2[i] && mayLink(f, i, j) &&
                        dot(f.normal[i], f.normal[j]) >= cosRest && supported(i, j))
                      sets.join(i, j);
                  });
  });
}

void joinParticles(const Scene& scene, const Surface& surface, ComponentTools& t, UnionFind& sets) {
  const SurfaceParticles& p = surface.particles;
  const auto offset = static_cast<std::uint32_t>(surface.surfels.size());
  const double longest = scene.surface.linkLength * scene.spacing;
  forBlocks(t.particleBins, t.particleBins, longest, t.block, [&](std::uint32_t i, const RowBlock& block) {
    // The link of two ghosts belongs to another rank.
    if (i >= p.owned) return;
    listNear(p, i, block, longest * longest, t.near);
    for (const ComponentTools::Near& n : t.near) sets.join(offset + i, offset + n.row);
  });
}

/// Joins owned surfels with their nearest particle, and owned particles with ghost surfels nearest to them.
/// Both ranks then have the link.
void joinBoth(const Surface& s, UnionFind& sets) {
  const Surfels& f = s.surfels;
  const SurfaceParticles& p = s.particles;
  const auto offset = static_cast<std::uint32_t>(f.size());
  IdTable rows;
  // Reverse order keeps the first of several images, the owned one.
  for (std::size_t j = p.size(); j-- > 0;) rows.insert(p.id[j], static_cast<std::uint32_t>(j));
  for (std::size_t i = 0; i < f.size(); i++) {
    if (f.nearest[i] == noParticle) continue;
    const std::uint32_t j = rows.find(f.nearest[i]);
    if (j != IdTable::none) sets.join(static_cast<std::uint32_t>(i), offset + j);
  }
}

/// Exchanges part labels until the parts of all ranks agree.
void unifyParts(Surface& s, SurfaceHalos halos, UnionFind& sets) {
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const auto offset = static_cast<std::uint32_t>(f.size());
  for (bool changed = true; changed;) {
    for (std::size_t i = 0; i < f.owned; i++) f.part[i] = sets.least(static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < p.owned; i++) p.part[i] = sets.least(offset + static_cast<std::uint32_t>(i));
    refreshGhosts(halos.surfels, f, ColumnList{&f.part});
    refreshGhosts(halos.particles, p, ColumnList{&p.part});
    bool lowered = false;
    for (std::size_t i = f.owned; i < f.size(); i++)
      lowered |= sets.lower(static_cast<std::uint32_t>(i), f.part[i]);
    for (std::size_t i = p.owned; i < p.size(); i++)
      lowered |= sets.lower(offset + static_cast<std::uint32_t>(i), p.part[i]);
    changed = onAnyRank(halos.all, lowered);
  }
}

}  // namespace

void labelNewParticles(const Scene& scene, Surface& s, SurfaceHalos halos, ComponentTools& t) {
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const double link = scene.surface.linkLength * scene.spacing;
  fillBins(p.position.data(), p.size(), link, t.particleBins);
  std::vector<std::uint32_t> fresh;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.component[i] == noComponent) fresh.push_back(static_cast<std::uint32_t>(i));
  std::vector<std::uint64_t> found;
  for (bool more = onAnyRank(halos.all, !fresh.empty()); more;) {
    found.assign(fresh.size(), noComponent);
    bool changed = false;
    for (std::size_t k = 0; k < fresh.size(); k++) {
      Nearest best;
      forRowsWithin(t.particleBins, p.position[fresh[k]], link, [&](std::uint32_t j, double d2) {
        if (p.component[j] != noComponent && mayTake(scene, s, fresh[k], j)) best.update(d2, p.id[j], j);
      });
      if (!best.found()) continue;
      found[k] = p.component[best.row];
      changed = true;
    }
    std::size_t left = 0;
    for (std::size_t k = 0; k < fresh.size(); k++) {
      if (found[k] != noComponent) p.component[fresh[k]] = found[k];
      else fresh[left++] = fresh[k];
    }
    fresh.resize(left);
    more = onAnyRank(halos.all, changed);
    if (more) refreshGhosts(halos.particles, p, ColumnList{&p.component});
  }

  bool changed = false;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (f.component[i] != noComponent) continue;
    const std::uint64_t body = bodyOf(f.id[i]);
    Nearest own, any;
    forRowsWithin(t.particleBins, f.position[i], s.particleSupport, [&](std::uint32_t j, double d2) {
      any.update(d2, p.id[j], j);
      if (p.body[j] == body) own.update(d2, p.id[j], j);
    });
    if (!any.found()) continue;
    f.component[i] = p.component[own.found() ? own.row : any.row];
    changed = true;
  }
  if (onAnyRank(halos.all, changed)) refreshGhosts(halos.surfels, f, ColumnList{&f.component});
}

// Particles connect most bodies. Surfels are tested only where different parts meet afterwards.
void findParts(const Scene& scene, Surface& s, SurfaceHalos halos, ComponentTools& t) {
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  fillBins(f.position.data(), f.size(), std::min(usualReach * s.spacing, s.surfelSupport), t.surfelBins);
  fillBins(p.position.data(), p.size(), scene.surface.linkLength * scene.spacing, t.particleBins);
  findNearestParticles(scene, s, t);
  refreshGhosts(halos.surfels, f, ColumnList{&f.nearest, &f.toNearest});
  t.parent.clear();
  t.least.clear();
  UnionFind sets(t);
  for (std::size_t i = 0; i < f.size(); i++) sets.add(f.id[i] | surfelsOnly);
  for (std::size_t i = 0; i < p.size(); i++) sets.add(p.id[i] + 1);
  joinParticles(scene, s, t, sets);
  joinBoth(s, sets);
  unifyParts(s, halos, sets);
  const std::vector<std::uint8_t> mixed = multiLabelBins(t.surfelBins, f.part.data(), t.surfelBins,
                                                         f.part.data(), s.surfelSupport);
  if (!onAnyRank(halos.all, std::find(mixed.begin(), mixed.end(), 1) != mixed.end())) return;
  findReach(s, t, mixed);
  refreshGhosts(halos.surfels, f, ColumnList{&f.linkRadius2});
  joinSurfels(scene, s, t, mixed, sets);
  unifyParts(s, halos, sets);
}

}  // namespace thaw
