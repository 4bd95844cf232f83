// SPDX-License-Identifier: Apache-2.0
#include "core/scene/quality.hpp"

namespace thaw {

void applyQuality(Quality quality, Numerics& n) {
  switch (quality) {
    case Quality::Preview:
      n.elasticPrecision = Precision::Single;
      n.cflElastic = 0.6;
      n.maxDensityError = 0.03;  // lowers the sound speed, so steps are 1.7 times longer
      break;
    case Quality::Standard: break;  // the defaults of Numerics
    case Quality::Reference:
      n.precision = Precision::Double;      // rounding errors cause spurious currents in drops, and loss of
                                            // angular momentum
      n.density = DensityForm::Continuity;  // the pressure error is a quarter at rest, and 0.6 times as large
                                            // in a dam break; not with emitters (check_scene.cpp)
      n.cflSound = 0.2;  // closes the energy budget within 1 % for pouring and splashing; 0.4 within 2 %
      break;
  }
}

void applyQuality(Quality quality, Material& m) {
  if (quality == Quality::Reference) m.hourglass = 1.5;  // shear waves are exact to 4e-4 at 20 spacings
}

}  // namespace thaw
