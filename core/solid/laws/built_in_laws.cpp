// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/elastic_law.hpp"
#include "core/solid/laws/laws.hpp"

namespace thaw {
namespace {

template<class Law>
LawResponse respondOnce(const Mat3d& gradU, double lambda, double mu, const LawValues& values) {
  const LawPoint<double> at{identity3<double>() + gradU, lambda, mu, values, gradU};
  const auto shared = sharedOf<Law>(at);
  return {energyOf<Law>(at, shared), stressOf<Law>(at, shared)};
}

template<class Law> BuiltInLaw rowOf(int place) {
  static_assert(Law::keys.size() <= mostLawKeys);
  BuiltInLaw row{Law::name, Law::about, {Law::keys.begin(), Law::keys.end()}, {}};
  row.law.response = respondOnce<Law>;
  if constexpr (requires { Law::principal(Vec3d{}, 0.0, 0.0, LawValues{}); })
    row.law.principal = Law::principal;
  if constexpr (requires { Law::stiffening(1.0, LawValues{}); }) row.law.stiffening = Law::stiffening;
  row.law.resistsInversion = Law::resistsInversion;
  row.law.boundsStress = Law::boundsStress;
  row.law.builtIn = place;
  return row;
}

}  // namespace

const std::vector<BuiltInLaw>& builtInLaws() {
  static const std::vector<BuiltInLaw> all = [] {
    std::vector<BuiltInLaw> rows;
    BuiltInLaws::each([&]<class Law> { rows.push_back(rowOf<Law>(static_cast<int>(rows.size()))); });
    return rows;
  }();
  return all;
}

}  // namespace thaw
