// SPDX-License-Identifier: Apache-2.0
// output: seconds and bytes per second of a frame and of a checkpoint, against dd writing as many bytes to
// the same disk.
//   output [--particles 1000000] [--repeat 5] [--folder out/bench/output] [--csv FILE]
// A frame (position, velocity, pressure, density, id) is written, read for its layout, and renamed. A
// checkpoint is also synced to the disk and read back whole, so dd also syncs (conv=fsync) and reads the file
// once (`dd of=/dev/null`). thaw and dd take turns; figures are medians. thaw uses all ranks of the launch;
// dd is one process.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/support/options.hpp"
#include "benchmarks/support/rig.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/frames/frame_fields.hpp"

namespace {

using namespace thaw;
using namespace thaw::bench;

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

/// A block of liquid with about this number of particles.
Scene block(double particles) {
  Scene s;
  s.spacing = 0.01;
  const double half = 0.5 * s.spacing * std::max(1.0, std::round(std::cbrt(particles)));
  s.domain.min = {-2 * half, -2 * half, -2 * half};
  s.domain.max = {2 * half, 2 * half, 2 * half};
  s.materials.emplace_back();
  s.materials[0].name = "water";
  s.bodies.emplace_back();
  s.bodies[0].name = "block";
  s.bodies[0].shape.size = {2 * half, 2 * half, 2 * half};
  s.output.fields = {"velocity", "pressure", "density"};
  s.end = 1;
  return s;
}

/// Wall-clock seconds of a collective call: the maximum over ranks.
template<class Call> double seconds(const Communicator& comm, Call call) {
  MPI_Barrier(comm.handle());
  const double begin = MPI_Wtime();
  call();
  double took = MPI_Wtime() - begin;
  MPI_Allreduce(MPI_IN_PLACE, &took, 1, MPI_DOUBLE, MPI_MAX, comm.handle());
  return took;
}

void dd(const Communicator& comm, const std::string& arguments) {
  int code = 0;
  if (comm.rank() == 0) code = std::system(("dd status=none bs=1M " + arguments).c_str());
  MPI_Bcast(&code, 1, MPI_INT, 0, comm.handle());
  if (code != 0) throw std::runtime_error("dd " + arguments + " fails");
}

/// A folder that is removed at the end of this object's life.
struct Folder {
  const Communicator& comm;
  std::string path;
  Folder(const Communicator& c, const std::string& p) : comm(c), path(p) {
    if (comm.rank() == 0) std::filesystem::create_directories(path + "/checkpoint");
    MPI_Barrier(comm.handle());
  }
  ~Folder() {
    std::error_code ignored;
    if (comm.rank() == 0) std::filesystem::remove_all(path, ignored);
  }
};

struct Result {
  const char* name;
  double megabytes, ours, dd;
};

int run(int argc, char** argv) {
  double particles = 1e6;
  int repeat = 5;
  std::string folder = "out/bench/output", csv;
  for (int k = 1; k < argc; k += 2) {
    const std::string key = argv[k];
    if (k + 1 == argc)
      throw std::invalid_argument("output [--particles N] [--repeat R] [--folder F] [--csv FILE]");
    if (key == "--particles") particles = numberOf(key, argv[k + 1], 1, 1e9);
    else if (key == "--repeat") repeat = static_cast<int>(countOf(key, argv[k + 1], 1, 10000));
    else if (key == "--folder") folder = argv[k + 1];
    else if (key == "--csv") csv = argv[k + 1];
    else throw std::invalid_argument("unknown option " + key);
  }
  const Communicator comm;
  const Folder there(comm, folder);
  Rig rig(comm, block(particles), [](Continuum&) {});
  for (int k = 0; k < 3; k++) rig.step();
  const std::string frame = folder + "/frame.hdf", copy = folder + "/dd";
  std::string checkpoint;
  std::vector<double> ours[2], theirs[2];
  for (int turn = 0; turn < repeat; turn++) {
    rig.step();
    ours[0].push_back(seconds(comm, [&] {
      findStoredEnergy(rig.w, rig.tools);  // a run updates it before output
      writeFrame(frame, comm.handle(), frameOf(rig.w, comm.rank()), {"output", "", false});
    }));
    theirs[0].push_back(seconds(comm, [&] { dd(comm, "if=" + frame + " of=" + copy); }));
    ours[1].push_back(seconds(comm, [&] {
      checkpoint = writeCheckpoint(folder, comm.handle(), rig.w, {"output", "", false});
    }));
    theirs[1].push_back(seconds(comm, [&] {
      dd(comm, "if=" + checkpoint + " of=" + copy + " conv=fsync");
      dd(comm, "if=" + copy + " of=/dev/null");
    }));
  }
  std::int64_t all = static_cast<std::int64_t>(rig.w.particles.owned);
  rig.all.sum({&all, 1});
  if (comm.rank() == 0) {
    const Result results[]{{"frame", 1e-6 * static_cast<double>(std::filesystem::file_size(frame)),
                            median(ours[0]), median(theirs[0])},
                           {"checkpoint", 1e-6 * static_cast<double>(std::filesystem::file_size(checkpoint)),
                            median(ours[1]), median(theirs[1])}};
    std::printf("%lld particles on %d ranks, medians of %d\n%-12s %10s %10s %10s %10s %14s\n",
                static_cast<long long>(all), comm.size(), repeat, "", "MB", "s", "MB/s", "dd MB/s",
                "dd / ours (1)");
    std::FILE* file = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
    if (file)
      std::fprintf(
          file,
          "case,particles,ranks,megabytes,MB_per_s,dd_MB_per_s,share_of_dd,share_of_dd_target,repeats\n");
    for (const Result& r : results) {
      std::printf("%-12s %10.1f %10.4f %10.0f %10.0f %14.2f\n", r.name, r.megabytes, r.ours,
                  r.megabytes / r.ours, r.megabytes / r.dd, r.dd / r.ours);
      if (file)
        std::fprintf(file, "%s,%lld,%d,%.1f,%.1f,%.1f,%.4f,1,%d\n", r.name, static_cast<long long>(all),
                     comm.size(), r.megabytes, r.megabytes / r.ours, r.megabytes / r.dd, r.dd / r.ours,
                     repeat);
    }
    if (file) std::fclose(file);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    code = run(argc, argv);
  } catch (const std::invalid_argument& e) {  // a bad option, the same on all ranks
    if (Communicator().rank() == 0) std::fprintf(stderr, "output: %s\n", e.what());
    MPI_Finalize();
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "output: %s\n", e.what());
    code = 1;
  }
  if (code != 0) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return code;
}
