// SPDX-License-Identifier: Apache-2.0
#include "io/export/usd/lz4_block.hpp"

#include <algorithm>
#include <cstring>

namespace thaw {

namespace {

constexpr std::size_t leastMatch = 4, endLiterals = 5, lastStart = 12, farthest = 65535;
constexpr int hashBits = 14;
/// Largest input of one block.
constexpr std::size_t mostInput = 0x7E000000;

std::uint32_t wordAt(const char* p) {
  std::uint32_t v;
  std::memcpy(&v, p, 4);
  return v;
}

void addLength(std::size_t rest, std::vector<char>& out) {
  for (; rest >= 255; rest -= 255) out.push_back(static_cast<char>(255));
  out.push_back(static_cast<char>(rest));
}

/// Appends literals and, unless `match` is 0, a match of that length `offset` bytes back.
void addSequence(std::span<const char> literals, std::size_t match, std::size_t offset,
                 std::vector<char>& out) {
  const std::size_t rest = match == 0 ? 0 : match - leastMatch;
  out.push_back(
      static_cast<char>(std::min<std::size_t>(15, literals.size()) << 4 | std::min<std::size_t>(15, rest)));
  if (literals.size() >= 15) addLength(literals.size() - 15, out);
  out.insert(out.end(), literals.begin(), literals.end());
  if (match == 0) return;
  out.push_back(static_cast<char>(offset & 255));
  out.push_back(static_cast<char>(offset >> 8));
  if (rest >= 15) addLength(rest - 15, out);
}

template<class T> void addLittleEndian(std::vector<char>& out, T value) {
  const char* bytes = reinterpret_cast<const char*>(&value);
  out.insert(out.end(), bytes, bytes + sizeof(T));
}

std::int32_t differenceAt(std::span<const std::int32_t> values, std::size_t i) {
  const auto before = i == 0 ? 0u : static_cast<std::uint32_t>(values[i - 1]);
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(values[i]) - before);
}

/// Returns the most common difference of a sample, the largest one in a tie. Any value gives a valid code.
std::int32_t commonDifference(std::span<const std::int32_t> values) {
  constexpr std::size_t samples = 4096;
  std::vector<std::int32_t> all;
  const std::size_t step = std::max<std::size_t>(1, values.size() / samples);
  for (std::size_t i = 0; i < values.size(); i += step) all.push_back(differenceAt(values, i));
  std::sort(all.begin(), all.end());
  std::int32_t best = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    while (end < all.size() && all[end] == all[i]) end++;
    if (end - i >= most) most = end - i, best = all[i];
    i = end;
  }
  return best;
}

}  // namespace

void addLz4Block(std::span<const char> data, std::vector<char>& out) {
  std::vector<std::uint32_t> last(std::size_t{1} << hashBits, 0);  // position + 1 of a hash's last word
  std::size_t at = 0, done = 0, misses = 0;
  const std::size_t n = data.size();
  while (at + lastStart < n) {
    const std::uint32_t word = wordAt(data.data() + at);
    std::uint32_t& slot = last[word * 2654435761u >> (32 - hashBits)];
    const std::size_t candidate = slot;
    slot = static_cast<std::uint32_t>(at + 1);
    if (candidate == 0 || at + 1 - candidate > farthest || wordAt(data.data() + candidate - 1) != word) {
      at += 1 + (misses++ >> 6);  // the stride grows in data without matches
      continue;
    }
    misses = 0;
    std::size_t length = leastMatch;
    while (at + length < n - endLiterals && data[at + length] == data[candidate - 1 + length]) length++;
    addSequence(data.subspan(done, at - done), length, at + 1 - candidate, out);
    done = at += length;
  }
  addSequence(data.subspan(done), 0, 0, out);
}

std::vector<char> crateCompressed(std::span<const char> data) {
  std::vector<char> out;
  if (data.size() <= mostInput) {
    out.push_back(0);
    addLz4Block(data, out);
    return out;
  }
  out.push_back(static_cast<char>((data.size() + mostInput - 1) / mostInput));
  for (std::size_t at = 0; at < data.size(); at += mostInput) {
    std::vector<char> block;
    addLz4Block(data.subspan(at, std::min(mostInput, data.size() - at)), block);
    addLittleEndian(out, static_cast<std::int32_t>(block.size()));
    out.insert(out.end(), block.begin(), block.end());
  }
  return out;
}

std::vector<char> crateIntegers(std::span<const std::int32_t> values) {
  const std::int32_t common = commonDifference(values);
  std::vector<char> codes((values.size() + 3) / 4, 0), rest;
  rest.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); i++) {
    const std::int32_t d = differenceAt(values, i);
    unsigned code = 0;
    if (d == common) continue;
    if (d == static_cast<std::int8_t>(d)) code = 1, addLittleEndian(rest, static_cast<std::int8_t>(d));
    else if (d == static_cast<std::int16_t>(d)) code = 2, addLittleEndian(rest, static_cast<std::int16_t>(d));
    else code = 3, addLittleEndian(rest, d);
    codes[i / 4] = static_cast<char>(static_cast<unsigned char>(codes[i / 4]) | code << 2 * (i % 4));
  }
  std::vector<char> plain;
  plain.reserve(4 + codes.size() + rest.size());
  addLittleEndian(plain, common);
  plain.insert(plain.end(), codes.begin(), codes.end());
  plain.insert(plain.end(), rest.begin(), rest.end());
  return crateCompressed(plain);
}

}  // namespace thaw
