// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/render/image/image.hpp"

namespace thaw {

namespace {

struct CloseFile {
  void operator()(std::FILE* f) const { std::fclose(f); }
};

/// libpng reports errors here and expects no return. Exceptions must not pass through C code, so it uses
/// longjmp (png.h).
void keepMessage(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}
void ignoreWarning(png_structp, png_const_charp) {}

/// Returns false with a message on failure. Local objects must not have destructors, which longjmp would
/// skip.
bool encode(const Image& image, std::FILE* file, std::string& message) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keepMessage, ignoreWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    message = "out of memory";
    return false;
  }
  if (setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  // Compression takes a third of the time of the default 6; files are slightly larger.
  png_set_compression_level(png, 4);
  png_set_IHDR(png, info, image.width, image.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  for (int y = 0; y < image.height; y++)
    png_write_row(png, reinterpret_cast<png_const_bytep>(&image.at(0, y)));
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

void writePng(const Image& image, const std::filesystem::path& path) {
  static_assert(sizeof(Rgb) == 3);
  if (image.width < 1 || image.height < 1)
    throw std::runtime_error(path.string() + ": expected at least one pixel to write");
  std::filesystem::path part = path;
  part += ".part";
  const auto failed = [&](const std::string& cause) {
    return std::runtime_error(path.string() + ": cannot write: " + cause);
  };
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(part.c_str(), "wb"));
  if (!file) throw failed(std::strerror(errno));
  std::string message;
  errno = 0;
  bool good = encode(image, file.get(), message);
  if (good && std::fclose(file.release()) != 0) good = false;  // a full disk may appear only here
  std::error_code error;
  if (!good) {
    const std::string cause = errno ? std::strerror(errno) : message;
    file.reset();
    std::filesystem::remove(part, error);
    throw failed(cause);
  }
  std::filesystem::rename(part, path, error);
  if (error) throw failed(error.message());
}

}  // namespace thaw
