// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "io/export/write_vdb.hpp"

namespace thaw {

void writeVdb(const std::filesystem::path&, const ExportScene&) {
  throw std::invalid_argument(
      "this program is built without OpenVDB; install it (Debian: libopenvdb-dev), configure and build "
      "again");
}

}  // namespace thaw
