// SPDX-License-Identifier: Apache-2.0
#include "core/time/frame_times.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace thaw {
namespace {

/// Returns the double nearest to t rounded to 15 decimal digits. In doubles, 12 * 0.05 is not 0.6, but a
/// run that ends at 0.6 and continues must equal a run that did not stop.
double inDecimals(double t) {
  char digits[32];
  const auto written = std::to_chars(digits, digits + sizeof digits, t, std::chars_format::general, 15);
  double read = t;
  std::from_chars(digits, written.ptr, read);
  return read;
}

}  // namespace

double frameTime(const Clock& c, std::int64_t frame) {
  const double t = inDecimals(static_cast<double>(frame) * c.every);
  return std::abs(t - c.end) < 1e-9 * c.every ? c.end : t;
}

bool frameDue(const Clock& c) { return c.every > 0 && c.time >= frameTime(c, c.frame); }

namespace {

/// Returns the next time (s) to hit: that of a frame, or the end.
double target(const Clock& c) {
  if (!(c.every > 0)) return c.end;
  std::int64_t k = std::max(c.frame, static_cast<std::int64_t>(std::min(c.time / c.every, 9e15)));
  while (frameTime(c, k) <= c.time) k++;
  return std::min(c.end, frameTime(c, k));
}

/// Fraction of a step by which a sum of steps may miss a frame time. It allows for rounding over 1e9 steps in
/// double precision.
constexpr double rounding = 1e-6;

}  // namespace

double clip(const Clock& c, double dt) {
  const double left = target(c) - c.time;
  if (!(left > 0)) return dt;
  const double steps = std::ceil(left / dt - rounding);
  return steps > 1 ? left / steps : left;
}

double nextStep(const Clock& c) {
  constexpr double shortest = 0.95, margin = 0.985;  // fractions of the target step: smallest step that is
                                                     // kept; step after a change
  if (!(c.dt > 0)) return c.dt;
  if (!(c.stepDt > 0)) return clip(c, c.dt);
  const double same = clip(c, c.stepDt);
  const bool kept = same <= c.dt * (1 + rounding) && same >= shortest * c.dt;
  return kept ? same : clip(c, margin * c.dt);
}

double longestUnlimitedStep(const Clock& c) { return c.every > 0 ? c.every : c.end; }

double timeAfter(const Clock& c, double dt) {
  const double t = target(c);
  return c.time + dt >= t || t - (c.time + dt) < 1e-9 * dt ? t : c.time + dt;
}

}  // namespace thaw
