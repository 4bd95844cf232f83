#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> flowCases() { return {}; }

}  // namespace thaw::accuracy
