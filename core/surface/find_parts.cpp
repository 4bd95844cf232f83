#include <algorithm>
#include <limits>

#include "core/solid/id_table.hpp"
#include "core/surface/components.hpp"
#include "core/surface/place_rows.hpp"

namespace thaw {
namespace {

constexpr std::uint64_t surfelsOnly = std::uint64_t{1} << 63;
constexpr double cosRest = 0.70710678118654752;  // pi/4

/// Of a mesh's surfel, whose component is not known yet.
std::uint64_t bodyOf(std::uint64_t surfelId) { return surfelId >> 40 & 0x7fffff; }

/// What may hang together: of one component, and before there are any of one body.
bool alike(const Surfels& f, std::size_t i, std::size_t j) {
  return f.component[i] == f.component[j] && (f.component[i] != noComponent || bodyOf(f.id[i]) == bodyOf(f.id[j]));
}
bool alike(const SurfaceParticles& p, std::size_t i, std::size_t j) {
  return p.component[i] == p.component[j] && (p.component[i] != noComponent || p.body[i] == p.body[j]);
}
bool alike(const Surfels& f, std::size_t i, const SurfaceParticles& p, std::size_t j) {
  return f.component[i] == p.component[j] && (f.component[i] != noComponent || bodyOf(f.id[i]) == p.body[j]);
}

/// The least of two distances, the smaller id where they are the same.
struct Nearest {
  double d2 = std::numeric_limits<double>::infinity();
  std::uint64_t id = ~std::uint64_t{0};
  std::uint32_t row = 0xffffffffu;
  void offer(double r2, std::uint64_t i, std::uint32_t at) {
    if (r2 < d2 || (r2 == d2 && i < id)) *this = {r2, i, at};
  }
  bool found() const { return row != 0xffffffffu; }
};

class Sets {
 public:
  explicit Sets(ComponentTools& t) : parent_(t.parent), least_(t.least) {}
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
  /// True if that is less than what was known.
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

bool anywhere(Reducer& all, bool here) {
  double value[1] = {here ? 1.0 : 0.0};
  all.maximum(value);
  return value[0] > 0;
}

/// Square of the distance to the k-th nearest surfel of the same component, and the nearest particle: what the other end of a link must know.
void findReach(World& w, ComponentTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  const SurfaceParticles& p = s.particles;
  std::vector<double> near;
  for (std::size_t i = 0; i < f.owned; i++) {
    near.clear();
    t.surfelBins.forEachWithin(f.position[i], s.surfelSupport, [&](std::uint32_t j, double d2) {
      if (j != i && alike(f, i, j)) near.push_back(d2);
    });
    if (near.size() > nearestSurfels) std::nth_element(near.begin(), near.begin() + nearestSurfels - 1, near.end());
    f.reach[i] = near.empty() ? 0 : near.size() > nearestSurfels ? near[nearestSurfels - 1] : *std::max_element(near.begin(), near.end());
    // first within a spacing, which is where it mostly is
    Nearest best;
    for (const double radius : {std::min(w.scene.spacing, s.particleSupport), s.particleSupport}) {
      t.particleBins.forEachWithin(f.position[i], radius, [&](std::uint32_t j, double d2) {
        if (alike(f, i, p, j)) best.offer(d2, p.id[j], j);
      });
      if (best.found()) break;
    }
    f.nearest[i] = best.id;
  }
}

void joinSurfels(const Surface& s, const ComponentTools& t, Sets& sets) {
  const Surfels& f = s.surfels;
  // owned ends of links suffice: a link between two ghosts is somebody else's
  for (std::size_t i = 0; i < f.owned; i++)
    t.surfelBins.forEachWithin(f.position[i], s.surfelSupport, [&](std::uint32_t j, double d2) {
      if (j != i && alike(f, i, j) && d2 <= std::max(f.reach[i], f.reach[j]) && dot(f.normal[i], f.normal[j]) >= cosRest)
        sets.join(static_cast<std::uint32_t>(i), j);
    });
}

void joinParticles(const World& w, const ComponentTools& t, Sets& sets) {
  const SurfaceParticles& p = w.surface.particles;
  const auto offset = static_cast<std::uint32_t>(w.surface.surfels.size());
  for (std::size_t i = 0; i < p.owned; i++)
    t.particleBins.forEachWithin(p.position[i], w.scene.surface.linkLength * w.scene.spacing, [&](std::uint32_t j, double) {
      if (j != i && alike(p, i, j)) sets.join(offset + static_cast<std::uint32_t>(i), offset + j);
    });
}

/// Owned surfels with their nearest particle, owned particles with the ghost surfels whose nearest they are: so both ends' ranks know the link.
void joinBoth(const Surface& s, Sets& sets) {
  const Surfels& f = s.surfels;
  const SurfaceParticles& p = s.particles;
  const auto offset = static_cast<std::uint32_t>(f.size());
  IdTable rows;
  for (std::size_t j = p.size(); j-- > 0;) rows.insert(p.id[j], static_cast<std::uint32_t>(j));  // of several images the first, the owned one
  for (std::size_t i = 0; i < f.size(); i++) {
    if (f.nearest[i] == ~std::uint64_t{0}) continue;
    const std::uint32_t j = rows.find(f.nearest[i]);
    if (j != IdTable::none) sets.join(static_cast<std::uint32_t>(i), offset + j);
  }
}

}  // namespace

void adoptFresh(World& w, SurfaceHalos halos, ComponentTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const double link = w.scene.surface.linkLength * w.scene.spacing;
  t.particleBins.build(p.position.data(), p.size(), link);
  std::vector<std::uint32_t> fresh;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.component[i] == noComponent) fresh.push_back(static_cast<std::uint32_t>(i));
  std::vector<std::uint64_t> found;
  for (bool more = anywhere(halos.all, !fresh.empty()); more;) {
    found.assign(fresh.size(), noComponent);
    bool changed = false;
    for (std::size_t k = 0; k < fresh.size(); k++) {
      Nearest best;
      t.particleBins.forEachWithin(p.position[fresh[k]], link, [&](std::uint32_t j, double d2) {
        if (p.component[j] != noComponent) best.offer(d2, p.id[j], j);
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
    more = anywhere(halos.all, changed);
    if (more) refreshGhosts(halos.particles, p, ColumnList{&p.component});
  }

  bool changed = false;
  for (std::size_t i = 0; i < f.owned; i++) {
    if (f.component[i] != noComponent) continue;
    const std::uint64_t body = bodyOf(f.id[i]);
    Nearest own, any;
    t.particleBins.forEachWithin(f.position[i], s.particleSupport, [&](std::uint32_t j, double d2) {
      any.offer(d2, p.id[j], j);
      if (p.body[j] == body) own.offer(d2, p.id[j], j);
    });
    if (!any.found()) continue;
    f.component[i] = p.component[own.found() ? own.row : any.row];
    changed = true;
  }
  if (anywhere(halos.all, changed)) refreshGhosts(halos.surfels, f, ColumnList{&f.component});
}

void findParts(World& w, SurfaceHalos halos, ComponentTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  t.surfelBins.build(f.position.data(), f.size(), 0.5 * s.surfelSupport);
  t.particleBins.build(p.position.data(), p.size(), w.scene.surface.linkLength * w.scene.spacing);
  findReach(w, t);
  refreshGhosts(halos.surfels, f, ColumnList{&f.reach, &f.nearest});

  t.parent.clear();
  t.least.clear();
  Sets sets(t);
  for (std::size_t i = 0; i < f.size(); i++) sets.add(f.id[i] | surfelsOnly);
  for (std::size_t i = 0; i < p.size(); i++) sets.add(p.id[i] + 1);
  joinSurfels(s, t, sets);
  joinParticles(w, t, sets);
  joinBoth(s, sets);

  const auto offset = static_cast<std::uint32_t>(f.size());
  for (bool changed = true; changed;) {
    for (std::size_t i = 0; i < f.owned; i++) f.part[i] = sets.least(static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < p.owned; i++) p.part[i] = sets.least(offset + static_cast<std::uint32_t>(i));
    refreshGhosts(halos.surfels, f, ColumnList{&f.part});
    refreshGhosts(halos.particles, p, ColumnList{&p.part});
    bool lowered = false;
    for (std::size_t i = f.owned; i < f.size(); i++) lowered |= sets.lower(static_cast<std::uint32_t>(i), f.part[i]);
    for (std::size_t i = p.owned; i < p.size(); i++) lowered |= sets.lower(offset + static_cast<std::uint32_t>(i), p.part[i]);
    changed = anywhere(halos.all, lowered);
  }
}

}  // namespace thaw
