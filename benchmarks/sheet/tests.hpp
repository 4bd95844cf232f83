// What the benchmark of sheets measures.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace thaw::bench {

/// The CSV file; nullptr: none.
struct Out {
  std::FILE* file = nullptr;
  void line(const char* test, const char* what, const char* method, std::int64_t steps, double evaluations,
            double seconds, double value, const char* unit) const {
    if (file)
      std::fprintf(file, "%s,%s,%s,%lld,%.6g,%.6g,%.9g,%s\n", test, what, method,
                   static_cast<long long>(steps), evaluations, seconds, value, unit);
  }
};

/// The vertex update beside a copy of as many bytes, best of several each, taken in turn. True: at least 60 %
/// of the copy's speed.
bool bandwidth(std::size_t vertices, const Out& out);

/// Frames (of 1/25 s) a second of scenes/sheet/head and jack, at the sizes taken for the paper's and at
/// `large` vertices.
void frames(std::size_t large, const Out& out);

/// Error against cost over ten periods of a damped oscillator under a constant force.
void oscillator(const Out& out);

/// The same of the head, with springs along its edges and pressure of its volume, over its first tenth of a
/// second after a press.
void head(const Out& out);

}  // namespace thaw::bench
