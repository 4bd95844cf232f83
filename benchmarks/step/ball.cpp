// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/step/ball.hpp"

#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace thaw::bench {
namespace {

constexpr int rings = 224, segments = 224;  // 2 * segments * (rings - 1) triangles

void write(const std::string& path) {
  static_assert(std::endian::native == std::endian::little);
  const int corners = 2 + (rings - 1) * segments, triangles = 2 * segments * (rings - 1);
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << corners
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << triangles
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto vertex = [&](double polar, double azimuth) {
    const std::array<float, 3> x{static_cast<float>(std::sin(polar) * std::cos(azimuth)),
                                 static_cast<float>(std::sin(polar) * std::sin(azimuth)),
                                 static_cast<float>(std::cos(polar))};
    file.write(reinterpret_cast<const char*>(x.data()), sizeof x);
  };
  vertex(0, 0);
  for (int r = 1; r < rings; r++)
    for (int s = 0; s < segments; s++)
      vertex(std::numbers::pi * r / rings, 2 * std::numbers::pi * s / segments);
  vertex(std::numbers::pi, 0);
  const auto face = [&](int a, int b, int c) {
    const std::array<std::int32_t, 3> corner{a, b, c};
    file.put(3);
    file.write(reinterpret_cast<const char*>(corner.data()), sizeof corner);
  };
  const auto at = [](int ring, int segment) { return 1 + (ring - 1) * segments + segment % segments; };
  for (int s = 0; s < segments; s++) {
    face(0, at(1, s), at(1, s + 1));
    for (int r = 1; r < rings - 1; r++) {
      face(at(r, s), at(r + 1, s), at(r + 1, s + 1));
      face(at(r, s), at(r + 1, s + 1), at(r, s + 1));
    }
    face(corners - 1, at(rings - 1, s + 1), at(rings - 1, s));
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot write the ball of the case 'mesh'");
}

}  // namespace

BallFile::BallFile(const Communicator& comm) : comm_(comm) {
  int process = static_cast<int>(getpid());
  MPI_Bcast(&process, 1, MPI_INT, 0, comm.handle());
  path_ = (std::filesystem::temp_directory_path() / ("thaw_step_ball_" + std::to_string(process) + ".ply"))
              .string();
  if (comm.rank() == 0) write(path_);
  MPI_Barrier(comm.handle());
}

BallFile::~BallFile() {
  MPI_Barrier(comm_.handle());
  std::error_code ignored;
  if (comm_.rank() == 0) std::filesystem::remove(path_, ignored);
}

}  // namespace thaw::bench
