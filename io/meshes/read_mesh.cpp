// SPDX-License-Identifier: Apache-2.0
#include "io/meshes/read_mesh.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

namespace thaw {
namespace {

bool startsWith(std::string_view s, std::string_view with) { return s.substr(0, with.size()) == with; }

std::uint32_t littleEndian(std::string_view s) {
  std::uint32_t n = 0;
  for (int k = 3; k >= 0; k--) n = n << 8 | static_cast<unsigned char>(s[static_cast<std::size_t>(k)]);
  return n;
}

bool hasEnding(const std::string& file, std::string_view ending) {
  std::string end = file.size() >= ending.size() ? file.substr(file.size() - ending.size()) : "";
  for (char& c : end) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return end == ending;
}

}  // namespace

MeshFormat meshFormatOf(std::string_view content, const std::string& file) {
  if (content.empty()) throw MeshError(file + ": the file is empty; expected an OBJ, PLY or STL mesh");
  if (startsWith(content, "ply\n") || startsWith(content, "ply\r")) return MeshFormat::Ply;
  if (content.size() >= 84 && content.size() - 84 == std::uint64_t{littleEndian(content.substr(80, 4))} * 50)
    return MeshFormat::BinaryStl;
  const bool binary = content.find('\0') != std::string_view::npos;
  const std::size_t begin = std::min(content.find_first_not_of(" \t\r\n"), content.size());
  if (!binary && startsWith(content.substr(begin), "solid") &&
      (hasEnding(file, ".stl") || content.find("facet") != std::string_view::npos))
    return MeshFormat::AsciiStl;
  if (hasEnding(file, ".stl")) return MeshFormat::BinaryStl;
  if (hasEnding(file, ".ply"))
    throw MeshError(file + ":1: expected the line 'ply' at the beginning of a PLY file");
  if (binary) throw MeshError(file + ": the file is neither an OBJ, nor a PLY, nor an STL mesh");
  return MeshFormat::Obj;
}

std::string_view withoutByteOrderMark(std::string_view content) {
  return startsWith(content, "\xef\xbb\xbf") ? content.substr(3) : content;
}

TriangleMesh parseMesh(std::string_view content, const std::string& file) {
  content = withoutByteOrderMark(content);
  switch (meshFormatOf(content, file)) {
    case MeshFormat::Ply: return parsePly(content, file);
    case MeshFormat::BinaryStl: return parseBinaryStl(content, file);
    case MeshFormat::AsciiStl: return parseAsciiStl(content, file);
    case MeshFormat::Obj: break;
  }
  return parseObj(content, file);
}

void readMeshFile(const std::string& path, const std::function<void(std::string_view)>& parse) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw MeshError(path + ": no such file");
  if (!std::filesystem::is_regular_file(status))
    throw MeshError(path + ": not a file; expected an OBJ, PLY or STL mesh");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw MeshError(path + ": cannot be opened: " + std::strerror(errno));
  try {
    const auto size = std::filesystem::file_size(path);
    std::string content(size, '\0');
    in.read(content.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(in.gcount()) != size)
      throw MeshError(path + ": reading stopped after " + std::to_string(in.gcount()) + " of " +
                      std::to_string(size) + " bytes");
    parse(content);
  } catch (const std::filesystem::filesystem_error& e) {
    throw MeshError(path + ": cannot be read: " + e.code().message());
  } catch (const std::bad_alloc&) {
    throw MeshError(path + ": the mesh does not fit into memory");
  } catch (const std::length_error&) { throw MeshError(path + ": the mesh does not fit into memory"); }
}

TriangleMesh readMesh(const std::string& path) {
  TriangleMesh mesh;
  readMeshFile(path, [&](std::string_view content) { mesh = parseMesh(content, path); });
  return mesh;
}

}  // namespace thaw
