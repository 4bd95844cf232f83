#include "io/scene/read_sections.hpp"
#include "io/scene/read_shape.hpp"

namespace thaw {

void readOriented(TableReader& r, SceneReading& x) {
  OrientedBody b;
  b.where = r.place();
  r.text("name", b.name, "for messages and `--set`; none: \"oriented\" and its number");
  readShape(r, b.shape);
  r.number("spacing", b.spacing, "m", notNegative(), "wanted distance of its particles; 0: that of the scene");
  r.number("support", b.support, "", between(1.5, 8), "radius within which they act on each other, over their spacing");
  if (r.describing()) return;
  if (b.name.empty()) b.name = "oriented " + std::to_string(x.scene->oriented.size());
  x.scene->oriented.push_back(std::move(b));
}

}  // namespace thaw
