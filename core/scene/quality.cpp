#include "core/scene/quality.hpp"

namespace thaw {

void applyQuality(Quality quality, Numerics& n) {
  switch (quality) {
    case Quality::Preview:
      n.precision = Precision::Single;
      n.maxDensityError = 0.03;
      break;
    case Quality::Standard: break;  // what Numerics says
    case Quality::Reference:
      n.precision = Precision::Double;
      n.cflSound = 0.25, n.cflElastic = 0.25, n.cflHeat = 0.4, n.cflViscous = 0.4;
      break;
  }
}

}  // namespace thaw
