// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "io/image/image.hpp"

namespace thaw {

void writePng(const Image& image, const std::filesystem::path& path) {
  static_assert(sizeof(Rgb) == 3);
  const auto failed = [&](const std::string& cause) {
    return std::runtime_error(path.string() + ": cannot write: " + cause);
  };
  std::filesystem::path part = path;
  part += ".part";
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  errno = 0;  // libpng reports a full disk as "Write Error"
  if (!png_image_write_to_file(&png, part.c_str(), 0, image.pixels.data(), 0, nullptr))
    throw failed(errno ? std::strerror(errno) : png.message);
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) throw failed(error.message());
}

}  // namespace thaw
