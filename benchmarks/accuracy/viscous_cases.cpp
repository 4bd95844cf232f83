#include "benchmarks/accuracy/trial.hpp"

namespace thaw::accuracy {

std::vector<Case> viscousCases() { return {}; }

}  // namespace thaw::accuracy
