// SPDX-License-Identifier: Apache-2.0
// Errors of shapes and meshes, with their position in the scene file.
#pragma once
#include <stdexcept>
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Thrown for unusable shapes and meshes. what() is one sentence with the expected value, without the
/// position in the file.
struct ShapeError : std::runtime_error {
  explicit ShapeError(const std::string& message, SourcePlace place = {})
      : std::runtime_error(message), where(std::move(place)) {}
  SourcePlace where;  ///< position of the shape in the scene file; empty file name: unknown
};

/// Collects problems of a scene and reports them together, one line each: "file:line:column: error: text".
class SceneProblems {
 public:
  void add(const SourcePlace& where, const std::string& text) {
    if (!lines_.empty()) lines_ += "\n";
    if (where.line > 0)
      lines_ += where.file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": ";
    lines_ += "error: " + text;
  }
  /// Throws ShapeError if there are problems.
  void raise() const {
    if (!lines_.empty()) throw lines();
  }
  ShapeError lines() const { return ShapeError(lines_); }

 private:
  std::string lines_;
};

}  // namespace thaw
