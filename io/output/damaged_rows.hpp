// Checksums of the rows of a checkpoint, which its trailer leaves out (io/hdf5/file_trailer.hpp).
#pragma once
#include <string>
#include <vector>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

/// Paths of the datasets whose rows do not fit their checksum. Frames have no checksums of rows. Reads all
/// rows.
std::vector<std::string> damagedRows(const H5File& file);

/// "is damaged: the checksum of /particles/velocity is wrong"
std::string damageText(const std::vector<std::string>& datasets);

}  // namespace thaw
