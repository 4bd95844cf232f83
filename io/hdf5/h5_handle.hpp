// SPDX-License-Identifier: Apache-2.0
// HDF5 identifier that is released at scope exit, and HDF5's reason of the last failure. Private to io/hdf5.
#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

namespace thaw {

class H5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  H5Handle() = default;
  H5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  H5Handle(H5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;
  ~H5Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Returns ": reason" from the innermost entry of HDF5's error stack, or nothing; clears the stack.
std::string h5Reason();

}  // namespace thaw
