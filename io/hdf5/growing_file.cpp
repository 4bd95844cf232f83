// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/growing_file.hpp"

#include <hdf5.h>

#include <algorithm>

#include "io/hdf5/h5_elements.hpp"
#include "io/hdf5/h5_handle.hpp"

namespace thaw {

GrowingFile::GrowingFile(std::filesystem::path path, const std::vector<std::string>& groups)
    : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  H5File file = H5File::create(part_.string());
  for (const std::string& group : groups) file.createGroup(group);
  file.close();
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (access.valid()) H5Pset_file_locking(access.id(), false, true);
  id_ = access.valid() ? H5Fopen(part_.c_str(), H5F_ACC_RDWR, access.id()) : -1;
  if (id_ < 0) fail("open the file");
}

GrowingFile::~GrowingFile() {
  if (id_ >= 0) H5Fclose(id_);
  std::error_code error;
  if (!finished_) std::filesystem::remove(part_, error);
}

void GrowingFile::fail(const std::string& what) const {
  throw IoError(path_.string(), "cannot " + what + h5Reason());
}

void GrowingFile::createDataset(const std::string& name, const DatasetShape& shape) {
  const int rank = shape.components > 0 ? 2 : 1;
  const auto width = static_cast<hsize_t>(shape.components);
  const hsize_t none[2] = {0, width}, most[2] = {H5S_UNLIMITED, width},
                chunk[2] = {std::max<hsize_t>(1, shape.rows), width};
  const H5Handle space(H5Screate_simple(rank, none, most), H5Sclose),
      creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (!space.valid() || !creation.valid() || H5Pset_chunk(creation.id(), rank, chunk) < 0)
    fail("describe dataset " + name);
  const H5Handle data(H5Dcreate2(id_, name.c_str(), typeOf(shape.element), space.id(), H5P_DEFAULT,
                                 creation.id(), H5P_DEFAULT),
                      H5Dclose);
  if (!data.valid()) fail("create dataset " + name);
}

void GrowingFile::append(const std::string& name, std::uint64_t rows, const void* data) {
  if (rows == 0) return;
  const H5Handle set(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) fail("open dataset " + name);
  hsize_t extent[2] = {};
  int rank = -1;
  {
    const H5Handle space(H5Dget_space(set.id()), H5Sclose);
    rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : -1;
    if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), extent, nullptr) < 0)
      fail("read the shape of dataset " + name);
  }
  const hsize_t start[2] = {extent[0], 0}, count[2] = {rows, extent[1]};
  extent[0] += rows;
  if (H5Dset_extent(set.id(), extent) < 0) fail("extend dataset " + name);
  const H5Handle space(H5Dget_space(set.id()), H5Sclose),
      memory(H5Screate_simple(rank, count, nullptr), H5Sclose), type(H5Dget_type(set.id()), H5Tclose);
  if (!space.valid() || !memory.valid() || !type.valid() ||
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
      H5Dwrite(set.id(), typeOf(elementOfType(type.id())), memory.id(), space.id(), H5P_DEFAULT, data) < 0)
    fail("write dataset " + name);
}

void GrowingFile::close() {
  const hid_t id = id_;
  id_ = -1;
  if (H5Fflush(id, H5F_SCOPE_GLOBAL) < 0 || H5Fclose(id) < 0) fail("write the file to its end");
}

void GrowingFile::finish(const std::function<void(H5File&)>& addMore) {
  close();
  H5File file = H5File::openToAdd(part_.string());
  addMore(file);
  file.close();
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  if (error) throw IoError(path_.string(), "cannot be written: " + error.message());
  finished_ = true;
}

}  // namespace thaw
