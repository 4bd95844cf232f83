// Lists of all ranks, known to all.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"

namespace thaw {

/// The words of all ranks, one rank behind another. For lists that are short in all (labels, components). Collective.
std::vector<std::uint64_t> gatherWords(Reducer& all, const std::vector<std::uint64_t>& mine);

}  // namespace thaw
