// SPDX-License-Identifier: Apache-2.0
#include "core/surface/advection/gather_particles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/materials/rest_density.hpp"
#include "core/particles/elastic_pieces.hpp"
#include "core/surface/data/sampled_bodies.hpp"

namespace thaw {
namespace {

/// Returns the current volume of a solid particle over its volume at rest: det F. An impact compresses a
/// whole body, and volume enforcement must not inflate its few molten parts to compensate. Only bodies that
/// are solid at the start count, because frozen layers are too thin for a reliable det F. The result is
/// clamped, because torn neighbourhoods give extreme values.
double deformedVolumeRatio(const SurfaceView& w, std::size_t i) {
  constexpr double least = 0.5, most = 2;
  const Continuum& p = w.particles;
  if (!w.modules.solid || w.clock.step == 0 || !isSampled(w.scene, p.body[i]) || !takesSubsteps(p, i))
    return 1;
  return std::clamp(determinant(w.solids.deformation[p.solidIndex[i]]), least, most);
}

}  // namespace

// A ball with R/dx = 5 that is sampled from its shape encloses 5 % less than the volume of its particles.
// Melt of meshes keeps the mesh's volume.
void resetMeltedShares(const Scene& scene, Continuum& p) {
  for (std::size_t i = 0; p.surfaceVolumeRatio.active && i < p.owned; i++)
    if (p.surfaceVolumeRatio[i] > 0 && (p.liquid.active ? p.liquid[i] >= 1 : p.phase[i] == Liquid) &&
        !hasMesh(scene, p.body[i]))
      p.surfaceVolumeRatio[i] = 1;
}

void gatherParticles(const SurfaceView& w, int rank) {
  const Continuum& p = w.particles;
  SurfaceParticles& c = w.surface.particles;
  c.resize(c.owned, 0);
  c.resize(p.owned, 0);
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool fresh = p.component[i] == noComponent;
    Vec3d u = fresh ? Vec3d{} : p.position[i] - p.surfacePosition[i];
    for (int a = 0; a < 3; a++)
      if (w.grid.periodic[a]) u[a] -= w.grid.period[a] * std::nearbyint(u[a] / w.grid.period[a]);
    c.id[i] = p.id[i];
    c.position[i] = fresh ? p.position[i] : p.surfacePosition[i];
    c.displacement[i] = u;
    c.component[i] = p.component[i];
    c.mass[i] = p.mass[i];
    c.volumeRatio[i] = p.surfaceVolumeRatio.active && p.surfaceVolumeRatio[i] > 0 ? p.surfaceVolumeRatio[i]
                                                                                  : 1;
    if (p.surfaceVolumeRatio.active) c.volumeRatio[i] *= deformedVolumeRatio(w, i);
    c.volume[i] = restVolumeOf(p, w.scene.materials, i);
    if (c.fill.active) c.fill[i] = p.initialFill[i];
    if (c.liquid.active)
      c.liquid[i] = p.liquid.active ? p.liquid[i] : static_cast<float>(p.phase[i] == Liquid);
    if (c.temperature.active) c.temperature[i] = static_cast<float>(p.temperature[i]);
    if (c.referencePosition.active) c.referencePosition[i] = p.surfaceStartPosition[i];
    if (c.covered.active)
      c.covered[i] = touchesAsPiece(p, i) ? !p.exposed[i]
                                          : p.solidIndex[i] != noSolid && !w.solids.exposed[p.solidIndex[i]];
    c.body[i] = p.body[i];
    c.source[i] = static_cast<std::uint64_t>(rank) << 32 | i;
  }
}

void fadeFill(SurfaceParticles& p) {
  constexpr double lasts = 0.3;
  if (!p.fill.active || !p.liquid.active) return;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (!(p.fill[i] > 0) || !(p.liquid[i] > 0)) continue;
    double strain2 = 0;
    for (std::size_t a = 0; a < 3; a++)
      for (std::size_t b = 0; b < 3; b++) {
        const double e = 0.5 * (p.gradient[i].row[a][static_cast<int>(b)] +
                                p.gradient[i].row[b][static_cast<int>(a)]);
        strain2 += e * e;
      }
    p.fill[i] = static_cast<float>(
        1 + (static_cast<double>(p.fill[i]) - 1) *
                std::exp(-static_cast<double>(p.liquid[i]) * std::sqrt(strain2) / lasts));
  }
}

void returnParticles(Continuum& p, Solids& solids, Surface& surface, SurfaceHalos halos) {
  SurfaceParticles& c = surface.particles;
  halos.scatter.scatterBack({c.source.data(), c.owned}, {c.component.data(), c.owned},
                            {p.component.data(), p.owned});
  if (c.covered.active) {
    std::vector<std::uint64_t> there(c.covered.data(), c.covered.data() + c.owned), here(p.owned);
    halos.scatter.scatterBack({c.source.data(), c.owned}, there, here);
    for (std::size_t i = 0; i < p.owned; i++) {
      if (here[i] != 0) continue;
      if (touchesAsPiece(p, i)) p.exposed[i] = 1;
      else if (p.solidIndex[i] != noSolid) solids.exposed[p.solidIndex[i]] = 1;
    }
  }
  if (c.fill.active) {
    std::vector<std::uint64_t> there(c.owned), here(p.owned);
    for (std::size_t i = 0; i < c.owned; i++) there[i] = std::bit_cast<std::uint32_t>(c.fill[i]);
    halos.scatter.scatterBack({c.source.data(), c.owned}, there, here);
    for (std::size_t i = 0; i < p.owned; i++)
      p.initialFill[i] = std::bit_cast<float>(static_cast<std::uint32_t>(here[i]));
  }
  for (std::size_t i = 0; i < p.owned; i++) p.surfacePosition[i] = p.position[i];
  c.resize(c.owned, 0);
  c.resize(0, 0);
}

}  // namespace thaw
