// SPDX-License-Identifier: Apache-2.0
// damage_files NUMBER FILE [SEED]: damages copies of a checkpoint or a frame in different ways and reads each
// in a separate process. Prints how many were refused, accepted, or killed the process by a signal. Exits
// with 1 on a signal, or if a damaged checkpoint was accepted. damage_files 1 FILE SEED --keep leaves the
// damaged copy as FILE.damaged without reading it.
#include <mpi.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "io/checkpoint/checkpoint.hpp"

namespace {

using namespace thaw;

constexpr const char* kinds[] = {"bits flipped",      "cut short",      "page zeroed",   "blocks swapped",
                                 "bytes overwritten", "bytes appended", "piece left out"};
constexpr std::size_t kindsOfDamage = std::size(kinds);

/// The content with one kind of damage; always different from the original.
std::string damaged(const std::string& whole, std::size_t kind, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::string s = whole;
  while (s == whole) {
    const std::size_t page = 4096, at = below(s.size());
    switch (kind) {
      case 0:
        for (std::size_t k = 1 + below(4); k > 0; k--) s[below(s.size())] ^= static_cast<char>(1 << below(8));
        break;
      case 1: s.resize(at); break;
      case 2:
        std::fill_n(s.begin() + static_cast<std::ptrdiff_t>(at / page * page),
                    std::min(page, s.size() - at / page * page), '\0');
        break;
      case 3: {
        const std::size_t size = std::size_t(64) << below(8), n = s.size() / size;
        if (n < 2) break;
        const std::size_t a = below(n) * size, b = below(n) * size;
        std::swap_ranges(s.begin() + static_cast<std::ptrdiff_t>(a),
                         s.begin() + static_cast<std::ptrdiff_t>(a + (a == b ? 0 : size)),
                         s.begin() + static_cast<std::ptrdiff_t>(b));
        break;
      }
      case 4:
        for (std::size_t k = 0, n = 1 + below(600); k < n && at + k < s.size(); k++)
          s[at + k] = static_cast<char>(random());
        break;
      case 5: s.append(1 + below(5000), static_cast<char>(random())); break;
      default: s.erase(at, 1 + below(2000)); break;
    }
  }
  return s;
}

/// 0: accepted, 1: refused, 2: a signal.
int readApart(const std::string& path, bool checkpoint) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 0;
    try {
      if (checkpoint) readCheckpoint(path, MPI_COMM_SELF);
      else readFrame(path);
    } catch (const IoError& e) {
      code = 1;
      if (std::strlen(e.what()) <= path.size() + 2) code = 3;  // no reason given
    } catch (const std::exception& e) {
      std::printf("%s\n", e.what());
      code = 3;
    }
    std::fflush(stdout);
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) < 2) return WEXITSTATUS(status);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "damage_files NUMBER FILE [SEED [--keep]]\n"), 2;
  MPI_Init(&argc, &argv);
  const long number = std::atol(argv[1]);
  const std::string path = argv[2], copy = path + ".damaged";
  const auto seed = static_cast<std::uint64_t>(argc > 3 ? std::atol(argv[3]) : 1);
  const bool keep = argc > 4;
  std::ifstream in(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  const bool checkpoint = isCheckpoint(H5File::openToRead(path));
  long results[kindsOfDamage][3] = {}, wrong = readApart(path, checkpoint) == 0 ? 0 : 1;
  if (wrong > 0) std::printf("the undamaged file cannot be read\n");
  for (long k = 0; k < number; k++) {
    std::mt19937_64 random(seed * 1000003 + static_cast<std::uint64_t>(k));
    const std::size_t kind = static_cast<std::size_t>(static_cast<std::uint64_t>(k) + seed) % kindsOfDamage;
    std::ofstream(copy, std::ios::binary) << damaged(whole, kind, random);
    if (keep) break;
    const int result = readApart(copy, checkpoint);
    results[kind][result]++;
    if (result == 1 || (result == 0 && !checkpoint)) continue;
    wrong++;
    std::printf("damage %ld of seed %ld (%s): %s\n", k, static_cast<long>(seed), kinds[kind],
                result == 0 ? "accepted" : "a signal, or another exception");
  }
  for (std::size_t k = 0; k < kindsOfDamage && !keep; k++)
    std::printf("%-18s %5ld refused, %5ld accepted, %5ld signals\n", kinds[k], results[k][1], results[k][0],
                results[k][2]);
  if (!keep) ::unlink(copy.c_str());
  MPI_Finalize();
  return wrong > 0 ? 1 : 0;
}
