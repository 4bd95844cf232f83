// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/parallel_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "io/hdf5/file_trailer.hpp"

namespace thaw {
namespace {

std::string folderOf(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::uint64_t mix(std::uint64_t x) {  // finalizer of splitmix64 (SLF14)
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ x >> 27) * 0x94d049bb133111ebull;
  return x ^ x >> 31;
}

/// File descriptor that is closed at scope exit.
struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

/// Allocates `bytes` on the disk, so that a full disk is reported here rather than in HDF5's metadata or a
/// rank's write. File systems without fallocate are skipped; there the writes themselves fail.
void reserve(const std::string& path, std::uint64_t bytes) {
  const Descriptor file{::open(path.c_str(), O_WRONLY)};
  if (file.fd < 0) throw IoError(path, std::string("cannot be opened again: ") + std::strerror(errno));
  if (::fallocate(file.fd, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) != 0 &&
      (errno == ENOSPC || errno == EFBIG || errno == EDQUOT))
    throw IoError(path, "cannot write " + std::to_string(bytes) + " bytes: " + std::strerror(errno));
}

/// Releases space reserved beyond the end of the file.
void trim(const std::string& path) {
  const Descriptor file{::open(path.c_str(), O_WRONLY)};
  struct stat about {};
  if (file.fd < 0 || ::fstat(file.fd, &about) != 0 || ::ftruncate(file.fd, about.st_size) != 0)
    throw IoError(path, std::string("cannot be opened again: ") + std::strerror(errno));
}

void syncPath(const std::string& path, int flags) {
  const Descriptor file{::open(path.c_str(), flags)};
  if (file.fd < 0 || (::fsync(file.fd) != 0 && errno != EINVAL && errno != ENOTSUP))
    throw IoError(path, std::string("cannot be written to the disk: ") + std::strerror(errno));
}

void layOut(const std::string& part, const ParallelFileContent& content,
            const std::vector<std::uint64_t>& checksums, std::uint64_t bytes) {
  H5File::create(part).close();
  reserve(part, bytes);
  H5File file = H5File::openToAdd(part);
  for (const std::string& group : content.groups) file.createGroup(group);
  for (std::size_t k = 0; k < content.datasets.size(); k++) {
    const SpreadDataset& d = content.datasets[k];
    file.createDataset(d.name, d.shape);
    if (!d.unit.empty()) file.setText(d.name, "units", d.unit);
    if (!d.meaning.empty()) file.setText(d.name, "meaning", d.meaning);
    if (content.checked) file.setInteger(d.name, "checksum", static_cast<std::int64_t>(checksums[k]));
  }
  if (content.small) content.small(file);
  file.close();
  trim(part);
}

/// Checks on rank 0 that all datasets exist with their sizes, also against the file's length (H5File::shape).
/// Returns the byte ranges of rows.
std::vector<ByteRange> verifyLayout(const std::string& part, const ParallelFileContent& content) {
  const H5File file = H5File::openToRead(part);
  std::vector<ByteRange> rows;
  for (const SpreadDataset& d : content.datasets) {
    const DatasetShape s = file.shape(d.name);
    if (s.element != d.shape.element || s.rows != d.shape.rows || s.components != d.shape.components)
      throw IoError(part, "was not written correctly: " + d.name + " has a wrong size");
    if (s.rows > 0) rows.push_back({file.offset(d.name), s.rows * s.rowBytes()});
  }
  return rows;
}

/// Calls use(range of this rank's rows, bytes) piece by piece. `made` is the buffer of generated pieces,
/// shared by all datasets, since fresh pages cost as much as writing. A piece fits into a cache.
template<class Use> void eachPiece(const SpreadDataset& d, std::vector<std::byte>& made, Use&& use) {
  const std::size_t row = d.shape.rowBytes();
  const std::uint64_t piece = std::max<std::uint64_t>(1, (std::uint64_t(2) << 20) / row);
  for (std::uint64_t done = 0; done < d.mine.count; done += piece) {
    const RowRange local{done, std::min(piece, d.mine.count - done)};
    const std::byte* bytes = static_cast<const std::byte*>(d.data) + done * row;
    if (d.data == nullptr) {
      if (made.size() < local.count * row) made.resize(local.count * row);
      d.fill(local, made.data());
      bytes = made.data();
    }
    use(local, bytes);
  }
}

/// Compares this rank's rows in the file with memory.
void verifyRows(const std::string& part, const ParallelFileContent& content) {
  const H5File file = H5File::openToRead(part);
  std::vector<std::byte> back, made;
  for (const SpreadDataset& d : content.datasets)
    eachPiece(d, made, [&](const RowRange& local, const std::byte* bytes) {
      const std::size_t size = local.count * d.shape.rowBytes();
      if (back.size() < size) back.resize(size);
      file.read(d.name, {d.mine.first + local.first, local.count}, d.shape.element, back.data());
      if (std::memcmp(back.data(), bytes, size) != 0)
        throw IoError(part, "bytes read back differ from those written to " + d.name);
    });
}

}  // namespace

Spread spreadRows(MPI_Comm comm, std::uint64_t count) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  Spread s;
  s.mine.count = count;
  MPI_Exscan(&count, &s.mine.first, 1, MPI_UINT64_T, MPI_SUM, comm);
  if (rank == 0) s.mine.first = 0;
  MPI_Allreduce(&count, &s.all, 1, MPI_UINT64_T, MPI_SUM, comm);
  return s;
}

namespace {

/// fixed: bytes of a row at compile time, or 0. Rows are independent, so several are hashed at once.
template<std::size_t fixed>
std::uint64_t sumRows(const std::byte* at, const RowRange& range, std::size_t rowBytes) {
  const std::size_t bytes = fixed > 0 ? fixed : rowBytes;
  std::uint64_t sum = 0;
  for (std::uint64_t r = 0; r < range.count; r++, at += bytes) {
    std::uint64_t h = mix(range.first + r + 0x9e3779b97f4a7c15ull);
    std::size_t k = 0;
    for (; k + 8 <= bytes; k += 8) {
      std::uint64_t word;
      std::memcpy(&word, at + k, 8);
      h = mix(h ^ word);
    }
    if (k < bytes) {
      std::uint64_t word = 0;
      std::memcpy(&word, at + k, bytes - k);
      h = mix(h ^ word);
    }
    sum += h;
  }
  return sum;
}

}  // namespace

std::uint64_t checksumRows(const void* data, const RowRange& range, std::size_t rowBytes) {
  const auto* at = static_cast<const std::byte*>(data);
  switch (rowBytes) {
    case 1: return sumRows<1>(at, range, 1);
    case 2: return sumRows<2>(at, range, 2);
    case 4: return sumRows<4>(at, range, 4);
    case 8: return sumRows<8>(at, range, 8);
    case 24: return sumRows<24>(at, range, 24);
    default: return sumRows<0>(at, range, rowBytes);
  }
}

void requireFreeSpace(const std::string& path, std::uint64_t bytes) {
  struct statvfs about {};
  const std::string folder = folderOf(path);
  if (::statvfs(folder.c_str(), &about) != 0)
    throw IoError(folder, std::string("cannot be written to: ") + std::strerror(errno));
  const std::uint64_t available = static_cast<std::uint64_t>(about.f_bavail) * about.f_frsize;
  if (about.f_blocks > 0 && available < bytes)
    throw IoError(path, "not enough space on the disk: " + std::to_string(bytes) + " bytes are needed, " +
                            std::to_string(available) + " are free");
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < bytes)
    throw IoError(path, "files may not be longer than " + std::to_string(limit.rlim_cur) +
                            " bytes here (ulimit -f); " + std::to_string(bytes) + " are needed");
}

void renameFile(const std::string& from, const std::string& to, bool sync) {
  if (sync) syncPath(from, O_RDONLY);
  if (std::rename(from.c_str(), to.c_str()) != 0)
    throw IoError(to, std::string("cannot be replaced by ") + from + ": " + std::strerror(errno));
  if (sync) syncPath(folderOf(to), O_RDONLY | O_DIRECTORY);
}

void replaceTextFile(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::FILE* file = std::fopen(part.c_str(), "w");
  if (file == nullptr) throw IoError(part, std::string("cannot be created: ") + std::strerror(errno));
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = errno;
  if (std::fclose(file) != 0 || !written) {
    if (written) error = errno;
    std::remove(part.c_str());
    throw IoError(path, std::string("cannot be written: ") + std::strerror(error));
  }
  renameFile(part, path, false);
}

void writeParallelFile(const std::string& path, MPI_Comm comm, const ParallelFileContent& content) {
  const std::string part = path + ".part";
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  try {
    std::vector<std::uint64_t> checksums(content.datasets.size());
    std::vector<std::byte> made;
    std::uint64_t bytes = (1 << 18) + content.smallBytes;  // bytes besides the distributed datasets
    for (std::size_t k = 0; k < content.datasets.size(); k++) {
      const SpreadDataset& d = content.datasets[k];
      bytes += d.shape.rows * d.shape.rowBytes() + d.meaning.size() + 1024;
      if (content.checked)
        eachPiece(d, made, [&](const RowRange& local, const std::byte* data) {
          checksums[k] += checksumRows(data, {d.mine.first + local.first, local.count}, d.shape.rowBytes());
        });
    }
    if (content.checked)
      MPI_Allreduce(MPI_IN_PLACE, checksums.data(), static_cast<int>(checksums.size()), MPI_UINT64_T, MPI_SUM,
                    comm);
    onFirstRank(comm, [&] {
      requireFreeSpace(path, bytes);
      layOut(part, content, checksums, bytes);
    });
    {
      // opening is collective and fails on all ranks or none; the writes before closing are independent
      std::vector<H5File> file;
      runCollectively(comm, [&] { file.push_back(H5File::openToFill(part, comm)); });
      std::string problem;
      try {
        for (const SpreadDataset& d : content.datasets)
          eachPiece(d, made, [&](const RowRange& local, const std::byte* data) {
            file[0].write(d.name, {d.mine.first + local.first, local.count}, data);
          });
      } catch (const std::exception& e) { problem = e.what(); }
      try {
        if (content.checked) file[0].flush();
      } catch (const std::exception& e) {
        if (problem.empty()) problem = e.what();
      }
      try {
        file[0].close();
      } catch (const std::exception& e) {
        if (problem.empty()) problem = e.what();
      }
      agree(comm, problem);
    }
    if (content.checked) runCollectively(comm, [&] { verifyRows(part, content); });
    onFirstRank(comm, [&] {
      appendTrailer(part, verifyLayout(part, content));
      renameFile(part, path, content.checked);
    });
  } catch (...) {
    if (rank == 0) std::remove(part.c_str());
    throw;
  }
}

}  // namespace thaw
