// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/h5_file.hpp"

#include <hdf5.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "io/hdf5/file_trailer.hpp"
#include "io/hdf5/h5_elements.hpp"
#include "io/hdf5/h5_handle.hpp"

namespace thaw {
namespace {

H5Handle spaceOf(const DatasetShape& s) {
  const hsize_t extent[2] = {s.rows, static_cast<hsize_t>(s.components)};
  return {H5Screate_simple(s.components > 0 ? 2 : 1, extent, nullptr), H5Sclose};
}

H5Handle textType(std::size_t length, H5T_cset_t characters) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  if (type.valid() &&
      (H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) < 0 ||
       H5Tset_strpad(type.id(), H5T_STR_NULLPAD) < 0 || H5Tset_cset(type.id(), characters) < 0))
    return {};
  return type;
}

/// Locks are unnecessary (files appear by rename) and fail on some cluster file systems.
H5Handle accessList() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (access.valid()) H5Pset_file_locking(access.id(), false, true);
  return access;
}

}  // namespace

void H5File::fail(const std::string& what) const { throw IoError(path_, "cannot " + what + h5Reason()); }

H5File H5File::create(const std::string& path) {
  const H5Handle access = accessList();
  const hid_t id = access.valid() ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()) : -1;
  if (id < 0) throw IoError(path, "cannot create the file" + h5Reason());
  return {path, id, true};
}

H5File H5File::openToAdd(const std::string& path) {
  const H5Handle access = accessList();
  const hid_t id = access.valid() ? H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()) : -1;
  if (id < 0) throw IoError(path, "cannot be opened for writing" + h5Reason());
  return {path, id, true};
}

H5File H5File::openToRead(const std::string& path, Trailer trailer) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw IoError(path, "is a folder, not a file");
  if (!std::filesystem::exists(path, error)) throw IoError(path, "no such file");
  if (std::filesystem::file_size(path, error) == 0 && !error) throw IoError(path, "the file is empty");
  if (!checkTrailer(path) && trailer == Trailer::MustBe)
    throw IoError(
        path, "has no trailer with a checksum: it was cut short, or written by an earlier version of thaw");
  const H5Handle access = accessList();
  const hid_t id = access.valid() ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()) : -1;
  if (id < 0)
    throw IoError(path, "cannot be opened as an HDF5 file (not one, or truncated or damaged)" + h5Reason());
  return {path, id, true};
}

H5File H5File::openToFill(const std::string& path, MPI_Comm comm) {
  const H5Handle access = accessList();
  int size = 1;
  MPI_Comm_size(comm, &size);
  // one rank uses the serial driver: it is faster and needs no MPI-IO
  if (access.valid() && size > 1 && H5Pset_fapl_mpio(access.id(), comm, MPI_INFO_NULL) < 0)
    throw IoError(path, "cannot use MPI-IO" + h5Reason());
  const hid_t id = access.valid() ? H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()) : -1;
  if (id < 0) throw IoError(path, "cannot be opened for writing" + h5Reason());
  return {path, id, false};
}

H5File::H5File(H5File&& other) noexcept
    : path_(std::move(other.path_)), id_(other.id_), alone_(other.alone_) {
  other.id_ = -1;
}

H5File::~H5File() {
  try {
    close();
  } catch (...) {  // callers that handle errors have called close
  }
}

void H5File::close() {
  const hid_t id = id_;
  id_ = -1;
  // HDF5 1.10 frees a file whose last write fails on close, but keeps its identifier and crashes at exit. So
  // flush first, and leave the file open if that fails.
  if (id >= 0 && alone_ && H5Fflush(id, H5F_SCOPE_GLOBAL) < 0) fail("write the file to its end");
  if (id >= 0 && H5Fclose(id) < 0) fail("write the file to its end");
}

void H5File::flush() {
  if (H5Fflush(id_, H5F_SCOPE_GLOBAL) < 0) fail("write the file to the disk");
}

void H5File::createGroup(const std::string& name) {
  if (!H5Handle(H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose).valid())
    fail("create group " + name);
}

void H5File::createDataset(const std::string& name, const DatasetShape& shape) {
  const H5Handle space = spaceOf(shape), creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (!space.valid() || !creation.valid() || H5Pset_layout(creation.id(), H5D_CONTIGUOUS) < 0 ||
      H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY) < 0 ||
      H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER) < 0)
    fail("describe dataset " + name);
  const H5Handle data(H5Dcreate2(id_, name.c_str(), typeOf(shape.element), space.id(), H5P_DEFAULT,
                                 creation.id(), H5P_DEFAULT),
                      H5Dclose);
  if (!data.valid()) fail("create dataset " + name);
}

void H5File::writeAll(const std::string& name, const DatasetShape& shape, const void* data) {
  createDataset(name, shape);
  write(name, {0, shape.rows}, data);
}

void H5File::write(const std::string& name, const RowRange& range, const void* data) {
  if (range.count == 0) return;
  const H5Handle set(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) fail("open dataset " + name);
  const H5Handle space(H5Dget_space(set.id()), H5Sclose), type(H5Dget_type(set.id()), H5Tclose);
  hsize_t extent[H5S_MAX_RANK] = {};
  const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), extent, nullptr) < 0)
    fail("read the shape of dataset " + name);
  // in pieces below 1 GiB: MPI-IO counts bytes in 32 bits
  const hsize_t row = H5Tget_size(type.id()) * (rank == 2 ? extent[1] : 1),
                piece = std::max<hsize_t>(1, (hsize_t(1) << 30) / row);
  const hid_t memoryType = typeOf(elementOfType(type.id()));
  for (hsize_t done = 0; done < range.count; done += piece) {
    const hsize_t start[2] = {range.first + done, 0},
                  count[2] = {std::min<hsize_t>(piece, range.count - done), extent[1]};
    const H5Handle memory(H5Screate_simple(rank, count, nullptr), H5Sclose);
    if (!memory.valid() ||
        H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dwrite(set.id(), memoryType, memory.id(), space.id(), H5P_DEFAULT,
                 static_cast<const std::byte*>(data) + done * row) < 0)
      fail("write dataset " + name);
  }
}

void H5File::writeText(const std::string& name, const std::string& text) {
  const H5Handle type = textType(text.size(), H5T_CSET_UTF8), space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle set(type.valid() && space.valid() ? H5Dcreate2(id_, name.c_str(), type.id(), space.id(),
                                                                H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)
                                                   : -1,
                     H5Dclose);
  if (!set.valid() || H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) < 0)
    fail("write text " + name);
}

void H5File::setText(const std::string& object, const std::string& attribute, const std::string& text) {
  const H5Handle type = textType(text.size(), H5T_CSET_ASCII), space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(type.valid() ? H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), type.id(),
                                                    space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)
                                : -1,
                   H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), type.id(), text.c_str()) < 0)
    fail("write attribute " + attribute + " of " + object);
}

void H5File::setIntegers(const std::string& object, const std::string& attribute,
                         const std::vector<std::int64_t>& values) {
  const hsize_t n = values.size();
  const H5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_INT64, space.id(),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_INT64, values.data()) < 0)
    fail("write attribute " + attribute + " of " + object);
}

void H5File::setInteger(const std::string& object, const std::string& attribute, std::int64_t value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_INT64, space.id(),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_INT64, &value) < 0)
    fail("write attribute " + attribute + " of " + object);
}

void H5File::setNumber(const std::string& object, const std::string& attribute, double value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_DOUBLE, space.id(),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_DOUBLE, &value) < 0)
    fail("write attribute " + attribute + " of " + object);
}

void useRomio() { setenv("OMPI_MCA_io", "romio321", 0); }

}  // namespace thaw
