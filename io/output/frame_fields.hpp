// The fields that a scene's frames can carry, taken from a World.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/world.hpp"
#include "io/output/frame.hpp"

namespace thaw {

/// Names that [output] fields may have.
std::vector<std::string> knownFrameFields();

/// The scene's fields of the owned particles, and always their ids; numbers of the state in single precision.
/// A field whose module is off has the value that it stands for: temperature that of the body at the start,
/// liquid 0 or 1 by the material, density that at rest, others 0. The density of solids is rest density / det
/// F, that of liquids the sum over their neighbours. Of fields of solids (stress, strain, plastic_strain),
/// liquids have 0. `stress` needs computeCauchyStress (core/solid/elastic.hpp) before; pressure, density and
/// neighbours those of the last step. Throws std::invalid_argument for a name that is not known. The fields
/// are asked for when the frame is written: the world stays as it is till then.
Frame frameOf(const World& world, int rank);

}  // namespace thaw
