// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/file_trailer.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

#include "io/hdf5/parallel_file.hpp"

namespace thaw {
namespace {

static_assert(std::endian::native == std::endian::little,
              "words of the trailer are little-endian, as in memory");

constexpr std::uint64_t magic = 0x316b6377616874ull;  // "thawck1"
constexpr std::uint64_t fixedWords = 5, wordBytes = 8;

struct File {
  const std::string& path;
  int fd;
  File(const std::string& p, int flags) : path(p), fd(::open(p.c_str(), flags)) {
    if (fd < 0) fail("cannot be opened");
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (fd >= 0) ::close(fd);
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw IoError(path, what + ": " + std::strerror(errno));
  }
  [[noreturn]] void damaged(const std::string& what) const { throw IoError(path, "is damaged: " + what); }

  std::uint64_t bytes() const {
    struct stat about {};
    if (::fstat(fd, &about) != 0) fail("its size cannot be read");
    return static_cast<std::uint64_t>(about.st_size);
  }
  void read(std::uint64_t at, std::uint64_t count, void* to) const {
    auto* next = static_cast<char*>(to);
    while (count > 0) {
      const ssize_t got = ::pread(fd, next, count, static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail("cannot be read");
      if (got == 0) damaged("it is shorter than expected");
      next += got, at += static_cast<std::uint64_t>(got), count -= static_cast<std::uint64_t>(got);
    }
  }
  void write(std::uint64_t at, std::uint64_t count, const void* from) const {
    const auto* next = static_cast<const char*>(from);
    while (count > 0) {
      const ssize_t put = ::pwrite(fd, next, count, static_cast<off_t>(at));
      if (put < 0 && errno == EINTR) continue;
      if (put <= 0) fail("cannot be written");
      next += put, at += static_cast<std::uint64_t>(put), count -= static_cast<std::uint64_t>(put);
    }
  }
};

/// Checksum of the bytes [0, end) outside of the ascending ranges, as a sum over pieces with their positions.
std::uint64_t checksumBetween(const File& file, const std::vector<ByteRange>& rows, std::uint64_t end) {
  constexpr std::uint64_t piece = 1 << 20;
  std::vector<std::byte> bytes;
  std::uint64_t sum = 0, at = 0;
  for (std::size_t k = 0; k <= rows.size(); k++) {
    const std::uint64_t to = k < rows.size() ? rows[k].first : end;
    for (std::uint64_t n = 0; at < to; at += n) {
      n = std::min(piece, to - at);
      bytes.resize(n);
      file.read(at, n, bytes.data());
      sum += checksumRows(bytes.data(), {at, 1}, n);
    }
    if (k < rows.size()) at = rows[k].first + rows[k].count;
  }
  return sum;
}

/// Returns the end in HDF5's superblock (versions 0 to 3 without a user block), or 0 without such a
/// superblock.
std::uint64_t endOfHdf5(const File& file, std::uint64_t size) {
  constexpr unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
  constexpr std::size_t places[] = {40, 44, 28, 28};  // byte of the address, by version
  unsigned char head[64];
  if (size < sizeof head) return 0;
  file.read(0, sizeof head, head);
  const unsigned version = head[8];
  if (std::memcmp(head, signature, sizeof signature) != 0 || version > 3 || head[version < 2 ? 13 : 9] != 8)
    return 0;
  std::uint64_t end = 0;
  std::memcpy(&end, head + places[version], sizeof end);
  return end;
}

std::uint64_t checksumWords(const std::vector<std::uint64_t>& words) {
  return checksumRows(words.data(), {0, words.size() - 2}, wordBytes);  // excludes itself and the magic
}

}  // namespace

void appendTrailer(const std::string& path, std::vector<ByteRange> rows) {
  std::erase_if(rows, [](const ByteRange& r) { return r.count == 0; });
  std::sort(rows.begin(), rows.end(),
            [](const ByteRange& a, const ByteRange& b) { return a.first < b.first; });
  const File file(path, O_RDWR);
  const std::uint64_t end = file.bytes();
  std::vector<std::uint64_t> words;
  for (const ByteRange& r : rows) words.insert(words.end(), {r.first, r.count});
  words.insert(words.end(), {rows.size(), end, checksumBetween(file, rows, end), 0, magic});
  words[words.size() - 2] = checksumWords(words);
  file.write(end, words.size() * wordBytes, words.data());
}

bool checkTrailer(const std::string& path) {
  const File file(path, O_RDONLY);
  const std::uint64_t size = file.bytes();
  std::vector<std::uint64_t> words(fixedWords);
  if (size >= fixedWords * wordBytes)
    file.read(size - fixedWords * wordBytes, fixedWords * wordBytes, words.data());
  if (words.back() != magic) {
    if (const std::uint64_t end = endOfHdf5(file, size); end > 0 && end < size)
      file.damaged("unknown bytes follow the HDF5 data");
    return false;
  }
  const std::uint64_t ranges = words[0], end = words[1], checksum = words[2];
  const std::uint64_t before = size - fixedWords * wordBytes;  // size without the fixed words
  if (ranges > before / (2 * wordBytes) || end != before - ranges * 2 * wordBytes)
    file.damaged("its trailer does not match its length");
  words.insert(words.begin(), 2 * ranges, 0);
  file.read(end, 2 * ranges * wordBytes, words.data());
  if (checksumWords(words) != words[words.size() - 2]) file.damaged("the checksum of its trailer is wrong");
  std::vector<ByteRange> rows(ranges);
  std::uint64_t at = 0;
  for (std::size_t k = 0; k < ranges; k++) {
    rows[k] = {words[2 * k], words[2 * k + 1]};
    if (rows[k].first < at || rows[k].first > end || rows[k].count > end - rows[k].first)
      file.damaged("row ranges of its trailer lie outside the file");
    at = rows[k].first + rows[k].count;
  }
  if (checksumBetween(file, rows, end) != checksum)
    file.damaged("the checksum of the bytes outside of its rows is wrong");
  return true;
}

}  // namespace thaw
