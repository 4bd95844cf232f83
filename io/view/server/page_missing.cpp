// SPDX-License-Identifier: Apache-2.0
// Stands for the page in a program that is built without node.
#include "io/view/server/page.hpp"

namespace thaw {

std::span<const PageFile> pageFiles() { return {}; }

}  // namespace thaw
