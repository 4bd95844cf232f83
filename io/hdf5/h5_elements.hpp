// SPDX-License-Identifier: Apache-2.0
// Element types in HDF5. Private to io/hdf5.
#pragma once
#include <hdf5.h>

#include "io/hdf5/h5_file.hpp"

namespace thaw {

hid_t typeOf(Element element);  ///< in memory; -1 for Other
Element elementOfType(hid_t type);

}  // namespace thaw
