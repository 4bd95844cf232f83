// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/warnings/fixed_step.hpp"

#include <cstdio>

namespace thaw {
namespace {

std::string textOf(Limit l, double value) {
  const char* name = l == Limit::Scene ? "max_step" : limitNames[static_cast<std::size_t>(l)];
  char text[80];
  std::snprintf(text, sizeof text, "%s, %.3g s", name, value);
  return text;
}

}  // namespace

std::vector<SceneWarning> longFixedStep(const Scene& s, double step, const StepLimits& limits) {
  const Limit shortest = limits.smallest();
  const double least = limits[shortest];
  if (!(s.numerics.fixedStep > 0) || !(step > least * (1 + 1e-9))) return {};
  std::string others;
  for (std::size_t k = 0; k < limitNames.size(); k++)
    if (const Limit l = static_cast<Limit>(k); l != shortest && step > limits[l])
      others += (others.empty() ? " (also " : "; ") + textOf(l, limits[l]);
  if (!others.empty()) others += ")";
  char first[120], remedy[160];
  std::snprintf(first, sizeof first, "numerics.fixed_step: steps of %.3g s are longer than the limit of ",
                step);
  std::snprintf(
      remedy, sizeof remedy,
      ": the run may be unstable. Set `numerics.fixed_step` to %.3g s or less, or remove it, so that "
      "steps follow the limits",
      0.99 * least);
  return {{{s.file, 0, 0}, first + textOf(shortest, least) + others + remedy}};
}

}  // namespace thaw
