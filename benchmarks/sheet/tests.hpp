// SPDX-License-Identifier: Apache-2.0
// Measurements of the sheet benchmark.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace thaw::bench {

/// The CSV file; nullptr for none.
struct Out {
  std::FILE* file = nullptr;
  void line(const char* test, const char* what, const char* method, std::int64_t steps, double evaluations,
            double seconds, double value, const char* unit) const {
    if (file)
      std::fprintf(file, "%s,%s,%s,%lld,%.6g,%.6g,%.9g,%s\n", test, what, method,
                   static_cast<long long>(steps), evaluations, seconds, value, unit);
  }
};

/// The vertex update against a copy of as many bytes: best of several runs each, in turn. Returns true above
/// the target.
bool bandwidth(std::size_t vertices, const Out& out);

/// Frames of 1/25 s per second of scenes/sheet/head and jack, at the estimated sizes of the paper and at
/// `large` vertices.
void frames(std::size_t large, const Out& out);

/// Error against cost over ten periods of a damped oscillator under a constant force.
void oscillator(const Out& out);

/// Error against cost of the head with springs along its edges and volume pressure, over the first tenth of a
/// second after a press.
void head(const Out& out);

}  // namespace thaw::bench
