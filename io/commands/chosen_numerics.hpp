// Which choices of the method a scene has made itself.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Does a key ("numerics.cfl_elastic") differ from the default? False for what is no number or choice of
/// [numerics].
bool isChosen(const std::string& key, const Numerics& numerics);

}  // namespace thaw
