// SPDX-License-Identifier: Apache-2.0
// The trailer of files: damage that it detects, and files without one.
#include "io/hdf5/file_trailer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/hdf5/h5_file.hpp"

namespace thaw {
namespace {

namespace fs = std::filesystem;

struct FileTrailerOf : testing::Test {
  std::string path =
      (fs::temp_directory_path() / ("thaw_trailer_" + std::to_string(::getpid()) + ".hdf")).string();
  ~FileTrailerOf() override { fs::remove(path); }

  std::string bytes() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& content) const { std::ofstream(path, std::ios::binary) << content; }
  bool refused() const {
    try {
      checkTrailer(path);
    } catch (const IoError&) { return true; }
    return false;
  }
};

TEST_F(FileTrailerOf, DetectsChangesOfEveryByteExceptRows) {
  const std::string body = "superblock" + std::string(100, 'r') + "header";
  put(body);
  appendTrailer(path, {{10, 100}});
  EXPECT_TRUE(checkTrailer(path));
  const std::string whole = bytes();
  for (std::size_t k = 0; k < whole.size(); k++) {
    std::string s = whole;
    s[k] = static_cast<char>(s[k] ^ 4);
    put(s);
    // no trailer without the magic
    const bool rows = k >= 10 && k < 110, magic = k + 8 >= whole.size();
    if (magic) EXPECT_FALSE(checkTrailer(path)) << k;
    else EXPECT_EQ(refused(), !rows) << k;
  }
  put(whole + "x");
  EXPECT_FALSE(checkTrailer(path));
}

TEST_F(FileTrailerOf, IsIgnoredByHdf5AndOtherBytesAreRefused) {
  {
    H5File file = H5File::create(path);
    file.writeText("/text", "wax");
    file.close();
  }
  EXPECT_FALSE(checkTrailer(path));
  EXPECT_THROW(H5File::openToRead(path, Trailer::MustBe), IoError);
  EXPECT_EQ(H5File::openToRead(path).readText("/text"), "wax");
  appendTrailer(path, {});
  EXPECT_EQ(H5File::openToRead(path, Trailer::MustBe).readText("/text"), "wax");
  std::string s = bytes();
  s.back() = 'x';
  put(s);
  EXPECT_TRUE(refused());
}

}  // namespace
}  // namespace thaw
