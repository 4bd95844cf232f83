// What is wrong with a shape or a mesh, and where the scene said so.
#pragma once
#include <stdexcept>
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Thrown for shapes and meshes that cannot be used. what() is one sentence that says what was expected,
/// without the place.
struct ShapeError : std::runtime_error {
  explicit ShapeError(const std::string& message, SourcePlace place = {})
      : std::runtime_error(message), where(std::move(place)) {}
  SourcePlace where;  ///< of the shape in the scene; empty file: not known
};

/// Several problems of a scene, collected so that all are told at once; each line as "file:line:column:
/// error: text".
class SceneProblems {
 public:
  void add(const SourcePlace& where, const std::string& text) {
    if (!lines_.empty()) lines_ += "\n";
    if (where.line > 0)
      lines_ += where.file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": ";
    lines_ += "error: " + text;
  }
  /// Throws ShapeError where there are any.
  void raise() const {
    if (!lines_.empty()) throw lines();
  }
  ShapeError lines() const { return ShapeError(lines_); }

 private:
  std::string lines_;
};

}  // namespace thaw
