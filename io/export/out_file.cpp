// SPDX-License-Identifier: Apache-2.0
#include "io/export/out_file.hpp"

#include <cerrno>
#include <cstring>

#include "io/hdf5/io_error.hpp"

namespace thaw {

OutFile::OutFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  errno = 0;
  file_.reset(std::fopen(part_.c_str(), "wb"));
  if (!file_) fail();
  std::setvbuf(file_.get(), nullptr, _IOFBF, 1 << 20);
}

OutFile::~OutFile() {
  if (!file_) return;
  file_.reset();
  std::error_code error;
  std::filesystem::remove(part_, error);
}

void OutFile::fail() const {
  throw IoError(path_.string(),
                std::string("cannot be written: ") + (errno ? std::strerror(errno) : "the disk may be full"));
}

void OutFile::bytes(const void* data, std::size_t count) {
  if (count > 0 && std::fwrite(data, 1, count, file_.get()) != count) fail();
  size_ += count;
}

void OutFile::overwrite(std::uint64_t at, const void* data, std::size_t count) {
  if (fseeko(file_.get(), static_cast<off_t>(at), SEEK_SET) != 0 ||
      std::fwrite(data, 1, count, file_.get()) != count || fseeko(file_.get(), 0, SEEK_END) != 0)
    fail();
}

void OutFile::finish() {
  if (std::fflush(file_.get()) != 0) fail();
  const bool closed = std::fclose(file_.release()) == 0;  // a full disk may appear only here
  std::error_code error;
  if (closed) std::filesystem::rename(part_, path_, error);
  if (closed && !error) return;
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
  if (!closed) fail();
  throw IoError(path_.string(), "cannot be written: " + error.message());
}

}  // namespace thaw
