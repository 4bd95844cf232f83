// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/surface/row.hpp"

#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {

void printHead(FILE* out) {
  std::fprintf(out,
               "case,particles,surfels,particle_neighbours,surfel_neighbours,isa,k_surfels_per_s,target_k_"
               "surfels_per_s,ns_surfel_sums,ns_particle_sums,ns_move,ns_exchange,ms_search,"
               "update_s,update_s_target,ms_displace,ms_fields,ms_colours,ms_place,searches,iterations,"
               "update_s_worst,start_s,percent_to_local_stop,ms_components,ms_growth,ms_resampling,ms_"
               "iterations,ms_measures,hausdorff_percent,normal_mean,normal_max\n");
}

void print(FILE* out, const SurfaceRow& r) {
  const auto figure = [&](double v, const char* form) {
    v != 0 ? std::fprintf(out, form, v) : 0, std::fputc(',', out);
  };
  std::fprintf(out, "%s,%.0f,%.0f,", r.name.c_str(), r.particles, r.surfels);
  figure(r.aroundParticles, "%.1f");
  figure(r.aroundSurfels, "%.1f");
  std::fprintf(out, "%s,", surfaceKernels()->name);
  figure(r.rate / 1e3, "%.0f");
  figure(r.targetRate / 1e3, "%.0f");
  for (double v : {r.surfelSums, r.particleSums, r.finish, r.exchange}) figure(v, "%.1f");
  figure(r.searchMs, "%.1f");
  figure(r.updateS, "%.3f");
  figure(r.targetS, "%.3f");
  for (double v : {r.displaceMs, r.fieldsMs, r.readyMs, r.placeMs}) figure(v, "%.1f");
  figure(r.searches, "%.0f");
  figure(r.iterations, "%.1f");
  figure(r.worstS, "%.3f");
  figure(r.startS, "%.2f");
  figure(100 * r.finished, "%.0f");
  for (double v : {r.componentsMs, r.growthMs, r.resamplingMs, r.iterationsMs, r.measuresMs})
    figure(v, "%.1f");
  figure(r.hausdorff, "%.3f");
  figure(r.normalMean, "%.2f");
  if (r.normalMax != 0) std::fprintf(out, "%.2f", r.normalMax);
  std::fprintf(out, "\n");
  std::fflush(out);
}

void fillPhases(SurfaceRow& r, const RelaxTimes& t) {
  const double n = static_cast<double>(t.surfels);
  r.surfelSums = 1e9 * t.surfelSums / n;
  r.particleSums = 1e9 * t.particleSums / n;
  r.finish = 1e9 * t.finish / n;
  r.exchange = 1e9 * t.exchange / n;
  r.rate = n / (t.surfelSums + t.particleSums + t.finish + t.exchange);
}

}  // namespace thaw
