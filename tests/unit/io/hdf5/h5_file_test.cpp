// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "io/hdf5/h5_file.hpp"
#include "io/hdf5/parallel_file.hpp"

using namespace thaw;
namespace fs = std::filesystem;

namespace {

struct Folder {
  std::string path;
  Folder() {
    char name[] = "/tmp/thaw_h5_XXXXXX";
    path = mkdtemp(name);
  }
  ~Folder() { fs::remove_all(path); }
};

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const IoError& e) { return e.what(); }
  return {};
}

}  // namespace

TEST(H5File, RoundTripsData) {
  const Folder folder;
  const std::string path = folder.path + "/f.hdf", text = "W\u00e4rme\nline 2";
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  {
    H5File file = H5File::create(path);
    file.createGroup("/g");
    file.createGroup("/g/h");
    file.createDataset("/g/h/v", {Element::F64, 2, 3});
    file.write("/g/h/v", {1, 1}, values.data() + 3);
    file.write("/g/h/v", {0, 1}, values.data());
    file.writeText("/g/text", text);
    file.writeText("/g/none", "");
    file.setText("/g", "unit", "m/s");
    file.setInteger("/g", "n", -7);
    file.setIntegers("/g", "several", {1, 0});
    file.setNumber("/g", "x", 0.1);
    file.close();
  }
  const H5File file = H5File::openToRead(path);
  std::vector<double> back(6);
  file.read("/g/h/v", {0, 2}, Element::F64, back.data());
  EXPECT_EQ(back, values);
  float second[3];
  file.read("/g/h/v", {1, 1}, Element::F32, second);  // converted
  EXPECT_EQ(second[2], 6.0f);
  EXPECT_EQ(file.readText("/g/text"), text);
  EXPECT_EQ(file.readText("/g/none"), "");
  EXPECT_EQ(file.text("/g", "unit"), "m/s");
  EXPECT_EQ(file.integer("/g", "n"), -7);
  EXPECT_EQ(file.integers("/g", "several"), (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(file.number("/g", "x"), 0.1);
  EXPECT_TRUE(file.has("/g/h/v"));
  EXPECT_FALSE(file.has("/nothing/v"));
  EXPECT_EQ(file.children("/g"), (std::vector<std::string>{"h", "none", "text"}));
  EXPECT_EQ(file.attributes("/g"), (std::vector<std::string>{"n", "several", "unit", "x"}));
}

TEST(H5File, ErrorsNameFileAndReason) {
  const Folder folder;
  EXPECT_NE(errorOf([&] { H5File::create(folder.path + "/no/f.hdf"); }).find("No such file or directory"),
            std::string::npos);
  EXPECT_EQ(errorOf([&] { H5File::openToRead(folder.path + "/f.hdf"); }),
            folder.path + "/f.hdf: no such file");
  EXPECT_NE(errorOf([&] { H5File::openToRead(folder.path); }).find("is a folder"), std::string::npos);
  std::ofstream(folder.path + "/text.hdf") << "this is text";
  EXPECT_NE(errorOf([&] {
              H5File::openToRead(folder.path + "/text.hdf");
            }).find("cannot be opened as an HDF5 file"),
            std::string::npos);
  H5File file = H5File::create(folder.path + "/f.hdf");
  file.createDataset("/v", {Element::U16, 4, 0});
  std::uint16_t v[8] = {};
  EXPECT_NE(errorOf([&] { file.read("/v", {2, 3}, Element::U16, v); }), "");
  EXPECT_NE(errorOf([&] { file.shape("/w"); }).find("/w"), std::string::npos);
  EXPECT_NE(errorOf([&] { file.integer("/", "n"); }).find("attribute n"), std::string::npos);
}

TEST(H5File, FullDiskIsAnErrorAtTheEndAndTheProcessContinues) {
  const Folder folder;
  std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit old {
  }, tight{};
  getrlimit(RLIMIT_FSIZE, &old);
  tight = old;
  tight.rlim_cur = 4096;
  const std::string error = errorOf([&] {
    H5File file = H5File::create(folder.path + "/f.hdf");
    file.createDataset("/v", {Element::F64, 10000, 0});
    setrlimit(RLIMIT_FSIZE, &tight);
    file.close();
  });
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_NE(error.find("File too large"), std::string::npos) << error;
}

TEST(Checksum, IsAdditiveOverPartsAndDependsOnPositionAndEveryBit) {
  std::vector<std::uint64_t> v(100);
  for (std::size_t k = 0; k < v.size(); k++) v[k] = k * k;
  const std::uint64_t whole = checksumRows(v.data(), {0, 100}, 8);
  EXPECT_EQ(whole, checksumRows(v.data(), {0, 33}, 8) + checksumRows(v.data() + 33, {33, 67}, 8));
  std::swap(v[3], v[4]);
  EXPECT_NE(whole, checksumRows(v.data(), {0, 100}, 8));
  std::swap(v[3], v[4]);
  v[99] ^= 1ull << 63;
  EXPECT_NE(whole, checksumRows(v.data(), {0, 100}, 8));
  const std::uint8_t bytes[3] = {1, 2, 3}, other[3] = {1, 3, 2};
  EXPECT_NE(checksumRows(bytes, {0, 3}, 1), checksumRows(other, {0, 3}, 1));
}

TEST(TextFile, IsReplacedAtomically) {
  const Folder folder;
  const std::string path = folder.path + "/s.json";
  replaceTextFile(path, "one");
  replaceTextFile(path, "two");
  std::ifstream in(path);
  std::string text;
  in >> text;
  EXPECT_EQ(text, "two");
  EXPECT_FALSE(fs::exists(path + ".part"));
  EXPECT_NE(errorOf([&] { replaceTextFile(folder.path + "/no/s.json", "x"); }), "");
}
