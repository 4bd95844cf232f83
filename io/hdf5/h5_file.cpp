#include "io/hdf5/h5_file.hpp"

#include <hdf5.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "io/hdf5/h5_handle.hpp"

namespace thaw {
namespace {

/// Groups and datasets below the depth at which names are cut would need no limit; attributes do: HDF5 keeps them in 64 KiB.
constexpr std::uint64_t largestText = std::uint64_t(1) << 30;

hid_t typeOf(Element e) {
  switch (e) {
    case Element::F64: return H5T_NATIVE_DOUBLE;
    case Element::F32: return H5T_NATIVE_FLOAT;
    case Element::U64: return H5T_NATIVE_UINT64;
    case Element::U32: return H5T_NATIVE_UINT32;
    case Element::U16: return H5T_NATIVE_UINT16;
    case Element::U8: return H5T_NATIVE_UINT8;
    case Element::I64: return H5T_NATIVE_INT64;
    case Element::I32: return H5T_NATIVE_INT32;
    case Element::Other: break;
  }
  return -1;
}

Element elementOfType(hid_t type) {
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) == H5T_FLOAT) return size == 8 ? Element::F64 : size == 4 ? Element::F32 : Element::Other;
  if (H5Tget_class(type) != H5T_INTEGER) return Element::Other;
  if (H5Tget_sign(type) == H5T_SGN_NONE)
    return size == 8 ? Element::U64 : size == 4 ? Element::U32 : size == 2 ? Element::U16 : size == 1 ? Element::U8 : Element::Other;
  return size == 8 ? Element::I64 : size == 4 ? Element::I32 : Element::Other;
}

H5Handle spaceOf(const DatasetShape& s) {
  const hsize_t extent[2] = {s.rows, static_cast<hsize_t>(s.components)};
  return {H5Screate_simple(s.components > 0 ? 2 : 1, extent, nullptr), H5Sclose};
}

H5Handle textType(std::size_t length, H5T_cset_t characters) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  if (type.valid() && (H5Tset_size(type.id(), std::max<std::size_t>(length, 1)) < 0 || H5Tset_strpad(type.id(), H5T_STR_NULLPAD) < 0 ||
                       H5Tset_cset(type.id(), characters) < 0))
    return {};
  return type;
}

/// Locks are of no use here (files appear by rename) and fail on some cluster file systems.
H5Handle accessList() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (access.valid()) H5Pset_file_locking(access.id(), false, true);
  return access;
}

}  // namespace

Element elementOf(Scalar s) {
  switch (s) {
    case Scalar::F64: return Element::F64;
    case Scalar::F32: return Element::F32;
    case Scalar::U64: return Element::U64;
    case Scalar::U32: return Element::U32;
    case Scalar::U16: return Element::U16;
    case Scalar::U8: return Element::U8;
  }
  return Element::Other;
}

std::size_t bytesOf(Element e) {
  constexpr std::size_t bytes[] = {8, 4, 8, 4, 2, 1, 8, 4, 0};
  return bytes[static_cast<std::size_t>(e)];
}

const char* nameOf(Element e) {
  constexpr const char* names[] = {"float64", "float32", "uint64", "uint32", "uint16", "uint8", "int64", "int32", "other"};
  return names[static_cast<std::size_t>(e)];
}

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
  if (id < 0) throw IoError(path, "cannot open the file to write to it" + h5Reason());
  return {path, id, true};
}

H5File H5File::openToRead(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw IoError(path, "is a folder, not a file");
  if (!std::filesystem::exists(path, error)) throw IoError(path, "there is no such file");
  if (std::filesystem::file_size(path, error) == 0 && !error) throw IoError(path, "the file is empty");
  const H5Handle access = accessList();
  const hid_t id = access.valid() ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()) : -1;
  if (id < 0) throw IoError(path, "cannot be opened as an HDF5 file (not one, or truncated or damaged)" + h5Reason());
  return {path, id, true};
}

H5File H5File::openToFill(const std::string& path, MPI_Comm comm) {
  const H5Handle access = accessList();
  int size = 1;
  MPI_Comm_size(comm, &size);
  // alone, the serial driver does: it is faster and needs no MPI-IO
  if (access.valid() && size > 1 && H5Pset_fapl_mpio(access.id(), comm, MPI_INFO_NULL) < 0)
    throw IoError(path, "cannot use MPI-IO" + h5Reason());
  const hid_t id = access.valid() ? H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()) : -1;
  if (id < 0) throw IoError(path, "cannot open the file to write to it" + h5Reason());
  return {path, id, false};
}

H5File::H5File(H5File&& other) noexcept : path_(std::move(other.path_)), id_(other.id_), alone_(other.alone_) { other.id_ = -1; }

H5File::~H5File() {
  try {
    close();
  } catch (...) {  // whoever needs to know has called close
  }
}

void H5File::close() {
  const hid_t id = id_;
  id_ = -1;
  // HDF5 1.10 frees a file whose last write fails in closing, but keeps its identifier, and falls over it when the library ends. So what
  // can fail is done before, and a file for which it does fail is left open.
  if (id >= 0 && alone_ && H5Fflush(id, H5F_SCOPE_GLOBAL) < 0) fail("write the file to its end");
  if (id >= 0 && H5Fclose(id) < 0) fail("write the file to its end");
}

void H5File::flush() {
  if (H5Fflush(id_, H5F_SCOPE_GLOBAL) < 0) fail("write the file to the disk");
}

void H5File::createGroup(const std::string& name) {
  if (!H5Handle(H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose).valid()) fail("create group " + name);
}

void H5File::createDataset(const std::string& name, const DatasetShape& shape) {
  const H5Handle space = spaceOf(shape), creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (!space.valid() || !creation.valid() || H5Pset_layout(creation.id(), H5D_CONTIGUOUS) < 0 ||
      H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY) < 0 || H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER) < 0)
    fail("describe dataset " + name);
  const H5Handle data(H5Dcreate2(id_, name.c_str(), typeOf(shape.element), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Dclose);
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
  if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), extent, nullptr) < 0) fail("see the shape of dataset " + name);
  // in pieces below 1 GiB: MPI-IO counts bytes in 32 bits
  const hsize_t row = H5Tget_size(type.id()) * (rank == 2 ? extent[1] : 1), piece = std::max<hsize_t>(1, (hsize_t(1) << 30) / row);
  const hid_t memoryType = typeOf(elementOfType(type.id()));
  for (hsize_t done = 0; done < range.count; done += piece) {
    const hsize_t start[2] = {range.first + done, 0}, count[2] = {std::min<hsize_t>(piece, range.count - done), extent[1]};
    const H5Handle memory(H5Screate_simple(rank, count, nullptr), H5Sclose);
    if (!memory.valid() || H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dwrite(set.id(), memoryType, memory.id(), space.id(), H5P_DEFAULT, static_cast<const std::byte*>(data) + done * row) < 0)
      fail("write dataset " + name);
  }
}

void H5File::writeText(const std::string& name, const std::string& text) {
  const H5Handle type = textType(text.size(), H5T_CSET_UTF8), space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle set(type.valid() && space.valid() ? H5Dcreate2(id_, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT) : -1,
                     H5Dclose);
  if (!set.valid() || H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) < 0) fail("write text " + name);
}

void H5File::setText(const std::string& object, const std::string& attribute, const std::string& text) {
  const H5Handle type = textType(text.size(), H5T_CSET_ASCII), space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(type.valid() ? H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)
                                : -1, H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), type.id(), text.c_str()) < 0) fail("write attribute " + attribute + " of " + object);
}

void H5File::setIntegers(const std::string& object, const std::string& attribute, const std::vector<std::int64_t>& values) {
  const hsize_t n = values.size();
  const H5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_INT64, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_INT64, values.data()) < 0) fail("write attribute " + attribute + " of " + object);
}

void H5File::setInteger(const std::string& object, const std::string& attribute, std::int64_t value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_INT64, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_INT64, &value) < 0) fail("write attribute " + attribute + " of " + object);
}

void H5File::setNumber(const std::string& object, const std::string& attribute, double value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const H5Handle a(H5Acreate_by_name(id_, object.c_str(), attribute.c_str(), H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!a.valid() || H5Awrite(a.id(), H5T_NATIVE_DOUBLE, &value) < 0) fail("write attribute " + attribute + " of " + object);
}

bool H5File::has(const std::string& name) const {
  for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {  // each part of the path in turn, as H5Lexists wants it
    if (H5Lexists(id_, name.substr(0, at).c_str(), H5P_DEFAULT) <= 0) return false;
    if (at == std::string::npos) return true;
  }
}

bool H5File::hasAttribute(const std::string& object, const std::string& attribute) const {
  return (object == "/" || has(object)) && H5Aexists_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> H5File::children(const std::string& group) const {
  const H5Handle g(has(group) ? H5Gopen2(id_, group.c_str(), H5P_DEFAULT) : -1, H5Gclose);
  if (!g.valid()) fail("find group " + group);
  std::vector<std::string> names;
  const H5L_iterate_t collect = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  if (H5Literate(g.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0) fail("list group " + group);
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
  if (H5Aiterate2(o.id(), H5_INDEX_NAME, H5_ITER_INC, &at, collect, &names) < 0) fail("list the attributes of " + object);
  return names;
}

DatasetShape H5File::shape(const std::string& name) const {
  const H5Handle set(has(name) ? H5Dopen2(id_, name.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  if (!set.valid()) fail("find dataset " + name);
  const H5Handle space(H5Dget_space(set.id()), H5Sclose), type(H5Dget_type(set.id()), H5Tclose);
  const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  hsize_t extent[H5S_MAX_RANK] = {};
  if (!type.valid() || rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), extent, nullptr) < 0)
    fail("see rows and columns in dataset " + name);
  const DatasetShape s{elementOfType(type.id()), extent[0], rank == 2 ? static_cast<int>(std::min<hsize_t>(extent[1], 1 << 20)) : 0};
  // a damaged size must not become a huge allocation: what is said to be there has to fit into the file (compressed: a thousandfold)
  std::error_code error;
  const std::uint64_t there = std::filesystem::file_size(path_, error);
  const haddr_t offset = H5Dget_offset(set.id());
  const std::uint64_t limit = offset == HADDR_UNDEF ? there * 1000 : offset < there ? there - offset : 0, row = s.rowBytes();
  if (s.rows > 0 && row > 0 && s.rows > limit / row)
    throw IoError(path_, "is truncated or damaged: dataset " + name + " with " + std::to_string(s.rows) + " rows does not fit into the file's " +
                             std::to_string(there) + " bytes");
  return s;
}

void H5File::read(const std::string& name, const RowRange& range, Element as, void* data) const {
  if (range.count == 0) return;
  const DatasetShape s = shape(name);
  if (s.element == Element::Other) throw IoError(path_, "dataset " + name + " is not of numbers that thaw reads");
  if (range.first > s.rows || range.count > s.rows - range.first)
    throw IoError(path_, "dataset " + name + " has " + std::to_string(s.rows) + " rows; " + std::to_string(range.first + range.count) + " are needed");
  const H5Handle set(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const H5Handle space(set.valid() ? H5Dget_space(set.id()) : -1, H5Sclose);
  const hsize_t start[2] = {range.first, 0}, count[2] = {range.count, static_cast<hsize_t>(s.components)};
  const H5Handle memory(H5Screate_simple(s.components > 0 ? 2 : 1, count, nullptr), H5Sclose);
  if (!space.valid() || !memory.valid() || H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
      H5Dread(set.id(), typeOf(as), memory.id(), space.id(), H5P_DEFAULT, data) < 0)
    fail("read dataset " + name);
}

namespace {

/// Reads a text that `read` copies from a dataset or an attribute.
template<class Read> std::string fixedText(hid_t type, Read&& read, const std::string& path, const std::string& what) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) throw IoError(path, what + " is not a text of fixed length");
  const std::size_t length = H5Tget_size(type);
  std::error_code error;
  if (length > largestText || length > std::filesystem::file_size(path, error)) throw IoError(path, what + " is longer than the file");
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
  return fixedText(type.id(), [&](char* to) { return H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, to); }, path_, "text " + name);
}

std::string H5File::text(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute) ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT) : -1, H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  if (!type.valid() || H5Sget_simple_extent_npoints(space.id()) != 1) fail("read attribute " + attribute + " of " + object);
  return fixedText(type.id(), [&](char* to) { return H5Aread(a.id(), type.id(), to); }, path_, "attribute " + attribute + " of " + object);
}

std::vector<std::int64_t> H5File::integers(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute) ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT) : -1, H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  const hssize_t n = space.valid() ? H5Sget_simple_extent_npoints(space.id()) : -1;
  if (!type.valid() || H5Tget_class(type.id()) != H5T_INTEGER || n < 1 || n > 65536) fail("read numbers in attribute " + attribute + " of " + object);
  std::vector<std::int64_t> values(static_cast<std::size_t>(n));
  if (H5Aread(a.id(), H5T_NATIVE_INT64, values.data()) < 0) fail("read attribute " + attribute + " of " + object);
  return values;
}

std::int64_t H5File::integer(const std::string& object, const std::string& attribute) const { return integers(object, attribute).front(); }

double H5File::number(const std::string& object, const std::string& attribute) const {
  const H5Handle a(hasAttribute(object, attribute) ? H5Aopen_by_name(id_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT) : -1, H5Aclose);
  if (!a.valid()) fail("find attribute " + attribute + " of " + object);
  const H5Handle type(H5Aget_type(a.id()), H5Tclose), space(H5Aget_space(a.id()), H5Sclose);
  double value = 0;
  if (!type.valid() || (H5Tget_class(type.id()) != H5T_FLOAT && H5Tget_class(type.id()) != H5T_INTEGER) || H5Sget_simple_extent_npoints(space.id()) != 1 ||
      H5Aread(a.id(), H5T_NATIVE_DOUBLE, &value) < 0)
    fail("read attribute " + attribute + " of " + object);
  return value;
}

void useRomio() { setenv("OMPI_MCA_io", "romio321", 0); }

}  // namespace thaw
