// SPDX-License-Identifier: Apache-2.0
// Files with more than 2^32 rows and more than 2^31 bytes. All ranks write and read the far end of a dataset.
// The file is sparse and takes no disk space.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "io/hdf5/parallel_file.hpp"

using namespace thaw;

namespace {

/// A folder made by rank 0 whose name all ranks have. It is removed at the end.
struct SharedFolder {
  int rank = 0, ranks = 1;
  char name[32] = "/tmp/thaw_large_XXXXXX";
  SharedFolder() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (rank == 0 && mkdtemp(name) == nullptr) name[0] = 0;
    MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD);
  }
  ~SharedFolder() {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0) std::filesystem::remove_all(name);
  }
};

}  // namespace

TEST(LargeFile, HoldsRowsBeyond32Bits) {
  const SharedFolder folder;
  ASSERT_NE(folder.name[0], 0);
  const std::string path = std::string(folder.name) + "/large.hdf";
  const std::uint64_t rows = (std::uint64_t(1) << 32) + 1000, far = rows - 100;
  onFirstRank(MPI_COMM_WORLD, [&] {
    H5File file = H5File::create(path);
    file.createDataset("/x", {Element::F64, rows, 3});
    file.createDataset("/id", {Element::U64, rows, 0});
    file.close();
  });
  const RowRange mine{far + static_cast<std::uint64_t>(folder.rank) * 3, 3};
  std::vector<double> x(9);
  std::vector<std::uint64_t> id(3);
  for (std::size_t k = 0; k < 9; k++) x[k] = folder.rank + 0.1 * static_cast<double>(k);
  for (std::size_t k = 0; k < 3; k++) id[k] = mine.first + k;
  {
    H5File file = H5File::openToFill(path, MPI_COMM_WORLD);
    file.write("/x", mine, x.data());
    file.write("/id", mine, id.data());
    file.close();
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const H5File file = H5File::openToRead(path);
  EXPECT_EQ(file.shape("/x").rows, rows);
  for (int r = 0; r < folder.ranks; r++) {
    std::vector<double> there(9);
    std::vector<std::uint64_t> ids(3);
    const RowRange range{far + static_cast<std::uint64_t>(r) * 3, 3};
    file.read("/x", range, Element::F64, there.data());
    file.read("/id", range, Element::U64, ids.data());
    for (std::size_t k = 0; k < 9; k++) EXPECT_EQ(there[k], r + 0.1 * static_cast<double>(k));
    for (std::size_t k = 0; k < 3; k++) EXPECT_EQ(ids[k], range.first + k);
  }
  struct stat about {};
  ASSERT_EQ(stat(path.c_str(), &about), 0);
  EXPECT_GT(about.st_size, std::int64_t(rows) * 32);
  EXPECT_LT(about.st_blocks * 512, 1 << 24);  // sparse
}

TEST(LargeFile, RowsOfRanksAreCountedIn64Bits) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::uint64_t each = 3000000000u;
  const Spread s = spreadRows(MPI_COMM_WORLD, each);
  EXPECT_EQ(s.mine.first, each * static_cast<std::uint64_t>(rank));
  EXPECT_EQ(s.all, each * static_cast<std::uint64_t>(ranks));
}
