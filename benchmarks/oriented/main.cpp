// SPDX-License-Identifier: Apache-2.0
// oriented [--csv FILE] [--strict]: accuracy of oriented bodies at rest and of a rebuilt mesh, and time of
// two neighbour searches.
//   plane, sphere   energies of co-planarity, co-normality and co-circularity per particle at rest, over
//                   stiffness spacing^2; spacing; radius; curvature
//   lattice         rest spacing of Lennard-Jones 12-6 with the full sum, over sigma
//   rebuilt         a head: points sampled from its mesh, thinned to 5 % and grown again; largest and mean
//                   distance from the original in spacings
//   neighbours      ms for the lists of all particles by cells and by nanoflann (tree and searches), for
//                   several numbers of particles
#include <cstdlib>
#include <string>

#include "benchmarks/oriented/tests.hpp"
#include "benchmarks/support/options.hpp"

int main(int argc, char** argv) {
  using namespace thaw::bench;
  const char* csv = nullptr;
  bool strict = false;
  std::string only;
  double spacing = 0.0125;  // m, spacing of the rebuilt surface
  for (int a = 1; a < argc; a++) try {
      const std::string key = argv[a];
      if (key == "--strict") strict = true;
      else if (key == "--csv" && a + 1 < argc) csv = argv[++a];
      else if (key == "--only" && a + 1 < argc)
        oneOf(key, only = argv[++a], {"plane", "lattice", "sphere", "rebuilt", "neighbours"});
      else if (key == "--spacing" && a + 1 < argc) spacing = numberOf(key, argv[++a], 1e-4, 1);
      else {
        const bool help = key == "--help" || key == "-h";
        return std::fprintf(
                   help ? stdout : stderr,
                   "scripts/bench oriented [--strict] [--only plane|lattice|sphere|rebuilt|neighbours] "
                   "[--spacing METRES] [--csv FILE]\n"),
               help ? 0 : 2;
      }
    } catch (const std::invalid_argument& e) { return std::fprintf(stderr, "oriented: %s\n", e.what()), 2; }
  Figures figures;
  figures.csv = std::fopen(csv ? csv : "/dev/null", "w");
  if (!figures.csv) return std::fprintf(stderr, "%s: cannot be written\n", csv), 3;
  std::fprintf(figures.csv, "case,particles,value,target_value\n");
  const auto wanted = [&](const char* name) { return only.empty() || only == name; };
  if (wanted("lattice")) lattice(figures);
  if (wanted("plane")) plane(figures);
  if (wanted("sphere")) sphere(figures);
  if (wanted("neighbours")) neighbours(figures);
  if (wanted("rebuilt")) rebuilt(figures, spacing);
  std::fclose(figures.csv);
  return strict && figures.missed > 0 ? 1 : 0;
}
