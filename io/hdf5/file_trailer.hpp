// SPDX-License-Identifier: Apache-2.0
// Trailer after the end of an HDF5 file: a checksum of all bytes except the rows of large datasets. It
// protects everything that HDF5 parses (superblock, headers, attributes, texts), since damage there can crash
// the library. Rows are only copied; their checksums, where kept, are attributes
// (ParallelFileContent::checked). Trailer and row checksums together cover every byte. Writing the trailer
// needs no pass over the rows. No rank thus reads rows of another rank, which some network file systems
// deliver late. HDF5 ignores bytes after its own end. Programs that change the file drop them.
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

/// Appends the trailer to a closed file. rows: disjoint ranges within the file, in any order. Throws IoError.
void appendTrailer(const std::string& path, std::vector<ByteRange> rows);

/// Returns whether the file has a trailer. Throws IoError if the file differs from its trailer (rows
/// excepted), has other bytes behind HDF5's end, or cannot be read. A file changed by another program has no
/// trailer, and may be damaged.
bool checkTrailer(const std::string& path);

}  // namespace thaw
