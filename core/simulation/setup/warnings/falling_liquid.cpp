// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/falling_liquid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/domain/sides.hpp"
#include "core/scene/modules.hpp"
#include "core/simulation/setup/warnings/chosen_rows.hpp"

namespace thaw {
namespace {

constexpr double mostFollowed = 200;  // particles per body or emitter

/// End of a free fall.
struct Exit {
  double time = never;  // s; never: something stops the fall, or the scene ends first
  int axis = 0, high = 0;
};

/// Start of a free fall.
struct Drop {
  Vec3d place, velocity;
  double time = 0;   // s
  std::size_t body;  // index of its own body, which does not stop it
};

/// Free fall through the obstacles and solid bodies of a scene.
class FreeFall {
 public:
  FreeFall(const World& w, const std::vector<std::shared_ptr<const SignedDistance>>& shapes) : w_(w) {
    const Scene& s = w.scene;
    std::size_t originals = 0;
    for (const Wall& wall : w.walls.list) {
      if (!wall.isImage() && ++originals > s.obstacles.size())
        break;  // the remaining walls are sides of the
                // domain
      walls_.list.push_back(wall);
    }
    for (std::size_t b = 0; b < shapes.size(); b++)
      if (solidAtStart(s, s.bodies[b]) || s.bodies[b].temperatureField)
        solids_.push_back({b, shapes[b].get()});
  }

  /// Follows a particle to a side of the domain, in increments of at most a spacing.
  Exit follow(Drop d) {
    const Scene& s = w_.scene;
    const Vec3d gravity = s.domain.gravity;
    const double h = s.spacing, weight = length(gravity);
    while (d.time < s.end) {
      if (stopped(d)) return {};
      const double speed = length(d.velocity),
                   dt = 2 * h / (speed + std::sqrt(speed * speed + 4 * weight * h));
      d.place += d.velocity * dt + gravity * (0.5 * dt * dt);
      d.velocity += gravity * dt;
      d.time += dt;
      if (wrapPlace(w_.grid, s.domain, d.place) != 0) return {};  // an endless fall
      for (int a = 0; a < 3; a++)
        for (int high = 0; high < 2; high++) {
          const double beyond = high ? d.place[a] - s.domain.max[a] : s.domain.min[a] - d.place[a];
          if (beyond < 0) continue;
          if (s.domain.side[static_cast<std::size_t>(a)][static_cast<std::size_t>(high)] == Side::Open)
            return exitAt(d.time - beyond / std::abs(d.velocity[a]), a, high);
          // Liquid slides along a wall, unless gravity presses it against the wall.
          if ((high ? gravity[a] : -gravity[a]) > 1e-9 * weight) return {};
          d.place[a] = high ? s.domain.max[a] : s.domain.min[a];
          d.velocity[a] = 0;
        }
    }
    return {};
  }

 private:
  struct Solid {
    std::size_t body;
    const SignedDistance* shape;
  };
  const World& w_;
  Walls walls_;
  std::vector<Solid> solids_;

  Exit exitAt(double time, int axis, int high) const {
    return time < w_.scene.end ? Exit{time, axis, high} : Exit{};
  }

  bool stopped(const Drop& d) {
    const double h = w_.scene.spacing;
    moveWalls(walls_, d.time);
    for (const Wall& wall : walls_.list)
      if (wall.present && wall.shape->distanceWithin(toRest(wall.pose, d.place), h) < h) return true;
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
      return solid.body != d.body && nearBounds(solid.shape->bounds(), d.place, h) &&
             solid.shape->distanceWithin(d.place, h) < h;
    });
  }
};

/// The earliest exit of a source, or none if one of its particles stays.
struct Leaving {
  Exit first;
  bool stays = false;
  void add(const Exit& e) {
    stays = stays || e.time == never;
    if (e.time < first.time) first = e;
  }
};

SceneWarning warningOf(const std::string& source, const SourcePlace& where, const Exit& exit) {
  static constexpr const char* ends[2] = {"low", "high"};
  const char axis = static_cast<char>('x' + exit.axis);
  char text[320];
  std::snprintf(
      text, sizeof text,
      " falls out of the domain: no obstacle or solid body is in its way, and the %s %c side is open. "
      "Its first particles leave at %.2g s. Put an obstacle below it, or close the side "
      "(`domain.sides = { %c = \"wall\" }`)",
      ends[exit.high], axis, exit.time, axis);
  return {where, source + text};
}

/// Follows particles of the bodies of liquid. Collective.
std::vector<Leaving> bodiesThatLeave(const World& w, FreeFall& fall,
                                     const std::vector<std::int64_t>& particles, Reducer& all) {
  const Continuum& p = w.particles;
  const std::size_t n = w.scene.bodies.size();
  std::vector<Leaving> leaving(n);
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::size_t b = p.body[i];
    if (b >= n || leaving[b].stays || !chosenById(p.id[i], particles[b], mostFollowed)) continue;
    const bool free = p.phase[i] == Liquid && !(p.clamped.active && p.clamped[i]);
    leaving[b].add(free ? fall.follow({p.position[i], p.velocity[i], 0, b}) : Exit{});
  }
  std::vector<double> largest(n * 2);  // stays, and the earliest time, negated
  for (std::size_t b = 0; b < n; b++) {
    largest[2 * b] = leaving[b].stays;
    largest[2 * b + 1] = -leaving[b].first.time;
  }
  all.maximum(largest);
  std::vector<double> side(n, -1);
  for (std::size_t b = 0; b < n; b++) {
    const Exit& own = leaving[b].first;
    if (-own.time == largest[2 * b + 1]) side[b] = 2 * own.axis + own.high;
  }
  all.maximum(side);
  for (std::size_t b = 0; b < n; b++) {
    const int k = static_cast<int>(side[b]);
    leaving[b] = {{-largest[2 * b + 1], k / 2, k % 2}, largest[2 * b] > 0};
  }
  return leaving;
}

/// Follows particles of the first layer of an emitter. The same on all ranks.
Leaving emitterThatLeaves(const Emitter& e, const EmitterPlan& plan, FreeFall& fall, std::size_t bodies) {
  Leaving leaving;
  const std::size_t stride = 1 + plan.layer.size() / static_cast<std::size_t>(mostFollowed);
  for (std::size_t k = 0; k < plan.layer.size() && !leaving.stays; k += stride) {
    const Vec3d velocity = plan.velocity.empty() ? normalized(e.direction) * e.speed : plan.velocity[k];
    leaving.add(fall.follow({plan.layer[k], velocity, e.start, bodies}));
  }
  return leaving;
}

}  // namespace

std::vector<SceneWarning> fallingLiquids(const World& w,
                                         const std::vector<std::shared_ptr<const SignedDistance>>& shapes,
                                         const std::vector<EmitterPlan>& emitters,
                                         const std::vector<std::int64_t>& particles, Reducer& all) {
  const Scene& s = w.scene;
  std::vector<SceneWarning> warnings;
  if (!w.modules.fluid || w.modules.bodyTypes() || !s.extensions.empty() || length(s.domain.gravity) == 0 ||
      !hasOpenSide(s.domain))
    return warnings;
  FreeFall fall(w, shapes);
  const auto add = [&](const Leaving& leaving, const std::string& source, const SourcePlace& where) {
    if (!leaving.stays && leaving.first.time < never)
      warnings.push_back(warningOf(source, where, leaving.first));
  };
  const std::vector<Leaving> leaving = bodiesThatLeave(w, fall, particles, all);
  for (std::size_t b = 0; b < s.bodies.size(); b++)
    add(leaving[b], "body '" + s.bodies[b].name + "'", s.bodies[b].where);
  for (std::size_t e = 0; e < emitters.size(); e++)
    if (const Emitter& emitter = s.emitters[e];
        !solidAt(s.materials[static_cast<std::size_t>(emitter.material)], emitter.temperature))
      add(emitterThatLeaves(emitter, emitters[e], fall, s.bodies.size()), "emitter '" + emitter.name + "'",
          emitter.where);
  return warnings;
}

}  // namespace thaw
