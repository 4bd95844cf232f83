// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/ledger_row.hpp"

#include "core/ledger/body_type_row.hpp"

namespace thaw {

void addOrientedRow(const Oriented& o, std::size_t i, const Vec3d& gravity, ExactBalance& b) {
  addBodyTypeRow(o, i, {o.inertia[i] * o.spin[i], 0.5 * o.inertia[i] * dot(o.spin[i], o.spin[i])}, gravity,
                 b);
}

}  // namespace thaw
