// SPDX-License-Identifier: Apache-2.0
// Scanned and modelled meshes that are not part of the project, in the folder THAW_SAMPLE_MESHES. The tests
// are skipped without it.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/geometry/shapes/mesh_distance.hpp"
#include "io/meshes/read_mesh.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/samples.hpp"

namespace thaw {
namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void tryMesh(const char* name) {
  const char* folder = std::getenv("THAW_SAMPLE_MESHES");
  if (!folder) GTEST_SKIP() << "THAW_SAMPLE_MESHES does not name a folder of sample meshes";
  const auto path = std::filesystem::path(folder) / name;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "THAW_SAMPLE_MESHES: there is no " << path;
  const double t0 = seconds();
  const TriangleMesh m = readMesh(path.string());
  const double t1 = seconds();
  const MeshDistance d(m, name);
  const double t2 = seconds();
  const MeshReport& r = d.report();
  const double spacing = std::cbrt(r.volume / 50000);
  const SampleLattice lattice = sampleLattice(d, spacing);
  const Samples samples = sampleShape(d, lattice, {0, lattice.rows()});
  const double t3 = seconds();
  std::printf("%s: %lld triangles, read %.3f s, prepared in %.3f s, %zu samples in %.3f s\n", name,
              static_cast<long long>(r.triangles), t1 - t0, t2 - t1, samples.number.size(), t3 - t2);
  std::vector<std::string> notes;
  d.addNotes(notes);
  for (const std::string& n : notes) std::printf("  %s\n", n.c_str());
  EXPECT_NEAR(static_cast<double>(samples.number.size()), 50000, 500);
  // compares with the sum over all triangles, which decides inside and outside
  MeshReport report;
  const TriangleMesh solid = repairMesh(m, report);
  double worst = 0;
  int differences = 0;
  for (std::uint64_t k = 0; k < 300; k++) {
    const Vec3d x = randomPoint(d.bounds(), k);
    const double w = bruteWinding(solid, x);
    worst = std::max(worst, std::abs(w - d.surface().winding(x)));
    differences += d.inside(x) != (w > 0.5);
    EXPECT_NEAR(std::abs(d.distance(x)), bruteDistance(solid, x), 1e-12);
  }
  EXPECT_EQ(differences, 0);
  EXPECT_LT(worst, 0.1);
  std::printf("  winding number: largest error %.4f\n", worst);
  // near-surface queries, as for obstacles
  const double t4 = seconds();
  double sum = 0;
  const int n = 100000;
  const Bounds b = d.bounds();
  for (std::uint64_t k = 0; k < n; k++) sum += d.distanceWithin(randomPoint(b, k), 2 * spacing);
  std::printf("  distance within 2 spacings: %.0f ns a point of the bounding box (%g)\n",
              (seconds() - t4) * 1e9 / n, sum);
}

TEST(SampleMeshes, Nefertiti) { tryMesh("nefertiti.obj"); }
TEST(SampleMeshes, Spot) { tryMesh("spot.obj"); }

}  // namespace
}  // namespace thaw
