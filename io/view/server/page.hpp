// SPDX-License-Identifier: Apache-2.0
// The page of `thaw view`, bundled at build time (cmake/view.cmake) into the program.
#pragma once
#include <span>
#include <string_view>

namespace thaw {

struct PageFile {
  std::string_view name;  ///< "index.html"
  std::string_view type;  ///< media type, "text/html; charset=utf-8"
  std::string_view bytes;
};

/// Returns the files of the page; none in a program that is built without it.
std::span<const PageFile> pageFiles();

}  // namespace thaw
