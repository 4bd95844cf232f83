// SPDX-License-Identifier: Apache-2.0
#include "io/view/server/token.hpp"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "io/hdf5/io_error.hpp"

namespace thaw {

std::string newToken() {
  std::array<unsigned char, 16> random{};
  if (getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    throw IoError(std::string("cannot create the access token: getrandom failed: ") + std::strerror(errno));
  std::string token;
  for (const unsigned char byte : random)
    for (const int digit : {byte >> 4, byte & 15}) token += "0123456789abcdef"[digit];
  return token;
}

bool sameToken(std::string_view given, std::string_view expected) {
  // volatile: the compiler must not leave the loop at the first difference
  volatile unsigned difference = given.size() == expected.size() && !expected.empty() ? 0 : 1;
  for (std::size_t k = 0; k < given.size(); k++) {
    const char other = expected.empty() ? '\0' : expected[k % expected.size()];
    difference = difference | static_cast<unsigned>(static_cast<unsigned char>(given[k] ^ other));
  }
  return difference == 0;
}

}  // namespace thaw
