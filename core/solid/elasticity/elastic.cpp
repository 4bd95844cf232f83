// SPDX-License-Identifier: Apache-2.0
// Preparation of the bond loops (elastic_isa.cpp), and scalar parts of the loops.
#include "core/solid/elasticity/elastic.hpp"

#include <cmath>

#include "core/solid/elasticity/elastic_kernels.hpp"
#include "core/solid/elasticity/elastic_records.hpp"
#include "core/solid/elasticity/rereference.hpp"
#include "core/solid/elasticity/solid_state.hpp"
#include "core/solid/laws/lane_matrix.hpp"
#include "core/solid/laws/plasticity.hpp"
#include "core/solid/laws/response.hpp"

namespace thaw {

namespace {

ElasticArrays arraysOf(ElasticWork& work, Solids& solids, const Bonds& bonds, const ElasticStep& step,
                       SolidPart part) {
  ElasticArrays a;
  const bool single = work.precision == Precision::Single;
  const std::vector<std::uint32_t>& groups = part == SolidPart::Inner
                                                 ? (work.sleeping ? work.innerAwake : work.inner)
                                                 : (work.sleeping ? work.boundaryAwake : work.boundary);
  a.precision = work.precision;
  a.vectors = bonds.vectors;
  a.periodic = work.periodic;
  a.damping = work.damping;
  a.plastic = work.plastic;
  a.energy = step.energy;
  a.owned = solids.owned;
  a.capacity = static_cast<std::size_t>(bonds.capacity);
  a.groups = groups.data();
  a.groupCount = groups.size();
  a.bondCount = work.bondCount.data();
  a.singularLanes = work.singularLanes.data();
  a.ownFrames = work.ownFrames.data();
  a.neighbour = bonds.neighbour.data();
  const auto pick = [&](const AlignedVector<float>& f, const AlignedVector<double>& d) {
    return single ? static_cast<const void*>(f.data()) : d.data();
  };
  a.x = bonds.x.data();
  a.y = bonds.y.data();
  a.z = bonds.z.data();
  a.rx = bonds.rx.data();
  a.ry = bonds.ry.data();
  a.rz = bonds.rz.data();
  a.weight = bonds.weight.data();
  a.end = single ? static_cast<void*>(solids.end.data()) : solids.endDouble.data();
  a.motion = pick(work.velocityDrag, work.velocityDragDouble);
  a.unit = work.support / fixedUnitsPerSupport;
  a.perSupport2 = 1 / (work.support * work.support);
  for (int k = 0; k < 3; k++) a.period[k] = single ? work.periods.length[k] / a.unit : work.periods.length[k];
  a.dt = step.dt;
  if (work.minBreakStretch < never) {
    // The limit is slightly lower, since lengths in the loop are rounded to float. fracture.cpp decides in
    // double precision.
    a.breakStretch2 = 0.9999 * work.minBreakStretch * work.minBreakStretch;
    a.stretched = work.stretched.data();
  }
  if (work.sleeping && work.groupStretch2.empty()) a.passive = work.plasticFixed.data();  // active_solids.hpp
  else if (work.sleeping)
    a.plasticFixed = work.plasticFixed.data(), a.groupStretch2 = work.groupStretch2.data();
  a.momentInverse = solids.momentInverse.data();
  a.rank = work.rank.data();
  a.perTrace = work.perTrace.data();
  a.perWeight = work.perWeight.data();
  a.volume = solids.volume.data();
  a.plasticInverse = work.plastic ? solids.plasticInverse.data() : nullptr;
  a.lastGradient = solids.lastGradient.active ? solids.lastGradient.data() : nullptr;
  a.referenceGradient = solids.referenceGradient.active ? solids.referenceGradient.data() : nullptr;
  a.plasticPath = solids.plasticPath.active ? solids.plasticPath.data() : nullptr;
  a.flows = solids.rereferenced.active ? work.flows.data() : nullptr;
  a.deformation = step.deformation ? solids.deformation.data() : nullptr;
  a.energyColumn = solids.energy.data();
  a.dragColumn = solids.drag.active ? solids.drag.data() : nullptr;
  a.dissipated = solids.dissipated.active ? solids.dissipated.data() : nullptr;
  a.force = solids.force.data();
  a.work = &work;
  a.solids = &solids;
  return a;
}

const ElasticKernels& kernelsOf(const ElasticWork& work) {
  return work.kernels ? *work.kernels : *elasticKernels();
}

/// Returns the bond loop of a group: the extension's loop if all its solids share that law, else the
/// library's. Requires: lawLoops by material.
LawLoop loopOf(const ElasticWork& work, const Solids& solids, std::size_t group) {
  const std::size_t first = group * lanes, last = std::min<std::size_t>(first + lanes, solids.owned);
  const LawLoop loop = work.lawLoops[solids.material[first]];
  for (std::size_t s = first + 1; s < last; s++)
    if (work.lawLoops[solids.material[s]] != loop) return kernelsOf(work).deformation;
  return loop ? loop : kernelsOf(work).deformation;
}

/// Runs the loop over bonds that computes deformation and stress, for the groups of the arrays.
void deform(const ElasticWork& work, const Solids& solids, ElasticArrays& a) {
  if (work.lawLoops.empty()) return kernelsOf(work).deformation(a);
  if (work.lawLoops.size() == 1) return work.lawLoops[0](a);
  const std::span<const std::uint32_t> groups{a.groups, a.groupCount};
  for (std::size_t begin = 0, end = 1; begin < groups.size(); begin = end++) {
    const LawLoop loop = loopOf(work, solids, groups[begin]);
    while (end < groups.size() && loopOf(work, solids, groups[end]) == loop) end++;
    a.groups = groups.data() + begin;
    a.groupCount = end - begin;
    loop(a);
  }
}

/// Lists the distinct laws of a group with their lanes.
void listLaws(LaneConstants& c) {
  c.laws = 0;
  for (int l = 0; l < 8; l++) {
    int k = 0;
    while (k < c.laws && c.law[k] != c.constants[l].law) k++;
    if (k == c.laws) c.law[c.laws] = c.constants[l].law, c.lanesOf[c.laws++] = 0;
    c.lanesOf[k] |= 1u << l;
  }
}

}  // namespace

void loadLaneConstants(const ElasticArrays& a, std::size_t solid0, int n, LaneConstants& out) {
  const Solids& solids = *a.solids;
  // Most groups have a single material, that of the previous group.
  bool same = n == 8 && out.material >= 0;
  for (int l = 0; same && l < 8; l++) {
    const std::size_t s = solid0 + static_cast<std::size_t>(l);
    same = solids.material[s] == out.material && !(solids.liquid.active && solids.liquid[s] > 0);
  }
  if (!same) {
    out.anyVolumeStiffness = out.anyHourglassYield = false;
    out.material = solids.material[solid0];
    for (int l = 0; l < 8; l++) {
      const std::size_t s = solid0 + static_cast<std::size_t>(l);
      if (l >= n) {
        out.lambda[l] = out.mu[l] = out.volumeStiffness[l] = 0;
        out.constants[l] = {};
        out.constants[l].law = out.constants[0].law;
        out.material = -1;
        continue;
      }
      const ElasticConstants c = constantsOfSolid(*a.work, solids, s);
      if (solids.material[s] != out.material || (solids.liquid.active && solids.liquid[s] > 0))
        out.material = -1;
      out.constants[l] = c;
      out.lambda[l] = c.lambda;
      out.mu[l] = c.mu;
      out.volumeStiffness[l] = c.volume;
      out.anyVolumeStiffness = out.anyVolumeStiffness || c.volume > 0;
      out.anyHourglassYield = out.anyHourglassYield || c.hourglassYield < never;
    }
    listLaws(out);
  }
  for (int l = 0; l < 8; l++) {
    const std::size_t s = solid0 + static_cast<std::size_t>(l < n ? l : 0);
    const ElasticConstants& c = out.constants[l];
    const bool active = l < n && !(a.passive && a.passive[s]);
    out.active[l] = active;
    out.volume[l] = active ? a.volume[s] : 0;
    out.hourglass[l] = c.hourglass * out.volume[l] * a.perTrace[s];
    // A bond's damping is the mean of both ends, hence 0.5. A bond acts along its direction
    // only, hence the factor 3.
    out.drag[l] = 0.5 * 3 * c.dragDensity * out.volume[l] * a.perWeight[s];
    if (l < n && a.dissipated && !a.keepDissipated) a.dissipated[s] = 0;
  }
}

void completeLane(const ElasticArrays& a, std::size_t solidIndex, int lane, double gradU[9][8]) {
  const Mat3d g = completeGradient(laneMatrix(gradU, lane), a.momentInverse[solidIndex], a.rank[solidIndex]);
  setLaneMatrix(g, gradU, lane);
}

void addNormalStress(const ElasticArrays& a, const LaneConstants& c, std::size_t solidIndex, int lane,
                     const FlatLane& of) {
  if (a.rank[solidIndex] != 2 || !(a.perTrace[solidIndex] > 0)) return;
  const Mat3d more = stressOfNormal({laneMatrix(of.gradU, lane), a.momentInverse[solidIndex],
                                     1 / a.perTrace[solidIndex], laneMatrix(of.sum, lane),
                                     c.volume[lane] * laneMatrix(of.stress, lane), c.hourglass[lane]}) *
                     full(a.momentInverse[solidIndex]);
  for (int r = 0; r < 3; r++)
    for (int q = 0; q < 3; q++) of.flux[3 * r + q][lane] += more.row[r][q];
}

void yieldHourglass(const ElasticArrays& a, std::size_t solidIndex, int lane, LaneConstants& c,
                    double (&errors)[8]) {
  const double stiffness = c.constants[lane].hourglass, limit = c.constants[lane].hourglassYield,
               error = std::sqrt(errors[lane] * a.perTrace[solidIndex]);
  errors[lane] = 0;
  if (!(error > limit)) return;
  c.hourglass[lane] *= limit / error;
  errors[lane] = 0.5 * stiffness * limit * (error - limit);
}

namespace {

/// Returns the work (Pa) dissipated by a plastic flow that ends with F - 1 = g.
double lossOf(const ElasticArrays& a, const ElasticConstants& c, std::size_t solidIndex, const Mat3d& g,
              const PlasticFlow& flow) {
  if (!a.lastGradient) return flow.loss;
  const Mat3d& last = a.lastGradient[solidIndex];
  const bool known = determinant(identity3<double>() + last) > 0;
  return workOfFlow(c, {known ? last : g, a.plasticInverse[solidIndex]}, {g, flow.state.inverse});
}

}  // namespace

void flowLane(const ElasticArrays& a, const ElasticConstants& c, std::size_t solidIndex,
              const double gradU[9][8], int lane, PlasticLanes& out) {
  Mat3d& inverse = a.plasticInverse[solidIndex];
  const Mat3d g = laneMatrix(gradU, lane);
  const bool passive = a.passive && a.passive[solidIndex],
             plasticFixed = passive || (a.plasticFixed && a.plasticFixed[solidIndex]);
  PlasticFlow flow{{inverse, a.plasticPath ? a.plasticPath[solidIndex] : 0}, {}, 0, false};
  if (a.flow && c.yield < never && !plasticFixed) {
    flow = plasticFlow(c, g, flow.state, a.referenceGradient ? a.referenceGradient[solidIndex] : Mat3d{},
                       a.dt);
    if (flow.flows) {
      a.dissipated[solidIndex] += a.volume[solidIndex] * lossOf(a, c, solidIndex, g, flow);
      inverse = flow.state.inverse;
      if (a.plasticPath) a.plasticPath[solidIndex] = flow.state.path;
    }
  } else {
    flow.elastic = elasticGradient(g, inverse);
  }
  if (a.lastGradient && !passive) a.lastGradient[solidIndex] = g;
  if (a.flows && a.flow) a.flows[solidIndex] = flow.flows;
  setLaneMatrix(flow.elastic, out.elastic, lane);
  setLaneMatrix(inverse, out.inverse, lane);
}

ElasticResult computeDeformationAndStress(ElasticWork& work, Solids& solids, const Bonds& bonds,
                                          const ElasticStep& step, SolidPart part) {
  if (part == SolidPart::Inner)
    forEachAwake(work, solids,
                 [&](std::size_t first, std::size_t last) { packPositions(work, solids, first, last); });
  else packPositions(work, solids, solids.owned, solids.size());
  ElasticArrays a = arraysOf(work, solids, bonds, step, part);
  deform(work, solids, a);
  return {a.inverted, a.softenedParticles, a.maxStretch2};
}

void repeatDeformation(ElasticWork& work, Solids& solids, const Bonds& bonds, const ElasticStep& step,
                       std::span<const std::uint32_t> groups) {
  ElasticArrays a = arraysOf(work, solids, bonds, step, SolidPart::Boundary);
  a.groups = groups.data();
  a.groupCount = groups.size();
  a.dt = 0;
  a.keepDissipated = true;
  a.flow = false;
  deform(work, solids, a);
}

void computeElasticForces(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                          SolidPart part) {
  if (part == SolidPart::Boundary) copyRemoteReferences(work, solids, bonds);
  if (part == SolidPart::Inner) packVelocityDrag(work, solids, 0, solids.owned);
  else packVelocityDrag(work, solids, solids.owned, solids.size());
  kernelsOf(work).forces(arraysOf(work, solids, bonds, step, part));
}

void computeCauchyStress(const ElasticWork& work, Solids& solids) {
  solids.activate(solids.stress);
  for (std::size_t s = 0; s < solids.owned; s++) {
    const Mat3d gradU = solids.deformation[s] - identity3<double>();
    const Mat3d elastic = work.plastic ? elasticGradient(gradU, solids.plasticInverse[s]) : gradU;
    solids.stress[s] = cauchyStress(elasticResponse(constantsOfSolid(work, solids, s), elastic).stress,
                                    elastic);
  }
}

}  // namespace thaw
