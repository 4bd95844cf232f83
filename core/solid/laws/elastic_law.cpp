// SPDX-License-Identifier: Apache-2.0
#include "core/solid/laws/elastic_law.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "core/scene/scene.hpp"
#include "core/solid/laws/lane_matrix.hpp"

namespace thaw {
namespace {

struct KnownLaw {
  ElasticLaw law;
  std::vector<std::string> keys;
  std::vector<double> standard{};  // defaults of the keys of a law of the library
  std::map<LawValues, BoundLaw> bound{};
  std::mutex binding{};  // needed since simulations may run in several threads
};

void enter(std::map<std::string, KnownLaw>& all, const std::string& name, ElasticLaw law,
           std::vector<std::string> keys, std::vector<double> standard) {
  KnownLaw& known = all[name];
  known.law = std::move(law);
  known.keys = std::move(keys);
  known.standard = std::move(standard);
}

std::map<std::string, KnownLaw>& knownLaws() {
  static std::map<std::string, KnownLaw> all;
  static std::once_flag once;
  std::call_once(once, [] {
    for (const BuiltInLaw& row : builtInLaws()) {
      std::vector<std::string> keys;
      std::vector<double> standard;
      for (const LawKey& key : row.keys) keys.emplace_back(key.name), standard.push_back(key.standard);
      enter(all, row.name, row.law, std::move(keys), std::move(standard));
    }
  });
  return all;
}

}  // namespace

void addElasticLaw(const std::string& name, ElasticLaw law, std::vector<std::string> keys) {
  if (!law.kernels.lanes && !law.response)
    throw std::invalid_argument("extension '" + name + "': its law needs `kernels` or `response`");
  if (keys.size() > mostLawKeys)
    throw std::invalid_argument("extension '" + name + "': a law has at most " + std::to_string(mostLawKeys) +
                                " keys");
  enter(knownLaws(), name, std::move(law), std::move(keys), {});
}

const BoundLaw& boundLaw(const ExtensionSettings& settings) {
  const auto at = knownLaws().find(settings.name);
  if (at == knownLaws().end()) throw std::invalid_argument("unknown elastic law '" + settings.name + "'");
  KnownLaw& known = at->second;
  LawValues values{};
  for (std::size_t k = 0; k < known.keys.size(); k++) {
    const auto given = settings.values.find(known.keys[k]);
    values[k] = given == settings.values.end() && k < known.standard.size()
                    ? known.standard[k]
                    : settings.values.at(known.keys[k]);
  }
  const std::scoped_lock one(known.binding);
  return known.bound.try_emplace(values, BoundLaw{&known.law, values}).first->second;
}

const BoundLaw& boundLaw(const Material& m) {
  try {
    return boundLaw(m.law);
  } catch (const std::invalid_argument& e) {
    throw std::invalid_argument("material '" + m.name + "': " + e.what());
  }
}

LawResponse responseOf(const BoundLaw& bound, const Mat3d& gradU, double lambda, double mu) {
  if (bound.law->response) return bound.law->response(gradU, lambda, mu, bound.values);
  alignas(64) double gradient[9][8]{}, stress[9][8]{}, lambdas[8]{}, mus[8]{}, energy[8]{};
  setLaneMatrix(gradU, gradient, 0);
  lambdas[0] = lambda, mus[0] = mu;
  bound.law->kernels.lanes({gradient, lambdas, mus, bound.values, stress, energy});
  return {energy[0], laneMatrix(stress, 0)};
}

Vec3d principalOf(const BoundLaw& bound, const Vec3d& stretch, double lambda, double mu) {
  if (bound.law->principal) return bound.law->principal(stretch, lambda, mu, bound.values);
  Mat3d gradU{};
  for (int k = 0; k < 3; k++) gradU.row[k][k] = stretch[k] - 1;
  const Mat3d stress = responseOf(bound, gradU, lambda, mu).stress;
  return {stress.row[0].x * stretch.x, stress.row[1].y * stretch.y, stress.row[2].z * stretch.z};
}

void takeLogarithmsOfLanes(double values[8]) {
  for (int l = 0; l < 8; l++) values[l] = std::log(values[l]);
}

void respondGroup(const ElasticLaw& law, const LawGroup& g) {
  if (law.kernels.lanes) return law.kernels.lanes(g);
  for (int l = 0; l < 8; l++) {
    const LawResponse r = law.response(laneMatrix(g.gradient, l), g.lambda[l], g.mu[l], g.values);
    setLaneMatrix(r.stress, g.stress, l);
    if (g.energy) g.energy[l] = r.energy;
  }
}

}  // namespace thaw
