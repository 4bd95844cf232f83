// SPDX-License-Identifier: Apache-2.0
// Trailer behind the end of an HDF5 file: a checksum of all bytes except the rows of large datasets. It
// protects everything that HDF5 parses (superblock, headers, attributes, texts), since damage there can crash
// the library. Rows are only copied; their checksums, where kept, are attributes
// (ParallelFileContent::checked). Together they cover every byte. The trailer needs no pass over the rows,
// and no rank reads what another one has written, which some network file systems delay. HDF5 ignores bytes
// behind its own end; programs that change the file drop them.
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
