// SPDX-License-Identifier: Apache-2.0
// USD as text. Values first go to a temporary file, since the text has all samples of an attribute
// together.
#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "io/export/out_file.hpp"
#include "io/export/usd/layer.hpp"
#include "io/hdf5/io_error.hpp"

namespace thaw {

namespace {

using Text = fmt::memory_buffer;

void add(Text& out, const char* text) { out.append(text, text + std::strlen(text)); }
void add(Text& out, bool v) { add(out, v ? "1" : "0"); }
void add(Text& out, std::int32_t v) { fmt::format_to(std::back_inserter(out), "{}", v); }
void add(Text& out, std::int64_t v) { fmt::format_to(std::back_inserter(out), "{}", v); }
void add(Text& out, float v) { fmt::format_to(std::back_inserter(out), "{:.9g}", v); }
void add(Text& out, double v) { fmt::format_to(std::back_inserter(out), "{:.17g}", v); }
void add(Text& out, const std::string& v) {
  out.push_back('"');
  for (const char c : v) {
    if (c == '\n') {
      add(out, "\\n");
      continue;
    }
    if (c == '"' || c == '\\') out.push_back('\\');
    out.push_back(c);
  }
  out.push_back('"');
}
void add(Text& out, const UsdToken& v) { add(out, v.text); }
void add(Text& out, const Vec2f& v) {
  fmt::format_to(std::back_inserter(out), "({:.9g}, {:.9g})", v[0], v[1]);
}
void add(Text& out, const Vec3f& v) {
  fmt::format_to(std::back_inserter(out), "({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}
void add(Text& out, const UsdMatrix& m) {
  for (std::size_t r = 0; r < 4; r++)
    fmt::format_to(std::back_inserter(out), "{}({:.17g}, {:.17g}, {:.17g}, {:.17g}){}", r == 0 ? "( " : ", ",
                   m[4 * r], m[4 * r + 1], m[4 * r + 2], m[4 * r + 3], r == 3 ? " )" : "");
}
template<class T> void add(Text& out, const std::vector<T>& values) {
  out.push_back('[');
  for (std::size_t i = 0; i < values.size(); i++) {
    if (i > 0) add(out, ", ");
    if constexpr (std::is_same_v<T, UsdToken>) add(out, values[i].text);
    else add(out, values[i]);
  }
  out.push_back(']');
}

class Usda : public UsdFile {
 public:
  explicit Usda(const std::filesystem::path& file) : path_(file), out_(file), valuePath_(file) {
    valuePath_ += ".values.part";
    errno = 0;
    values_.reset(std::fopen(valuePath_.c_str(), "w+b"));
    if (!values_) fail();
    std::setvbuf(values_.get(), nullptr, _IOFBF, 1 << 20);
  }
  ~Usda() override { removeValues(); }

  UsdBytes encode(const UsdValue& value) const override {
    Text text;
    std::visit([&](const auto& v) { add(text, v); }, value);
    return {{text.begin(), text.end()}, 0, false};
  }

  UsdPlace store(const UsdBytes& value) override {
    if (std::fwrite(value.bytes.data(), 1, value.bytes.size(), values_.get()) != value.bytes.size()) fail();
    ends_.push_back((ends_.empty() ? 0 : ends_.back()) + static_cast<std::int64_t>(value.bytes.size()));
    return ends_.size() - 1;
  }

  void finish(const UsdLayer& layer) override {
    Text head;
    add(head, "#usda 1.0\n(\n    defaultPrim = ");
    add(head, layer.root.name);
    add(head, "\n    doc = ");
    add(head, layer.comment);
    fmt::format_to(std::back_inserter(head),
                   "\n    endTimeCode = {:.17g}\n    framesPerSecond = {:.17g}\n    metersPerUnit = 1\n    "
                   "startTimeCode = {:.17g}\n    timeCodesPerSecond = {:.17g}\n    upAxis = \"Z\"\n)\n\n",
                   layer.end, layer.timeCodesPerSecond, layer.start, layer.timeCodesPerSecond);
    out_.bytes(head.data(), head.size());
    writePrim(layer.root, "");
    out_.finish();
    removeValues();
  }

 private:
  void removeValues() {
    values_.reset();
    std::error_code ignored;
    std::filesystem::remove(valuePath_, ignored);
  }

  void writePrim(const UsdPrim& prim, const std::string& indent) {
    out_.text(fmt::format("{0}def {1} \"{2}\"\n{0}{{\n", indent, prim.type, prim.name));
    for (const UsdAttribute& a : prim.attributes) writeAttribute(a, indent + "    ");
    for (const UsdPrim& child : prim.children) writePrim(child, indent + "    ");
    out_.text(indent + "}\n");
  }

  void writeAttribute(const UsdAttribute& a, const std::string& indent) {
    const std::string name = fmt::format("{}{}{}{} {}", indent, a.type.isCustom ? "custom " : "",
                                         a.type.isUniform ? "uniform " : "", a.type.type, a.type.name);
    if (a.value) {
      out_.text(name + " = ");
      copyValue(*a.value);
      if (!a.type.interpolation.empty())
        out_.text(fmt::format(" (\n{0}    interpolation = \"{1}\"\n{0})", indent, a.type.interpolation));
      out_.text("\n");
    } else if (!a.type.interpolation.empty()) {
      // on one line: the parser of three.js takes "primvars:NAME (" at a line's end for a time sample
      out_.text(fmt::format("{} (interpolation = \"{}\")\n", name, a.type.interpolation));
    }
    if (a.samples.empty()) return;
    out_.text(name + ".timeSamples = {\n");
    for (const auto& [time, place] : a.samples) {
      out_.text(fmt::format("{}    {:.17g}: ", indent, time));
      copyValue(place);
      out_.text(",\n");
    }
    out_.text(indent + "}\n");
  }

  void copyValue(UsdPlace place) {
    const std::int64_t start = place == 0 ? 0 : ends_[place - 1];
    std::vector<char> bytes(static_cast<std::size_t>(ends_[place] - start));
    if (fseeko(values_.get(), start, SEEK_SET) != 0 ||
        std::fread(bytes.data(), 1, bytes.size(), values_.get()) != bytes.size())
      fail();
    out_.bytes(bytes.data(), bytes.size());
  }

  [[noreturn]] void fail() const {
    throw IoError(path_.string(), std::string("cannot be written: ") +
                                      (errno ? std::strerror(errno) : "the disk may be full"));
  }

  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::filesystem::path path_;
  OutFile out_;
  std::filesystem::path valuePath_;
  std::unique_ptr<std::FILE, Close> values_;
  std::vector<std::int64_t> ends_;  // end offset of each value
};

}  // namespace

std::unique_ptr<UsdFile> openUsda(const std::filesystem::path& file) { return std::make_unique<Usda>(file); }

std::string usdName(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return out.empty() || std::isdigit(static_cast<unsigned char>(out[0])) ? "_" + out : out;
}

}  // namespace thaw
