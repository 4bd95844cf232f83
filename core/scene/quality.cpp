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
      n.precision = Precision::Double;  // spurious currents of drops and lost angular momentum are rounding
      n.density = DensityForm::Continuity;  // a quarter of the error of pressure at rest, .6 of a dam
                                            // break's; not with emitters (check_scene.cpp)
      n.cflSound = 0.2;  // with it the books close within 1 % where liquid is poured and splashes (2 % at .4)
      break;
  }
}

void applyQuality(Quality quality, Material& m) {
  if (quality == Quality::Reference) m.hourglass = 1.5;  // shear waves are exact to 4e-4 at 20 spacings
}

}  // namespace thaw
