// A trailer behind the end of an HDF5 file: a checksum of all its bytes except the rows of its large
// datasets. So nothing that HDF5 interprets (superblock, headers, attributes, texts) reaches it damaged: it
// crashes on some of that. The rows are only copied; where it matters each dataset's checksum is in such an
// attribute (ParallelFileContent::checked). Together they cover every byte. The trailer costs no pass over
// the rows, and needs no rank to read what another one has written, which not every network file system shows
// at once. HDF5 ignores bytes behind its own end; a program that changes the file drops them.
//   trailer: {first, count} of each range of rows; number of ranges, bytes before the trailer, checksum,
//   checksum of the trailer, magic. All are 64-bit words, little-endian.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace thaw {

/// Bytes [first, first + count) of a file.
struct ByteRange {
  std::uint64_t first = 0, count = 0;
};

/// Appends the trailer to a closed file. rows: in any order, apart from each other, within the file. IoError.
void appendTrailer(const std::string& path, std::vector<ByteRange> rows);

/// Does the file have a trailer? IoError if it has one and is not as it was when that was written, rows
/// excepted; if it has other bytes behind HDF5's end; or if it cannot be read. A file that another program
/// has changed has none, and may be damaged.
bool checkTrailer(const std::string& path);

}  // namespace thaw
