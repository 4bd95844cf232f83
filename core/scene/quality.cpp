#include "core/scene/quality.hpp"

namespace thaw {

void applyQuality(Quality quality, Numerics& n) {
  switch (quality) {
    case Quality::Preview:
      n.elasticPrecision = Precision::Single;
      n.cflElastic = 0.6;
      n.maxDensityError = 0.03;  // the liquid's sound, and with it the steps, 1.7 times slower
      break;
    case Quality::Standard: break;  // what Numerics says
    case Quality::Reference:
      n.precision = Precision::Double;
      n.cflSound = n.cflElastic = 0.2;
      n.cflViscous = 0.4;
      break;
  }
}

}  // namespace thaw
