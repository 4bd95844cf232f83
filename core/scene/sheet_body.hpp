// A sheet body as the scene says it ([[sheet]]).
#pragma once
#include "core/scene/shape.hpp"

namespace thaw {

struct SheetBody {
  std::string name;
  SourcePlace where;
  Shape shape;
};

}  // namespace thaw
