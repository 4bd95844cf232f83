// SPDX-License-Identifier: Apache-2.0
#include "io/frames/frame_fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/fluid/flow_laws/particle_viscosity.hpp"
#include "core/fluid/laws/particle_pressure.hpp"
#include "core/materials/rest_density.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "io/frames/frame_rows.hpp"

namespace thaw {
namespace {

void put6(const Sym3d& s, float* to) {
  const double v[6] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.xz};
  for (int k = 0; k < 6; k++) to[k] = static_cast<float>(v[k]);
}

/// Returns the number of bonds of a solid.
std::uint16_t bondsOf(const Bonds& b, std::uint32_t solidIndex) {
  std::uint16_t count = 0;
  for (int k = 0; k < b.capacity; k++) count = static_cast<std::uint16_t>(count + b.hasBond(solidIndex, k));
  return count;
}

std::uint32_t solidIndexOf(const Continuum& particles, const Solids& solids, std::size_t row) {
  if (!particles.solidIndex.active) return noSolid;
  const std::uint32_t solidIndex = particles.solidIndex[row];
  return solidIndex < solids.owned ? solidIndex : noSolid;
}

/// Adds a symmetric tensor of the solids: value(solid), 0 for liquids and if `there` is false.
template<class Value>
void addTensor(Frame& f, const World& w, const char* name, const char* unit, bool there, Value value) {
  addRows<float>(f, name, unit, 6, [&w, there, value](std::size_t i, float* to) {
    const std::uint32_t solidIndex = there ? solidIndexOf(w.particles, w.solids, i) : noSolid;
    put6(solidIndex == noSolid ? Sym3d{} : value(solidIndex), to);
  });
}

/// Adds Green's strain (F^T F - 1)/2, with F from the first reference.
void addStrain(Frame& f, const World& w) {
  const Solids& s = w.solids;
  addTensor(f, w, "strain", "1", s.deformation.active, [&s](std::uint32_t solidIndex) {
    Mat3d F = s.deformation[solidIndex];
    if (s.referenceGradient.active) F = F + F * s.referenceGradient[solidIndex];
    return 0.5 * symmetric(transpose(F) * F - identity3<double>());
  });
}

/// Returns the temperature of the body or emitter at the start, for scenes without heat.
double temperatureAtStart(const Scene& s, std::size_t body) {
  if (body < s.bodies.size()) return s.bodies[body].temperature;
  return body - s.bodies.size() < s.emitters.size() ? s.emitters[body - s.bodies.size()].temperature
                                                    : s.domain.ambient;
}

void addViscosity(Frame& f, const Continuum& p, const std::vector<Material>& materials) {
  addRows<float>(f, "viscosity", "Pa s", 1, [&p, &materials](std::size_t i, float* to) {
    *to = static_cast<float>(viscosityOfParticle(materials[p.material[i]], p, i, liquidFraction(p, i)));
  });
}

/// Adds a field of an extension.
void addExtensionField(Frame& f, const AddedColumn& column) {
  addRows<float>(f, column.name, column.unit, column.components, [&column](std::size_t i, float* to) {
    for (int k = 0; k < column.components; k++) to[k] = static_cast<float>(column.row(i)[k]);
  });
  f.fields.back().meaning = column.about;
}

/// Adds a field of heat. Returns false for other names.
bool addHeatField(Frame& f, const World& w, const std::string& name) {
  const Continuum& p = w.particles;
  if (name == "temperature") {
    addRows<float>(f, "temperature", "K", 1, [&w, &p](std::size_t i, float* to) {
      *to = static_cast<float>(p.temperature.active ? p.temperature[i]
                                                    : temperatureAtStart(w.scene, p.body[i]));
    });
  } else if (name == "absorbed") {
    addRows<float>(f, "absorbed", "W", 1,
                   [&p](std::size_t i, float* to) { *to = p.absorbed.active ? p.absorbed[i] : 0; });
  } else {
    return false;
  }
  return true;
}

void addField(Frame& f, const World& w, int rank, const std::string& name) {
  const Continuum& p = w.particles;
  const Solids& s = w.solids;
  const std::vector<Material>& materials = w.scene.materials;
  if (addHeatField(f, w, name)) return;
  if (name == "velocity") {
    addRows<float>(f, "velocity", "m/s", 3, [&p](std::size_t i, float* to) { put3(p.velocity[i], to); });
  } else if (name == "liquid") {
    addRows<float>(f, "liquid", "1", 1, [&p, &materials](std::size_t i, float* to) {
      const Material& m = materials[p.material[i]];
      *to = p.liquid.active  ? p.liquid[i]
            : p.phase.active ? static_cast<float>(p.phase[i] == Liquid)
                             : static_cast<float>(!m.canBeSolid() || m.liquidAtStart);
    });
  } else if (name == "density") {
    // Only liquid has a summed density. The density of a solid follows from its volume, V = det Fe V0.
    addRows<float>(f, "density", "kg/m^3", 1, [&w, &p, &s, &materials](std::size_t i, float* to) {
      const std::uint32_t solidIndex = solidIndexOf(w.particles, w.solids, i);
      double share = 1;
      if (solidIndex != noSolid && s.deformation.active) {
        const Mat3d& F = s.deformation[solidIndex];
        share = 1 / determinant(s.plasticInverse.active ? F + F * s.plasticInverse[solidIndex] : F);
      } else if (p.relativeDensity.active && (!p.phase.active || p.phase[i] == Liquid))
        share = static_cast<double>(p.relativeDensity[i]);
      *to = static_cast<float>(restDensityOf(p, materials, i) * share);
    });
  } else if (name == "volume") {
    addRows<float>(f, "volume", "m^3", 1, [&p, &materials](std::size_t i, float* to) {
      *to = static_cast<float>(restVolumeOf(p, materials, i));
    });
  } else if (name == "pressure") {
    addRows<float>(
        f, "pressure", "Pa", 1, [&w, liquids = liquidMaterials(w.scene)](std::size_t i, float* to) {
          *to = w.modules.fluid ? pressureOfParticle(w.scene, w.modules, w.particles, liquids, i) : 0;
        });
  } else if (name == "viscosity") {
    addViscosity(f, p, materials);
  } else if (name == "stress") {
    addTensor(f, w, "stress", "Pa", s.stress.active,
              [&s](std::uint32_t solidIndex) { return s.stress[solidIndex]; });
  } else if (name == "strain") {
    addStrain(f, w);
  } else if (name == "plastic_strain") {
    addTensor(f, w, "plastic_strain", "1", s.plasticInverse.active, [&s](std::uint32_t solidIndex) {
      return plasticStrain(s.plasticInverse[solidIndex],
                           s.referenceGradient.active ? s.referenceGradient[solidIndex] : Mat3d{});
    });
  } else if (name == "material") {
    addRows<std::uint16_t>(f, "material", "1", 1,
                           [&p](std::size_t i, std::uint16_t* to) { *to = p.material[i]; });
  } else if (name == "body") {
    addRows<std::uint16_t>(f, "body", "1", 1, [&p](std::size_t i, std::uint16_t* to) { *to = p.body[i]; });
  } else if (name == "rank") {
    addRows<std::uint32_t>(f, "rank", "1", 1, [rank](std::size_t, std::uint32_t* to) {
      *to = static_cast<std::uint32_t>(rank);
    });
  } else if (name == "neighbours") {
    // The neighbours of a solid particle are its bonds. Scenes of solids alone have no neighbour search.
    addRows<std::uint16_t>(f, "neighbours", "1", 1, [&w](std::size_t i, std::uint16_t* to) {
      const std::uint32_t solidIndex = solidIndexOf(w.particles, w.solids, i);
      *to = solidIndex == noSolid
                ? (w.modules.neighbours && i < w.neighbours.neighbours.size() ? w.neighbours.neighbours[i]
                                                                              : std::uint16_t(0))
                : bondsOf(w.bonds, solidIndex);
    });
  } else if (name != "id") {
    throw std::invalid_argument("unknown field '" + name + "' of frames");
  }
}

}  // namespace

std::vector<std::string> knownFrameFields() {
  return {"velocity",  "temperature", "liquid",     "density",        "pressure", "volume",
          "viscosity", "stress",      "strain",     "plastic_strain", "material", "body",
          "rank",      "id",          "neighbours", "absorbed"};
}

Frame frameOf(const World& w, int rank) {
  Frame f = startFrame(w.clock, w.particles);
  std::vector<std::string> names = w.scene.output.fields, done;
  if (w.modules.evaporation) names.emplace_back("volume");  // pictures draw shrinking particles by it
  for (const std::string& name : names) {
    if (std::find(done.begin(), done.end(), name) != done.end()) continue;  // listed twice
    if (name == surfaceVelocityField) continue;                             // a field of surfels
    if (const AddedColumn* added = w.particles.addedField(name)) addExtensionField(f, *added);
    else addField(f, w, rank, name);
    done.push_back(name);
  }
  return f;
}

}  // namespace thaw
