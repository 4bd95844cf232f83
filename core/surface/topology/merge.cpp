// SPDX-License-Identifier: Apache-2.0
#include "core/surface/topology/merge.hpp"

#include <algorithm>

#include "core/halo/gather_words.hpp"
#include "core/surface/data/remove_surfels.hpp"
#include "core/surface/search/multi_label_bins.hpp"

namespace thaw {
namespace {

struct ComponentPair {
  std::uint64_t a, b;  // a < b
  friend auto operator<=>(const ComponentPair&, const ComponentPair&) = default;
};

/// Disjoint sets of joined labels, the same on all ranks.
class Joined {
 public:
  explicit Joined(const std::vector<ComponentPair>& pairs) {
    for (const ComponentPair& p : pairs) label_.insert(label_.end(), {p.a, p.b});
    std::sort(label_.begin(), label_.end());
    label_.erase(std::unique(label_.begin(), label_.end()), label_.end());
    into_ = label_;
  }
  std::uint64_t of(std::uint64_t label) const {
    for (;;) {
      const auto at = std::lower_bound(label_.begin(), label_.end(), label);
      if (at == label_.end() || *at != label) return label;
      const std::uint64_t to = into_[static_cast<std::size_t>(at - label_.begin())];
      if (to == label) return label;
      label = to;
    }
  }
  bool none() const { return label_.empty(); }
  bool joins(std::uint64_t label) const { return std::binary_search(label_.begin(), label_.end(), label); }
  /// Joins two labels. Returns the label that disappears, or 0 if they are joined already.
  std::uint64_t join(std::uint64_t a, std::uint64_t b) {
    a = of(a);
    b = of(b);
    if (a == b) return 0;
    if (b < a) std::swap(a, b);
    into_[static_cast<std::size_t>(std::lower_bound(label_.begin(), label_.end(), b) - label_.begin())] = a;
    return b;
  }

 private:
  std::vector<std::uint64_t> label_, into_;
};

/// Spacings: contact distance between particles of two liquids, and largest distance of their midpoint from
/// either surface. The latter is 0.35 between two balls cut from a lattice. Separation requires at least 1.5
/// times the contact distance (components.hpp), which prevents flicker.
constexpr double touchLength = 1, touchGap = 0.4;

/// Returns the range (m) in which other surfaces are detected at particles. Approaching bodies are detected
/// long before they overlap by this much.
double particleContactReach(const Scene& scene, const Surface& surface) {
  return std::min(surface.particleSupport, std::max(2 * scene.spacing, 4 * surface.spacing));
}

/// Returns the range (m) in which other surfaces are detected at surfels. It is shorter than for particles,
/// which stay one spacing apart in contact. classifyJoining handles deeper surfels.
double surfelContactReach(const Scene& scene, const Surface& surface) {
  return std::min(surface.particleSupport, std::max(scene.spacing, 4 * surface.spacing));
}

/// Returns the previous component of a part of the last split, or noComponent for new particles and for
/// parts of several components.
std::uint64_t before(const ComponentTools& c, std::uint64_t label) {
  std::uint64_t from = noComponent;
  for (const ComponentTools::Piece& p : c.pieces)
    if (p.part == label) from = p.from;
  return from;
}

/// Returns whether two liquids touch at particle i. A particle of the other component must be within the
/// distance of neighbours in a liquid. The midpoint must lie in or near both surfaces. At this distance,
/// drops already exert pressure on each other and flatten, before a particle is inside the other drop.
bool touches(const SurfaceView& w, const ComponentTools& c, std::uint32_t i, std::uint64_t other,
             MergeTools& t) {
  const Surface& s = w.surface;
  const SurfaceParticles& p = s.particles;
  const double dx = w.scene.spacing;
  bool found = false;
  forRowsWithin(c.particleBins, p.position[i], touchLength * dx, [&](std::uint32_t j, double) {
    if (found || p.component[j] != other) return;
    const Vec3d middle = p.position[i] + 0.5 * (p.position[j] - p.position[i]);
    found = true;
    for (const std::uint64_t label : {p.component[i], other}) {
      findSides(s.surfels, c.surfelBins, {middle, label, false, dx}, t.inside, t.touching);
      found = found && !t.touching.empty() && t.touching[0].discsUsed >= leastDiscs &&
              t.touching[0].distance < touchGap * dx;
    }
  });
  return found;
}

/// Returns the pairs of components in contact, unique on all ranks. Requires: bins of surfels and, with
/// several parts, of particles.
std::vector<ComponentPair> contactPairs(const SurfaceView& w, Reducer& all, const ComponentTools& c,
                                        bool several, MergeTools& t) {
  const Surface& s = w.surface;
  const SurfaceParticles& p = s.particles;
  std::vector<ComponentPair> pairs;
  if (w.scene.surface.merge != MergeRule::None && several)
    forMultiLabel(c.particleBins,
                  multiLabelBins(c.particleBins, p.component.data(), c.surfelBins, s.surfels.component.data(),
                                 particleContactReach(w.scene, w.surface)),
                  [&](std::uint32_t i) {
                    if (i >= p.owned) return;
                    findSides(s.surfels, c.surfelBins,
                              {p.position[i], p.component[i], true, particleContactReach(w.scene, w.surface)},
                              t.inside, t.sides);
                    for (const SurfaceSide& side : t.sides) {
                      if (side.discsUsed < leastDiscs || side.distance >= touchLength * w.scene.spacing)
                        continue;
                      const bool liquid = side.liquid > 0.5 || (p.liquid.active && p.liquid[i] > 0.5f);
                      if (w.scene.surface.merge == MergeRule::Liquid && !liquid) continue;
                      if (side.distance >= 0 && !(liquid && touches(w, c, i, side.component, t))) continue;
                      pairs.push_back({std::min(side.component, p.component[i]),
                                       std::max(side.component, p.component[i])});
                    }
                  });
  const auto unique = [&] {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  };
  unique();
  std::vector<std::uint64_t> words;
  for (const ComponentPair& m : pairs) words.insert(words.end(), {m.a, m.b});
  words = gatherWords(all, words);
  pairs.clear();
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) pairs.push_back({words[k], words[k + 1]});
  unique();
  // Parts that separated in this update do not join again at once, because their ends are still open.
  std::erase_if(pairs, [&](const ComponentPair& m) {
    return before(c, m.a) != noComponent && before(c, m.a) == before(c, m.b);
  });
  return pairs;
}

/// Flags of MergeTools::open.
enum Seam : std::uint8_t { Disturbed = 1, Joint = 2 };

/// Classifies an owned surfel relative to other components. It dies if its component joins a component that
/// contains it or is close to it. Otherwise, it moves out of components that contain it.
void classifySurfel(const SurfaceView& w, std::uint32_t i, const Joined& joined, ComponentTools& c,
                    MergeTools& t) {
  const Surface& s = w.surface;
  const Surfels& f = s.surfels;
  findSides(f, c.surfelBins, {f.position[i], f.component[i], true, surfelContactReach(w.scene, w.surface)},
            t.inside, t.sides);
  Vec3d push{};
  for (const SurfaceSide& side : t.sides) {
    if (side.discsUsed < leastDiscs) continue;
    if (joined.of(side.component) == joined.of(f.component[i])) {
      if (side.distance < 0.5 * s.spacing) c.dead[i] = 1;
      // Resampling inspects surfels next to deleted ones.
      if (side.distance < 3 * s.spacing) t.open[i] |= Disturbed;
    } else if (side.distance < 0) {
      t.open[i] |= Disturbed;
      // The other side moves equally.
      push += std::min(-0.5 * side.distance, w.scene.spacing) * side.normal;
    }
  }
  t.moved[i] = f.position[i] + push;
}

/// Classifies an owned surfel of a joining component that is not close to the other surface. Finds whether
/// particles of the other component affect the common surface here, and whether the surfel lies deep
/// inside that component.
void classifyJoining(const Surface& s, std::uint32_t i, const Bins& joining, ComponentTools& c,
                     MergeTools& t) {
  const Surfels& f = s.surfels;
  int seen = 0;
  double nearest2 = never;
  // true if the surfel lies behind the nearest surfel
  bool behind = false;
  forRowsWithin(joining, f.position[i], s.particleSupport, [&](std::uint32_t j, double d2) {
    if (t.into[j] != t.into[i] || f.component[j] == f.component[i]) return;
    seen++;
    const bool back = dot(f.position[i] - f.position[j], f.normal[j]) < 0;
    behind = d2 < nearest2 ? back : d2 == nearest2 ? behind || back : behind;
    nearest2 = std::min(nearest2, d2);
  });
  if (seen < leastDiscs) return;
  t.open[i] |= Joint;
  if (!behind || c.dead[i]) return;
  findSides(f, joining, {f.position[i], f.component[i], true, s.particleSupport}, t.inside, t.sides);
  for (const SurfaceSide& side : t.sides)
    if (side.discsUsed >= leastDiscs && side.distance < 0 && t.into[side.nearest] == t.into[i]) c.dead[i] = 1;
}

void classifyAllJoining(const Surface& s, const Joined& joined, ComponentTools& c, MergeTools& t) {
  const Surfels& f = s.surfels;
  if (joined.none()) return;
  std::vector<std::uint8_t> joins(f.size());
  t.into.resize(f.size());
  for (std::size_t i = 0; i < f.size(); i++)
    joins[i] = joined.joins(f.component[i]), t.into[i] = joined.of(f.component[i]);
  Bins joining;
  pickRows(c.surfelBins, joins.data(), joining);
  forMultiLabel(joining,
                multiLabelBins(joining, f.component.data(), joining, f.component.data(), s.particleSupport),
                [&](std::uint32_t i) {
                  if (i < f.owned) classifyJoining(s, i, joining, c, t);
                });
}

}  // namespace

void mergeComponents(const SurfaceView& w, SurfaceHalos halos, ComponentTools& c, MergeTools& t) {
  Surface& s = w.surface;
  Surfels& f = s.surfels;
  SurfaceParticles& p = s.particles;
  const bool several = c.several();
  if (several) fillBins(f.position.data(), f.size(), s.surfelSupport, c.surfelBins);
  const std::vector<ComponentPair> pairs = contactPairs(w, halos.all, c, several, t);
  Joined joined(pairs);
  for (const ComponentPair& m : pairs) {
    const std::uint64_t gone = joined.join(m.a, m.b);
    if (gone == 0) continue;
    s.counters.merges++;
    s.events.push_back({w.clock.step, w.clock.time, SurfaceEventKind::Merge, joined.of(gone), gone});
  }
  c.dead.assign(f.owned, 0);
  t.moved.assign(f.position.data(), f.position.data() + f.owned);
  t.open.assign(f.owned, 0);
  if (several) {
    forMultiLabel(c.surfelBins,
                  multiLabelBins(c.surfelBins, f.component.data(), c.surfelBins, f.component.data(),
                                 surfelContactReach(w.scene, w.surface)),
                  [&](std::uint32_t i) {
                    if (i < f.owned) classifySurfel(w, i, joined, c, t);
                  });
    classifyAllJoining(s, joined, c, t);
  }
  std::copy(t.moved.begin(), t.moved.end(), f.position.data());
  for (std::size_t i = 0; i < f.owned; i++)
    if (t.open[i] & Disturbed) f.resampleMargin[i] = 0;
  if (!pairs.empty()) {
    // The two surfaces end in a seam. Grown surfels relax onto the common surface, even if solid.
    f.activate(f.relaxesOnce);
    for (std::size_t i = 0; i < f.owned; i++)
      if ((t.open[i] & Joint) && f.detail[i] < 0.5f) f.relaxesOnce[i] = 1;
    for (std::size_t i = 0; i < f.owned; i++) f.component[i] = joined.of(f.component[i]);
    for (std::size_t i = 0; i < p.owned; i++) p.component[i] = joined.of(p.component[i]);
  }
  std::int64_t deaths[1] = {removeSurfels(s, c.dead)};
  halos.all.sum(deaths);
  s.counters.deaths += deaths[0];
}

}  // namespace thaw
