// An oriented body as the scene says it ([[oriented]]).
#pragma once
#include "core/scene/shape.hpp"

namespace thaw {

struct OrientedBody {
  std::string name;
  SourcePlace where;
  Shape shape;
  double spacing = 0;        // m, wanted distance of its particles; 0: the scene's
  double support = 3;        // 1, radius of its pair forces over its spacing
};

}  // namespace thaw
