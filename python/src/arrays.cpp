// SPDX-License-Identifier: Apache-2.0
#include "python/src/arrays.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace thaw::python {

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

py::array ColumnArrays::of(AnyColumn& c, std::size_t rows, bool writable) {
  std::weak_ptr<KeptMemory>& place = kept_[&c];
  std::shared_ptr<KeptMemory> memory = place.lock();
  if (!memory) place = memory = std::make_shared<KeptMemory>();
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (c.components > 1) shape.push_back(c.components);
  py::array a(typeOf(c.scalar), shape, c.bytes.data(), py::cast(ArrayGuard{std::move(memory)}));
  if (!writable) a.attr("setflags")(py::arg("write") = false);
  return a;
}

void ColumnArrays::release() {
  for (auto& [column, place] : kept_) {
    const std::shared_ptr<KeptMemory> memory = place.lock();
    if (!memory) continue;
    AlignedVector<std::byte> copy = column->bytes;
    memory->bytes = std::exchange(column->bytes, std::move(copy));
  }
  kept_.clear();
}

void ColumnArrays::releaseFromEnd() {
  for (auto& [column, place] : kept_)
    if (const std::shared_ptr<KeptMemory> memory = place.lock()) memory->bytes = std::move(column->bytes);
  kept_.clear();
}

int ColumnArrays::count() const {
  return static_cast<int>(
      std::count_if(kept_.begin(), kept_.end(), [](const auto& one) { return !one.second.expired(); }));
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
