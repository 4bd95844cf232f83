// SPDX-License-Identifier: Apache-2.0
// Sheets (DS). Measures the vertex update against a copy of the same bytes, and frames per second of the head
// and the membrane against the paper. Then error against cost of the exact step, symplectic Euler, RK4 and
// implicit Euler, on an oscillator and the head.
//   scripts/bench sheet [--vertices 2000000] [--large 1000000] [--csv FILE] [--only
//   bandwidth|frames|accuracy]
// Lines of the CSV file: test,case,method,steps,evaluations,seconds,value,unit. Frames also give the
// phases of a step. Exits with 1 if the update has less than 120 % of the copy's rate.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "benchmarks/sheet/tests.hpp"
#include "benchmarks/support/options.hpp"

int main(int argc, char** argv) {
  using namespace thaw::bench;
  std::size_t vertices = 2000000, large = 1000000;
  std::string csv, only;
  for (int k = 1; k < argc; k += 2) try {
      const std::string key = argv[k];
      const bool help = key == "--help" || key == "-h";
      if (help || k + 1 == argc)
        return std::fprintf(help ? stdout : stderr,
                            "scripts/bench sheet [--vertices 2000000] [--large 1000000] [--csv FILE] [--only "
                            "bandwidth|frames|accuracy]\n"),
               help ? 0 : 2;
      if (key == "--vertices") vertices = countOf(key, argv[k + 1], 1000, 1000000000);
      else if (key == "--large") large = countOf(key, argv[k + 1], 1000, 1000000000);
      else if (key == "--csv") csv = argv[k + 1];
      else if (key == "--only") oneOf(key, only = argv[k + 1], {"bandwidth", "frames", "accuracy"});
      else throw std::invalid_argument("unknown option " + key);
    } catch (const std::invalid_argument& e) { return std::fprintf(stderr, "sheet: %s\n", e.what()), 2; }
  std::FILE* file = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
  if (!csv.empty() && !file) return std::fprintf(stderr, "sheet: cannot write %s\n", csv.c_str()), 2;
  if (file) std::fprintf(file, "test,case,method,steps,evaluations,seconds,value,unit\n");
  const Out out{file};
  bool good = true;
  if (only.empty() || only == "bandwidth") good = bandwidth(vertices, out);
  if (only.empty() || only == "frames") frames(large, out);
  if (only.empty() || only == "accuracy") {
    oscillator(out);
    head(out);
  }
  if (file) std::fclose(file);
  return good ? 0 : 1;
}
