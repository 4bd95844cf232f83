#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> solidCases() { return {}; }

}  // namespace thaw::accuracy
