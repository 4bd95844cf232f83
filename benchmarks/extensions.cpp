// SPDX-License-Identifier: Apache-2.0
// extensions: cost of a pair force and of an elastic law of an extension over built-in ones with the same
// equations.
//   extensions [--csv FILE] [--blocks 40] [--spacing 0.02] [--only PART/VARIANT]
// Two simulations step in turn, one with the built-in part and one with the copy. Figures are the fastest
// blocks in processor time, since other programs only add to it. `none` has no such part.
// --only "elastic law/extension" steps that simulation alone: valgrind --tool=none or callgrind then counts
// instructions, as the difference of two numbers of blocks.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/terms/extensions.hpp"
#include "io/simulation/simulation.hpp"
#include "parallel/communicator.hpp"
#include "tests/support/extensions/copies.hpp"

namespace {

using namespace thaw;

constexpr int stepsOfBlock = 5;

std::string sceneOf(const std::string& spacing, const std::string& material, const std::string& more) {
  return "spacing = " + spacing +
         "\nend = 100\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\ngravity = [0, 0, 0]\n[material.it]\n"
         "density = 1000\n" +
         material +
         "[[body]]\nname = \"ball\"\nsphere = { radius = 0.3 }\nmaterial = \"it\"\n"
         "velocity = { x = \"0.3 * y\", y = \"0.1 * z\" }\n" +
         more;
}

struct Variant {
  std::string name, text;
};
struct Comparison {
  std::string part;
  std::vector<Variant> variants;  // the first is the built-in one
};

std::vector<Comparison> comparisons(const std::string& spacing) {
  const std::string liquid = "viscosity = \"1 Pa s\"\nsound_speed = 20\n",
                    elastic = "young = \"100 kPa\"\npoisson = 0.35\n",
                    pairs =
                        "[numerics]\ntension = \"pairwise\"\nfixed_step = 2e-4\ndensity = \"summation\"\n"
                        "shifting = 0\nviscosity_correction = false\n",
                    fixed = "[numerics]\nfixed_step = 2e-4\n",
                    single = fixed + "elastic_precision = \"single\"\n";
  return {{"pair force",
           {{"built-in", sceneOf(spacing, liquid + "surface_tension = 1\n", pairs)},
            {"extension", sceneOf(spacing, liquid, pairs + "[extension.copy_of_tension]\n")},
            {"none", sceneOf(spacing, liquid, pairs)}}},
          {"elastic law",
           {{"built-in", sceneOf(spacing, elastic + "law = \"neo-hookean\"\n", fixed)},
            {"extension", sceneOf(spacing, elastic + "law = \"copy\"\n", fixed)}}},
          {"single elastic law",
           {{"built-in", sceneOf(spacing, elastic + "law = \"neo-hookean\"\n", single)},
            {"extension", sceneOf(spacing, elastic + "law = \"single_copy\"\n", single)}}}};
}

double blockOf(Simulation& sim) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  sim.runSteps(stepsOfBlock);
  return (now() - start) / stepsOfBlock;
}

void measure(const Comparison& c, int blocks, std::ostream* csv) {
  std::vector<Simulation> sims;
  for (const Variant& v : c.variants)
    sims.push_back(Simulation::fromText(v.text, {.scene = v.name}, MPI_COMM_SELF));
  std::vector<double> fastest(sims.size(), never);
  for (Simulation& s : sims) blockOf(s);
  for (int n = 0; n < blocks; n++)
    for (std::size_t k = 0; k < sims.size(); k++) fastest[k] = std::min(fastest[k], blockOf(sims[k]));
  for (std::size_t k = 0; k < sims.size(); k++) {
    const std::size_t particles = sims[k].particles().owned;
    const double ratio = fastest[k] / fastest[0];
    std::printf("%-18s %-10s %zu particles  %.4f ms a step  ratio %.4f\n", c.part.c_str(),
                c.variants[k].name.c_str(), particles, 1e3 * fastest[k], ratio);
    if (csv)
      *csv << c.part << ',' << c.variants[k].name << ',' << particles << ',' << 1e3 * fastest[k] << ','
           << ratio << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  MpiSession mpi(&argc, &argv);
  std::string file, spacing = "0.02", only;
  int blocks = 40;
  for (int k = 1; k + 1 < argc; k += 2) {
    const std::string key = argv[k];
    if (key == "--csv") file = argv[k + 1];
    if (key == "--only") only = argv[k + 1];
    if (key == "--spacing") spacing = argv[k + 1];
    if (key == "--blocks") blocks = std::max(1, std::atoi(argv[k + 1]));
  }
  for (Extension e : {test::copyOfTension(), test::copyOfNeoHookean(), test::singleCopyOfNeoHookean()})
    registerExtension(std::move(e));
  std::vector<Comparison> all = comparisons(spacing);
  std::ofstream csv;
  if (!file.empty()) {
    csv.open(file);
    csv << "part,variant,particles,ms_per_step,ratio\n";
  }
  for (Comparison& c : all) {
    if (!only.empty())
      std::erase_if(c.variants, [&](const Variant& v) { return c.part + "/" + v.name != only; });
    if (!c.variants.empty()) measure(c, blocks, file.empty() ? nullptr : &csv);
  }
  return 0;
}
