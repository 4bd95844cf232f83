// SPDX-License-Identifier: Apache-2.0
// Checksums of the rows of a checkpoint, which its trailer does not cover (io/hdf5/file_trailer.hpp).
#pragma once
#include <string>
#include <vector>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// Returns the paths of datasets whose rows do not match their checksum. Reads all rows. Frames have no
/// checksums.
std::vector<std::string> damagedRows(const H5File& file);

/// Returns "is damaged: the checksum of /particles/velocity is wrong".
std::string damageText(const std::vector<std::string>& datasets);

}  // namespace thaw
