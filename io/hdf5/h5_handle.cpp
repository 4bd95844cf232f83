// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/h5_handle.hpp"

namespace thaw {

std::string h5Reason() {
  std::string reason;
  const H5E_walk2_t innermost = [](unsigned, const H5E_error2_t* e, void* to) -> herr_t {
    if (e->desc != nullptr) *static_cast<std::string*>(to) = e->desc;
    return 1;  // the first entry of an upward walk is the innermost
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  if (reason.empty()) return {};
  // from "file write failed: time = ..., errno = 28, error message = 'No space left on device', ..." only the
  // system's message is kept
  const std::string key = "error message = '";
  if (const std::size_t at = reason.find(key); at != std::string::npos) {
    const std::size_t from = at + key.size(), end = reason.find('\'', from);
    if (end != std::string::npos) return ": " + reason.substr(from, end - from);
  }
  return ": " + reason;
}

}  // namespace thaw
