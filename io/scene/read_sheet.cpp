#include "io/scene/read_sections.hpp"
#include "io/scene/read_shape.hpp"

namespace thaw {

void readSheet(TableReader& r, SceneReading& x) {
  SheetBody b;
  b.where = r.place();
  r.text("name", b.name, "for messages and `--set`; none: \"sheet\" and its number");
  readShape(r, b.shape);
  if (r.describing()) return;
  if (b.name.empty()) b.name = "sheet " + std::to_string(x.scene->sheets.size());
  x.scene->sheets.push_back(std::move(b));
}

}  // namespace thaw
