// Density that the flow carries along, and how crowded a place is. One term of the pair sums (term.hpp).
#pragma once
#include "core/fluid/liquid_materials.hpp"
#include "core/fluid/terms/term.hpp"

namespace thaw {
namespace THAW_ISA {
namespace {

/// Filling by places as Density has it, h times its gradient (for shifting) and, if Carried, the rate of the filling: sum V0_j (u_i - u_j).grad W,
/// whose adjoint is the pressure force of Forces, so that pairs keep energy (Bonet & Lok 1999); and diffusion of it (Molteni & Colagrossi
/// 2009 eq. 11) of what is not the weight of the liquid (Fourtakas 2019 eq. 10). The rate is the mean of those with the gradients at the two ends of the step,
/// from each of which its pressure has its force: so the work of pressure is what the energy of compression loses. Gradients of the end alone give the flow
/// a power of dt/2 int |grad p|^2 / rho.
/// Surfaces: also what free surfaces are found by, |grad W| and the direction away from neighbours that are marked as being at one.
enum class Carry { Nothing, Density, Corrected };

template<class Real, class Kernel, Carry carry, bool Surfaces = false> struct CarriedDensity {
  using L = Lanes<Real>;
  static constexpr bool Carried = carry != Carry::Nothing, Corrected = carry == Carry::Corrected;
  const Record<Real>*place, *motion, *state;
  const PairSums* in;
  double scale;
  L weight[3];  ///< h g
  L ago;        ///< s/m, the step that led here over h
  struct Data { Lanes4<Real> place, motion, state; };
  struct Sum { L size = L(0.0), nx = L(0.0), ny = L(0.0), nz = L(0.0), filling = L(0.0), closest = L(1.0), x = L(0.0), y = L(0.0), z = L(0.0), rate = L(0.0), spread = L(0.0), column = L(0.0), moment[6] = {L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0)}, flow[9] = {L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0)}, begun[9] = {L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0), L(0.0)}; };
  THAW_INLINE Data load(const std::uint32_t* entries) const {
    if constexpr (Carried) return {loadListed(place, entries), loadListed(motion, entries), loadListed(state, entries)};
    else return {loadListed(place, entries), {}, {}};
  }
  /// Of a vector with another one, a row for each component of the first.
  static THAW_INLINE void addProducts(L* to, L x, L y, L z, L ux, L uy, L uz) {
    to[0] += x * ux;
    to[1] += x * uy;
    to[2] += x * uz;
    to[3] += y * ux;
    to[4] += y * uy;
    to[5] += y * uz;
    to[6] += z * ux;
    to[7] += z * uy;
    to[8] += z * uz;
  }
  THAW_INLINE void pair(const Data& i, const Data& j, const std::uint32_t*, Sum& s) const {
    const L dx = positionDifference(i.place.a, j.place.a), dy = positionDifference(i.place.b, j.place.b), dz = positionDifference(i.place.c, j.place.c);
    const L q2 = dx * dx + dy * dy + dz * dz, V = j.place.d;
    s.filling += V * Kernel::w(q2);
    s.closest = select(V > L(0.0), min(s.closest, q2), s.closest);
    const L g = V * Kernel::slope(q2);
    s.x += g * dx;
    s.y += g * dy;
    s.z += g * dz;
    if constexpr (Carried) {
      if constexpr (Surfaces) {
        s.size -= g * sqrt(q2);
        const L marked = select(j.state.b < L(0.0), g, L(0.0));
        s.nx -= marked * dx;
        s.ny -= marked * dy;
        s.nz -= marked * dz;
      }
      const L ux = i.motion.a - j.motion.a, uy = i.motion.b - j.motion.b, uz = i.motion.c - j.motion.c;
      if constexpr (Corrected) {
        const L gx = g * dx, gy = g * dy, gz = g * dz;
        s.moment[0] -= gx * dx;
        s.moment[1] -= gy * dy;
        s.moment[2] -= gz * dz;
        s.moment[3] -= gx * dy;
        s.moment[4] -= gx * dz;
        s.moment[5] -= gy * dz;
        addProducts(s.flow, gx, gy, gz, ux, uy, uz);
      } else {
        s.rate += g * (ux * dx + uy * dy + uz * dz);
      }
      const L ox = dx - ago * ux, oy = dy - ago * uy, oz = dz - ago * uz, b = V * Kernel::slope(ox * ox + oy * oy + oz * oz);
      if constexpr (Corrected) {
        addProducts(s.begun, b * ox, b * oy, b * oz, ux, uy, uz);
      } else {
        s.begun[0] += b * (ux * ox + uy * oy + uz * oz);
      }
      L both = V * Kernel::laplace(q2) * i.state.b * j.state.b;
      if constexpr (Surfaces) both = max(both, -both);
      s.spread += both * (j.state.a - i.state.a);
      s.column += both * (weight[0] * dx + weight[1] * dy + weight[2] * dz);
    }
  }
  THAW_INLINE void finish(const std::uint32_t* rows, const Data& i, const Sum& s, std::uint32_t dummy) const {
    const L total = s.filling + i.place.d * Kernel::w(L(0.0));
    const bool touching = any(s.closest < L(1e-20));
    const double h = in->support;
    for (int l = 0; l < 8; l++)
      if (rows[l] != dummy) {
        const std::uint32_t row = rows[l];
        in->filling[row] = static_cast<float>(scale * static_cast<double>(total[l]) - in->selfExcess * static_cast<double>(i.place.d[l]));
        if (touching && s.closest[l] < Real(1e-20)) ++*in->coincident;
        if (in->crowding) in->crowding[row] = {scale * static_cast<double>(s.x[l]), scale * static_cast<double>(s.y[l]), scale * static_cast<double>(s.z[l])};
        if constexpr (Carried) {
          if constexpr (Surfaces) {
            in->surfaceNormal[row] = {static_cast<double>(s.nx[l]), static_cast<double>(s.ny[l]), static_cast<double>(s.nz[l])};
            in->gradientSize[row] = static_cast<float>(scale * static_cast<double>(s.size[l]));
          }
          const auto of = [&](const L& a) { return static_cast<double>(a[l]); };
          if constexpr (Corrected) {
            const L *m = s.moment, *u = s.flow;
            in->moment[row] = {{{scale * of(m[0]), scale * of(m[3]), scale * of(m[4])}, {scale * of(m[3]), scale * of(m[1]), scale * of(m[5])}, {scale * of(m[4]), scale * of(m[5]), scale * of(m[2])}}};
            const double k = scale / h;
            in->flow[row] = {{{k * of(u[0]), k * of(u[1]), k * of(u[2])}, {k * of(u[3]), k * of(u[4]), k * of(u[5])}, {k * of(u[6]), k * of(u[7]), k * of(u[8])}}};
            double begun = 0;  // the other half is the end's, of which correct knows the correction
            for (int a = 0; a < 3; a++)
              for (int b = 0; b < 3; b++) begun += ((a == b ? 1 : 0) + in->correction[row].row[a][b]) * of(s.begun[3 * a + b]);
            in->densityRate[row] = 0.5 * k * begun;
          } else {
            in->densityRate[row] = 0.5 * scale / h * (of(s.rate) + of(s.begun[0]));
          }
          const double c = in->liquids[in->material[row]].soundSpeed;
          in->spreading[row] = in->diffusion * 0.5 * c / h * (static_cast<double>(s.spread[l]) + static_cast<double>(s.column[l]) / (c * c));
        }
      }
  }
};

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
