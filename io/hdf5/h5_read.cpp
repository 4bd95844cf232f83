// SPDX-License-Identifier: Apache-2.0
// H5File: reading names, shapes, rows, texts and numbers.
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "io/hdf5/h5_elements.hpp"
#include "io/hdf5/h5_file.hpp"
#include "io/hdf5/h5_handle.hpp"

namespace thaw {

bool H5File::has(const std::string& name) const {
  // H5Lexists requires each part of the path in turn
  for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
    if (H5Lexists(id_, name.substr(0, at).c_str(), H5P_DEFAULT) <= 0) return false;
    if (at == std::string::npos) return true;
  }
}

bool H5File::hasAttribute(const std::string& object, const std::string& attribute) const {
  return (object == "/" || has(object)) &&
         H5Aexists_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> H5File::children(const std::string& group) const {
  const H5Handle g(has(group) ? H5Gopen2(id_, group.c_str(), H5P_DEFAULT) : -1, H5Gclose);
  if (!g.valid()) fail("find group " + group);
  std::vector<std::string> names;
  const H5L_iterate_t collect = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  if (H5Literate(g.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0)
    fail("list group " + group);
  return names;
}

std::vector<std::string> H5File::attributes(const std::string& object) const {
  const H5Handle o(has(object) ? H5Oopen(id_, object.c_str(), H5P_DEFAULT) : -1, H5Oclose);
  if (!o.valid()) fail("find " + object);
  std::vector<std::string> names;
  const H5A_operator2_t collect = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  hsize_t at = 0;
  if (H5Aiterate2(o.id(), H5_INDEX_NAME, H5_ITER_INC, &at, collect, &names) < 0)
    fail("list the attributes of " + object);
  return names;
}

DatasetShape H5File::shape(const std::string& name) const {
  const H5Handle set(has(name) ? H5Dopen2(id_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (!set.valid()) fail("find dataset " + name);
  const H5Handle space(H5Dget_space(set.id()), H5Sclose), type(H5Dget_type(set.id()), H5Tclose);
  const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  hsize_t extent[H5S_MAX_RANK] = {};
  if (!type.valid() || rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), extent, nullptr) < 0)
    fail("read the rows and columns of dataset " + name);
  const DatasetShape s{elementOfType(type.id()), extent[0],
                       rank == 2 ? static_cast<int>(std::min<hsize_t>(extent[1], 1 << 20)) : 0};
  // a damaged size must not cause a huge allocation: the data must fit into the file (if compressed, a
  // thousandfold)
  std::error_code error;
  const std::uint64_t there = std::filesystem::file_size(path_, error);
  const haddr_t offset = H5Dget_offset(set.id());
  const std::uint64_t limit = offset == HADDR_UNDEF ? there * 1000
                              : offset < there      ? there - offset
                                                    : 0,
                      row = s.rowBytes();
  if (s.rows > 0 && row > 0 && s.rows > limit / row)
    throw IoError(path_, "is truncated or damaged: dataset " + name + " with " + std::to_string(s.rows) +
                             " rows does not fit into the file's " + std::to_string(there) + " bytes");
  return s;
}

std::uint64_t H5File::offset(const std::string& name) const {
  const H5Handle set(has(name) ? H5Dopen2(id_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  const haddr_t at = set.valid() ? H5Dget_offset(set.id()) : HADDR_UNDEF;
  if (at == HADDR_UNDEF) fail("find the offset of dataset " + name);
  return at;
}

void H5File::read(const std::string& name, const RowRange& range, Element as, void* data) const {
  if (range.count == 0) return;
  const DatasetShape s = shape(name);
  if (s.element == Element::Other)
    throw IoError(path_, "dataset " + name + " has an element type that thaw does not read");
  if (range.first > s.rows || range.count > s.rows - range.first)
    throw IoError(path_, "dataset " + name + " has " + std::to_string(s.rows) + " rows; " +
                             std::to_string(range.first + range.count) + " are needed");
  const H5Handle set(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const H5Handle space(set.valid() ? H5Dget_space(set.id()) : -1, H5Sclose);
  const hsize_t start[2] = {range.first, 0}, count[2] = {range.count, static_cast<hsize_t>(s.components)};
  const H5Handle memory(H5Screate_simple(s.components > 0 ? 2 : 1, count, nullptr), H5Sclose);
  if (!space.valid() || !memory.valid() ||
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
      H5Dread(set.id(), typeOf(as), memory.id(), space.id(), H5P_DEFAULT, data) < 0)
    fail("read dataset " + name);
}

namespace {

/// Limit (bytes) of texts; HDF5 itself limits attributes to 64 KiB.
constexpr std::uint64_t largestText = std::uint64_t(1) << 30;

/// Reads a fixed-length text that `read` copies from a dataset or attribute.
template<class Read>
std::string fixedText(hid_t type, Read&& read, const std::string& path, const std::string& what) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    throw IoError(path, what + " is not a fixed-length string");
  const std::size_t length = H5Tget_size(type);
  std::error_code error;
  if (length > largestText || length > std::filesystem::file_size(path, error))
    throw IoError(path, what + " is longer than the file");
  std::string text(length, '\0');
  if (read(text.data()) < 0) throw IoError(path, "cannot read " + what + h5Reason());
  text.resize(std::strlen(text.c_str()) < length ? std::strlen(text.c_str()) : length);
  return text;
}

}  // namespace

std::string H5File::readText(const std::string& name) const {
  const H5Handle set(has(name) ? H5Dopen2(id_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (!set.valid()) fail("find text " + name);
  const H5Handle type(H5Dget_type(set.id()), H5Tclose), space(H5Dget_space(set.id()), H5Sclose);
  if (!type.valid() || H5Sget_simple_extent_npoints(space.id()) != 1) fail("read text " + name);
  return fixedText(
      type.id(), [&](char* to) { return H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, to); },
      path_, "text " + name);
}

std::string H5File::text(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute)
                       ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT)
                       : -1,
                   H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  if (!type.valid() || H5Sget_simple_extent_npoints(space.id()) != 1)
    fail("read attribute " + attribute + " of " + object);
  return fixedText(
      type.id(), [&](char* to) { return H5Aread(a.id(), type.id(), to); }, path_,
      "attribute " + attribute + " of " + object);
}

std::vector<std::int64_t> H5File::integers(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute)
                       ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT)
                       : -1,
                   H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  const hssize_t n = space.valid() ? H5Sget_simple_extent_npoints(space.id()) : -1;
  if (!type.valid() || H5Tget_class(type.id()) != H5T_INTEGER || n < 1 || n > 65536)
    fail("read numbers in attribute " + attribute + " of " + object);
  std::vector<std::int64_t> values(static_cast<std::size_t>(n));
  if (H5Aread(a.id(), H5T_NATIVE_INT64, values.data()) < 0)
    fail("read attribute " + attribute + " of " + object);
  return values;
}

std::int64_t H5File::integer(const std::string& object, const std::string& attribute) const {
  return integers(object, attribute).front();
}

double H5File::number(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute)
                       ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT)
                       : -1,
                   H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  double value = 0;
  if (!type.valid() || (H5Tget_class(type.id()) != H5T_FLOAT && H5Tget_class(type.id()) != H5T_INTEGER) ||
      H5Sget_simple_extent_npoints(space.id()) != 1 || H5Aread(a.id(), H5T_NATIVE_DOUBLE, &value) < 0)
    fail("read attribute " + attribute + " of " + object);
  return value;
}

}  // namespace thaw
