// SPDX-License-Identifier: Apache-2.0
// A row of the surface benchmark's table.
#pragma once
#include <cstdio>
#include <string>

#include "core/surface/work/relax_tools.hpp"

namespace thaw {

/// Figures that a case does not have are 0 here and empty in the table.
struct SurfaceRow {
  std::string name;
  double particles = 0, surfels = 0, aroundParticles = 0, aroundSurfels = 0;
  double rate = 0, targetRate = 0, surfelSums = 0, particleSums = 0, finish = 0, exchange = 0;
  double placeMs = 0, searches = 0, searchMs = 0, updateS = 0, targetS = 0, displaceMs = 0, fieldsMs = 0,
         readyMs = 0;
  double worstS = 0, startS = 0, finished = 0, resamplingMs = 0, componentsMs = 0, growthMs = 0,
         measuresMs = 0, iterationsMs = 0;
  double iterations = 0, hausdorff = 0, normalMean = 0, normalMax = 0;
};

void printHead(FILE* out);
void print(FILE* out, const SurfaceRow& row);

/// Sets ns per surfel and iteration, by phase, and surfels per second.
void fillPhases(SurfaceRow& row, const RelaxTimes& times);

}  // namespace thaw
