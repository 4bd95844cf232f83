// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/h5_elements.hpp"

namespace thaw {

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
  if (H5Tget_class(type) == H5T_FLOAT)
    return size == 8 ? Element::F64 : size == 4 ? Element::F32 : Element::Other;
  if (H5Tget_class(type) != H5T_INTEGER) return Element::Other;
  if (H5Tget_sign(type) == H5T_SGN_NONE)
    return size == 8   ? Element::U64
           : size == 4 ? Element::U32
           : size == 2 ? Element::U16
           : size == 1 ? Element::U8
                       : Element::Other;
  return size == 8 ? Element::I64 : size == 4 ? Element::I32 : Element::Other;
}

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
  constexpr const char* names[] = {"float64", "float32", "uint64", "uint32", "uint16",
                                   "uint8",   "int64",   "int32",  "other"};
  return names[static_cast<std::size_t>(e)];
}

}  // namespace thaw
