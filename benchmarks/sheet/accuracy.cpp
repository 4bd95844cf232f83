// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "benchmarks/sheet/tests.hpp"
#include "core/geometry/builtin/sheet_meshes.hpp"
#include "core/sheet/data/exact_step.hpp"
#include "core/sheet/data/topology.hpp"

namespace thaw::bench {
namespace {

using Values = std::vector<double>;

/// m q'' + c q' + K q = force(q), per unit area; q and v hold all degrees of freedom.
struct System {
  SpringLaw law;
  std::function<void(const Values& q, Values& f)> force;  ///< N/m^2, without the spring to the rest position
  double evaluations = 0;
  void operator()(const Values& q, Values& f) { force(q, f), evaluations++; }
};

struct State {
  Values q, v;
};

void exact(System& s, State& x, double dt, int steps) {
  const ExactStep e = exactStep(s.law, dt);
  const SplitForce p = splitForce(s.law, e, dt);
  Values f(x.q.size());
  s(x.q, f);
  for (int k = 0; k < steps; k++) {
    for (std::size_t i = 0; i < x.q.size(); i++) {
      const double pull = s.law.stiffness * x.q[i], v = x.v[i];
      x.q[i] += e.qv * v + e.qr * (f[i] - pull);
      x.v[i] = e.vv * v + p.before * f[i] - e.vr * pull;
    }
    s(x.q, f);
    for (std::size_t i = 0; i < x.q.size(); i++) x.v[i] += p.after * f[i];
  }
}

void symplecticEuler(System& s, State& x, double dt, int steps) {
  Values f(x.q.size());
  for (int k = 0; k < steps; k++) {
    s(x.q, f);
    for (std::size_t i = 0; i < x.q.size(); i++) {
      x.v[i] += dt / s.law.mass * (f[i] - s.law.stiffness * x.q[i] - s.law.damping * x.v[i]);
      x.q[i] += dt * x.v[i];
    }
  }
}

void rungeKutta4(System& s, State& x, double dt, int steps) {
  const std::size_t n = x.q.size();
  Values f(n), q(n), v(n), dq(n), dv(n);
  for (int k = 0; k < steps; k++) {
    std::fill(dq.begin(), dq.end(), 0.0);
    std::fill(dv.begin(), dv.end(), 0.0);
    q = x.q, v = x.v;
    const double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, reach[4] = {0.5, 0.5, 1, 0};
    for (int stage = 0; stage < 4; stage++) {
      s(q, f);
      for (std::size_t i = 0; i < n; i++) {
        const double a = (f[i] - s.law.stiffness * q[i] - s.law.damping * v[i]) / s.law.mass, u = v[i];
        dq[i] += weight[stage] * u;
        dv[i] += weight[stage] * a;
        q[i] = x.q[i] + reach[stage] * dt * u;
        v[i] = x.v[i] + reach[stage] * dt * a;
      }
    }
    for (std::size_t i = 0; i < n; i++) x.q[i] += dt * dq[i], x.v[i] += dt * dv[i];
  }
}

/// Backward Euler, linearised once a step (BW98). The products of the conjugate gradient
/// method are differences of forces.
void implicitEuler(System& s, State& x, double dt, int steps) {
  const std::size_t n = x.q.size();
  const double m = s.law.mass, c = s.law.damping, K = s.law.stiffness, diagonal = m + dt * c + dt * dt * K;
  Values f(n), g(n), r(n), p(n), u(n), ap(n), moved(n);
  for (int k = 0; k < steps; k++) {
    for (std::size_t i = 0; i < n; i++) moved[i] = x.q[i] + dt * x.v[i];
    s(x.q, f);
    // (diagonal - dt^2 dF/dq) u = m v + dt (F(q + dt v) - K q) + ..., with u the new velocity, starting from
    // the old one
    s(moved, g);
    double rr = 0, first = 0;
    u = x.v;
    for (std::size_t i = 0; i < n; i++) {
      r[i] = m * x.v[i] + dt * (g[i] - K * x.q[i]) - diagonal * u[i];
      first += r[i] * r[i];
    }
    p = r, rr = first;
    for (int iteration = 0; iteration < 50 && rr > 1e-16 * first && rr > 0; iteration++) {
      double size = 0, pap = 0;
      for (const double y : p) size += y * y;
      const double small = 1e-7 / std::sqrt(size / static_cast<double>(n));
      for (std::size_t i = 0; i < n; i++) moved[i] = x.q[i] + dt * u[i] + small * p[i];
      for (std::size_t i = 0; i < n; i++) ap[i] = x.q[i] + dt * u[i] - small * p[i];
      s(moved, g);
      s(ap, f);
      for (std::size_t i = 0; i < n; i++) {
        ap[i] = diagonal * p[i] - dt * dt * (g[i] - f[i]) / (2 * small);
        pap += p[i] * ap[i];
      }
      const double alpha = rr / pap, before = rr;
      rr = 0;
      for (std::size_t i = 0; i < n; i++) {
        u[i] += alpha * p[i];
        r[i] -= alpha * ap[i];
        rr += r[i] * r[i];
      }
      for (std::size_t i = 0; i < n; i++) p[i] = r[i] + rr / before * p[i];
    }
    for (std::size_t i = 0; i < n; i++) x.v[i] = u[i], x.q[i] += dt * u[i];
  }
}

struct Method {
  const char* name;
  void (*run)(System&, State&, double, int);
};
constexpr Method methods[] = {{"exact step", exact},
                              {"symplectic Euler", symplecticEuler},
                              {"RK4", rungeKutta4},
                              {"implicit Euler", implicitEuler}};

/// Root mean square error of the positions, relative to the positions.
double errorOf(const State& x, const State& reference) {
  double e = 0, all = 0;
  for (std::size_t i = 0; i < x.q.size(); i++) {
    e += (x.q[i] - reference.q[i]) * (x.q[i] - reference.q[i]);
    all += reference.q[i] * reference.q[i];
  }
  return std::sqrt(e / all);
}

void compare(const char* what, System& s, const State& start, const State& reference, double end,
             const std::vector<int>& steps, const Out& out) {
  std::printf("\n%s\n%-18s %8s %12s %12s %12s\n", what, "method", "steps", "forces", "seconds", "error");
  for (const Method& m : methods)
    for (const int n : steps) {
      State x = start;
      s.evaluations = 0;
      const auto begin = std::chrono::steady_clock::now();
      m.run(s, x, end / n, n);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                   error = errorOf(x, reference);
      if (!std::isfinite(error) || error > 10) continue;  // unstable
      std::printf("%-18s %8d %12.0f %12.3e %12.3e\n", m.name, n, s.evaluations, seconds, error);
      out.line("accuracy", what, m.name, n, s.evaluations, seconds, error, "1");
    }
}

}  // namespace

void oscillator(const Out& out) {
  System s{{1, 0.4, 40}, [](const Values&, Values& f) { f[0] = 7; }};
  const State start{{0.3}, {-1}};
  const double end = 10 * 2 * std::numbers::pi / std::sqrt(40 - 0.04);
  // closed-form solution
  const double a = 0.2, w = std::sqrt(40 - a * a), q0 = 7.0 / 40, z = start.q[0] - q0,
               b = (start.v[0] + a * z) / w;
  const State reference{{q0 + std::exp(-a * end) * (z * std::cos(w * end) + b * std::sin(w * end))}, {0}};
  compare("oscillator", s, start, reference, end, {1, 4, 16, 64, 256, 1024, 4096, 16384, 65536}, out);
}

void head(const Out& out) {
  const TriangleMesh mesh = headSheet(0.25, 0.012);
  const SheetTopology t = sheetTopology(mesh);
  const std::size_t n = mesh.vertices.size();
  struct Edge {
    std::size_t a, b;
    double length, stiffness;
  };
  std::vector<Edge> edges;
  for (std::uint32_t v = 0; v < n; v++)
    for (std::uint32_t k = t.first[v]; k < t.first[v + 1]; k++)
      if (t.ring[k].to > v) {
        const double l = length(mesh.vertices[t.ring[k].to] - mesh.vertices[v]);
        edges.push_back({v, t.ring[k].to, l, 25 * t.ring[k].area / (l * l)});
      }
  const auto place = [&](const Values& q, std::size_t v) {
    return mesh.vertices[v] + Vec3d{q[3 * v], q[3 * v + 1], q[3 * v + 2]};
  };
  std::vector<Vec3d> sum(n);
  System s{{3, 8, 2500}, [&](const Values& q, Values& f) {
             std::fill(sum.begin(), sum.end(), Vec3d{});
             for (const Edge& e : edges) {
               const Vec3d d = place(q, e.b) - place(q, e.a);
               const double l = length(d);
               const Vec3d pull = d * (e.stiffness * (l - e.length) / l);
               sum[e.a] += pull;
               sum[e.b] -= pull;
             }
             double volume = 0;
             for (const auto& tri : mesh.triangles)
               volume += dot(place(q, tri[0]), cross(place(q, tri[1]), place(q, tri[2]))) / 6;
             const double pressure = -1000 * (volume - t.volume[0]) / t.volume[0];
             for (const auto& tri : mesh.triangles) {
               const Vec3d a = place(q, tri[0]),
                           facing = cross(place(q, tri[1]) - a, place(q, tri[2]) - a) * (pressure / 6);
               for (const std::uint32_t v : tri) sum[v] += facing;
             }
             for (std::size_t v = 0; v < n; v++)
               for (int c = 0; c < 3; c++) f[3 * v + static_cast<std::size_t>(c)] = sum[v][c] / t.area[v];
           }};
  // starts from a press on its top
  State start{Values(3 * n, 0), Values(3 * n, 0)};
  for (std::size_t v = 0; v < n; v++) {
    const double r = length(mesh.vertices[v] - Vec3d{0, 0.03, 0.13}) / 0.11;
    if (r < 1) start.q[3 * v + 2] = -0.03 * (1 - r * r) * (1 - r * r);
  }
  const double end = 0.1;
  State reference = start;
  rungeKutta4(s, reference, end / 16384, 16384);
  std::printf("\nhead: %zu vertices; reference: RK4 with 16384 steps\n", n);
  compare("head", s, start, reference, end, {16, 32, 64, 128, 256, 512, 1024, 2048, 4096}, out);
}

}  // namespace thaw::bench
