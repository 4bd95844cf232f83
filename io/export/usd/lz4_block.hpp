// SPDX-License-Identifier: Apache-2.0
// Compression of the sections and integer arrays of USD crate files.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace thaw {

/// Appends an LZ4 block (the block format of LZ4, without a frame).
void addLz4Block(std::span<const char> data, std::vector<char>& out);

/// Returns data as crate files compress it: a byte 0 and one block, or the number of chunks and each chunk
/// after its length.
std::vector<char> crateCompressed(std::span<const char> data);

/// Returns integers as crate files compress them, by differences of neighbours. Each has a code of two bits.
/// It also has one, two or four bytes if it differs from the most common one.
std::vector<char> crateIntegers(std::span<const std::int32_t> values);

}  // namespace thaw
