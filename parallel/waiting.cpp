#include "parallel/waiting.hpp"

#include <sched.h>
#include <sys/prctl.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

namespace thaw {
namespace {

/// A bit for each core that this process may be scheduled on.
using CoreSet = std::array<std::uint64_t, CPU_SETSIZE / 64>;

CoreSet usableCores() {
  CoreSet cores{};
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return cores;  // more cores than the set holds: none is "not known"
  for (std::size_t k = 0; k < CPU_SETSIZE; k++)
    if (CPU_ISSET(k, &set)) cores[k / 64] |= std::uint64_t{1} << (k % 64);
  return cores;
}

/// Cores' worth of time that a container's quota allows (cgroup 2), rounded up.
int quotaOfCores() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  std::string quota;
  double period = 0;
  if (!(file >> quota >> period) || quota == "max" || period <= 0) return std::numeric_limits<int>::max();
  return std::max(1, static_cast<int>((std::strtod(quota.c_str(), nullptr) + period - 1) / period));
}

void sleepFor(long nanoseconds) {
  const timespec t{0, nanoseconds};
  nanosleep(&t, nullptr);
}

}  // namespace

bool ranksExceedCores(MPI_Comm comm) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int ranks = 1;
  MPI_Comm_size(machine, &ranks);
  CoreSet cores = usableCores();  // ranks that are bound see their own core alone
  MPI_Allreduce(MPI_IN_PLACE, cores.data(), static_cast<int>(cores.size()), MPI_UINT64_T, MPI_BOR, machine);
  MPI_Comm_free(&machine);
  int n = 0;
  for (const std::uint64_t word : cores) n += __builtin_popcountll(word);
  return n > 0 && ranks > std::min(n, quotaOfCores());
}

void Patience::pause() {
  static const long ns = getenv("SLEEPNS") ? atol(getenv("SLEEPNS")) : 20000;
  static const int first = getenv("LOOKS") ? atoi(getenv("LOOKS")) : 1;
  looks_++;
  if (crowded_) {
    if (looks_ <= first) return;
    if (ns == 0) sched_yield(); else sleepFor(ns);
    return;
  }
  if (looks_ > 256) sched_yield();
}

}  // namespace thaw
