// SPDX-License-Identifier: Apache-2.0
// Updates of the fields of extensions.
#pragma once
#include <functional>

#include "core/particles/continuum.hpp"

namespace thaw {

/// Input of the update of an extension's fields at the end of a step.
struct FieldStep {
  Continuum& particles;
  double time = 0;  ///< s, end of the step
  double dt = 0;    ///< s
};
/// Updates the fields of owned rows. To give the same bits on any number of ranks, it may use only the row's
/// own fields and the time.
using FieldUpdate = std::function<void(const FieldStep&)>;

}  // namespace thaw
