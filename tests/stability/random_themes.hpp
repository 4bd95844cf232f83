// SPDX-License-Identifier: Apache-2.0
// Parts and themes of random scenes (random_scene.cpp).
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "core/math/hash_random.hpp"

namespace thaw::test {

/// A sequence of random numbers that is a function of the seed.
struct Dice {
  std::uint64_t seed, n = 0;
  double unit() { return randomUniform(seed, Purpose::Test, n++); }
  double between(double a, double b) { return a + (b - a) * unit(); }
  double decades(double a, double b) { return std::pow(10, between(std::log10(a), std::log10(b))); }
  bool chance(double p) { return unit() < p; }
  int below(int k) { return static_cast<int>(unit() * k); }
  const char* of(std::initializer_list<const char*> words) {
    return words.begin()[below(static_cast<int>(words.size()))];
  }
};

inline std::string vec(double x, double y, double z) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", x, y, z);
}

/// A shape that fits into a ball of this radius: its key with a table, and its approximate volume.
struct RandomShape {
  std::string text;
  double volume;
};
inline RandomShape shape(Dice& d, double radius, bool joined = true) {
  const auto size = [&](double least) { return radius * d.between(least, 1); };
  switch (d.below(joined ? 6 : 4)) {
    case 0: {
      const double a = size(0.3), b = size(0.3), c = size(0.3),
                   s = 2 * radius / std::sqrt(a * a + b * b + c * c);
      return {fmt::format("box = {{ size = {} }}", vec(a * s, b * s, c * s)), a * b * c * s * s * s};
    }
    case 1: {
      const double r = size(0.6);
      return {fmt::format("sphere = {{ radius = {:.6g} }}", r), 4.19 * r * r * r};
    }
    case 2: {
      const double angle = d.between(0.3, 1.3), r = radius * std::sin(angle),
                   h = 2 * radius * std::cos(angle);
      return {fmt::format("cylinder = {{ radius = {:.6g}, height = {:.6g} }}", r, h), 3.14 * r * r * h};
    }
    case 3: {
      const double tube = radius * d.between(0.15, 0.35), ring = radius - tube;
      return {fmt::format("torus = {{ radius = {:.6g}, tube = {:.6g} }}", ring, tube),
              19.7 * ring * tube * tube};
    }
    default: {
      const double away = 0.45 * radius;
      const RandomShape a = shape(d, 0.55 * radius, false), b = shape(d, 0.55 * radius, false);
      const bool all = d.chance(0.7);
      const double up = all ? away : 0.2 * away;
      return {fmt::format("{} = [{{ {}, place = {{ move = {} }} }}, {{ {}, place = {{ move = {}, rotate_x = "
                          "{:.4g} }} }}]",
                          all ? "union" : "difference", a.text, vec(0, 0, -up), b.text, vec(0, 0, up),
                          d.between(0, 3)),
              all ? a.volume + b.volume : 0.8 * a.volume};
    }
  }
}

/// Size, spacing and speed of a themed scene.
struct Scale {
  double radius, spacing, speed;
};

/// Rigid pieces that collide, break, melt, freeze, float, roll and sleep, beside soft solids and liquid.
std::string rigidScene(Dice& dice, std::uint64_t seed);
/// A pool and a block that lamps, lasers and heated regions heat: buoyancy, flow laws, evaporation, mush,
/// tension by temperature, contact angles and contact conductance.
std::string heatedScene(Dice& dice, std::uint64_t seed);

}  // namespace thaw::test
