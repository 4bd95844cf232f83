// SPDX-License-Identifier: Apache-2.0
#include "python/src/arrays.hpp"

#include <cctype>
#include <string>
#include <vector>

namespace py = pybind11;

namespace thaw::python {
namespace {

py::dtype typeOf(Scalar s) {
  switch (s) {
    case Scalar::F64: return py::dtype::of<double>();
    case Scalar::F32: return py::dtype::of<float>();
    case Scalar::U64: return py::dtype::of<std::uint64_t>();
    case Scalar::U32: return py::dtype::of<std::uint32_t>();
    case Scalar::U16: return py::dtype::of<std::uint16_t>();
    case Scalar::U8: break;
  }
  return py::dtype::of<std::uint8_t>();
}

py::array make(const py::dtype& type, void* data, std::size_t rows, int components, const ArrayCount& count) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (components > 1) shape.push_back(components);
  return py::array(type, shape, data, py::cast(ArrayGuard(count)));
}

}  // namespace

py::array arrayOf(AnyColumn& c, std::size_t rows, bool writable, const ArrayCount& count) {
  py::array a = make(typeOf(c.scalar), c.bytes.data(), rows, c.components, count);
  if (!writable) a.attr("setflags")(py::arg("write") = false);
  return a;
}

py::array arrayOf(double* data, std::size_t rows, int components, const ArrayCount& count) {
  return make(py::dtype::of<double>(), data, rows, components, count);
}

std::string pythonName(const char* name) {
  std::string text;
  for (; *name; name++) {
    if (std::isupper(static_cast<unsigned char>(*name))) text += '_';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(*name)));
  }
  return text;
}

}  // namespace thaw::python
