// SPDX-License-Identifier: Apache-2.0
// The operator of the implicit viscosity solver equals the explicit viscous sum: the same forces, symmetric,
// and the same bits with every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/lattice.hpp"

namespace thaw::test {
namespace {

/// Half of the block liquid, viscosities over six decades.
struct Viscous : Block {
  std::int64_t coincident = 0;
  AlignedVector<ViscousRecord> velocity;
  explicit Viscous(Precision precision) : Block(7, 0.3, 2, precision) {
    modules.melting = true;  // particles have their own fraction and viscosity
    scene.materials[0].viscosity = {1e6, 1};
    scene.materials[0].young = {1e5, 1e5};
    scene.materials[0].solidus = 300;
    scene.materials[0].liquidus = 310;
    for (std::size_t i = 0; i < particles.owned; i++)
      particles.liquid[i] = static_cast<float>(std::max(0.0, 1.5 * hashed(31 * i) - 0.5));
    findNeighbours(*pairKernels("base"));
    velocity.resize(particles.owned + 1);
    const bool single = precision == Precision::Single;
    for (std::size_t i = 0; i < particles.owned; i++) {
      const Vec3d& v = particles.velocity[i];
      const auto value = [&](const AlignedVector<std::byte>& r, std::size_t k) {
        return single ? reinterpret_cast<const float*>(r.data())[4 * i + k]
                      : static_cast<float>(reinterpret_cast<const double*>(r.data())[4 * i + k]);
      };
      velocity[i] = {v.x, v.y, v.z, value(records.velocityViscosity, 3), value(records.pressurePhaseHeat, 1)};
    }
  }
  std::vector<Vec3d> forces(bool viscous) {
    std::fill_n(particles.force.data(), particles.owned, Vec3d{});
    PairSums s = sums(&coincident);
    s.viscous = viscous;
    pairKernels("base")->forces(s, groups());
    return {particles.force.data(), particles.force.data() + particles.owned};
  }
  std::vector<Vec3d> apply(const char* isa, ViscousPass pass, std::vector<Sym3d>* block = nullptr) {
    std::vector<Vec3d> result(particles.owned);
    ViscousSums out;
    out.pass = pass;
    out.velocity = out.middle = velocity.data();
    out.result = result.data();
    out.lost = particles.dissipation.data();
    if (block) {
      block->resize(particles.owned);
      out.block = block->data();
    }
    pairKernels(isa)->viscous(sums(&coincident), out, groups());
    return result;
  }
};

double norm(const std::vector<Vec3d>& a) {
  double s = 0;
  for (const Vec3d& v : a) s += dot(v, v);
  return std::sqrt(s);
}

}  // namespace

TEST(ViscousOperator, EqualsTheExplicitForce) {
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    Viscous b(precision);
    const std::vector<Vec3d> with = b.forces(true), without = b.forces(false),
                             product = b.apply("base", ViscousPass::Apply);
    std::vector<Vec3d> difference;
    for (std::size_t i = 0; i < product.size(); i++) difference.push_back(with[i] - without[i] + product[i]);
    EXPECT_GT(norm(product), 0);
    // the operator stores viscosities as floats
    EXPECT_LT(norm(difference), (precision == Precision::Single ? 2e-6 : 2e-7) * norm(product));
    Vec3d sum{};
    for (const Vec3d& f : product) sum += f;
    EXPECT_LT(length(sum), 1e-13 * norm(product));  // in single precision, too
  }
}

TEST(ViscousOperator, DiagonalBlockIsTheParticlesOwn) {
  Viscous b(Precision::Double);
  std::vector<Sym3d> block;
  b.apply("base", ViscousPass::Start, &block);
  for (const std::size_t i : {std::size_t{5}, std::size_t{171}, std::size_t{300}})
    for (int a = 0; a < 3; a++) {
      for (ViscousRecord& r : b.velocity) r.x = r.y = r.z = 0;
      (a == 0 ? b.velocity[i].x : a == 1 ? b.velocity[i].y : b.velocity[i].z) = 1;
      Vec3d unit{};
      unit[a] = 1;
      const Vec3d own = b.apply("base", ViscousPass::Apply)[i], expected = block[i] * unit;
      EXPECT_LT(length(own - expected), 1e-12 * length(expected));
    }
}

TEST(ViscousOperator, DissipatesAndHasTheSameBitsFromEveryInstructionSet) {
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    Viscous b(precision);
    std::fill_n(b.particles.dissipation.data(), b.particles.owned, 0.0);
    const std::vector<Vec3d> base = b.apply("base", ViscousPass::Force);
    double lost = 0, work = 0;
    for (std::size_t i = 0; i < base.size(); i++) {
      EXPECT_GE(b.particles.dissipation[i], 0);
      lost += b.particles.dissipation[i];
      work += dot(base[i], b.particles.velocity[i]);
    }
    EXPECT_NEAR(lost, work, 1e-12 * work);
    for (const char* isa : {"avx2", "avx512"})
      if (pairKernels(isa)) {
        const std::vector<Vec3d> other = b.apply(isa, ViscousPass::Force);
        EXPECT_EQ(std::memcmp(base.data(), other.data(), base.size() * sizeof(Vec3d)), 0) << isa;
      }
  }
}

}  // namespace thaw::test
