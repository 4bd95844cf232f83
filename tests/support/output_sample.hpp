// SPDX-License-Identifier: Apache-2.0
// A world for file tests whose values depend on ids only, and folders shared by all ranks.
#pragma once
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/simulation/world/world.hpp"
#include "core/solid/bonds/bond_records.hpp"
#include "io/frames/frame_fields.hpp"

namespace thaw::test {

inline int rankOf(MPI_Comm comm = MPI_COMM_WORLD) {
  int r;
  MPI_Comm_rank(comm, &r);
  return r;
}
inline int sizeOf(MPI_Comm comm = MPI_COMM_WORLD) {
  int s;
  MPI_Comm_size(comm, &s);
  return s;
}

/// A folder shared by all ranks and removed at the end.
struct Folder {
  std::string path;
  Folder() {
    char name[64] = "/tmp/thaw_output_XXXXXX";
    if (rankOf() == 0 && mkdtemp(name) == nullptr) std::abort();
    MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD);
    path = name;
  }
  ~Folder() {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rankOf() == 0) std::filesystem::remove_all(path);
  }
};

/// A communicator of the first n ranks.
struct Some {
  MPI_Comm comm = MPI_COMM_NULL;
  explicit Some(int n) { MPI_Comm_split(MPI_COMM_WORLD, rankOf() < n ? 0 : MPI_UNDEFINED, rankOf(), &comm); }
  ~Some() {
    if (comm != MPI_COMM_NULL) MPI_Comm_free(&comm);
  }
  bool in() const { return comm != MPI_COMM_NULL; }
};

inline double hashed(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ull;
  x ^= x >> 33;
  return static_cast<double>(x >> 11) * 0x1p-53 - 0.5;
}

/// Owner of a particle: uneven, some ranks own none.
inline int ownerOf(std::uint64_t id, int ranks) {
  return static_cast<int>((id / 7) % static_cast<std::uint64_t>(ranks > 2 ? ranks - 1 : ranks));
}
inline bool solidAt(std::uint64_t id) { return id % 3 != 0; }
inline Mat3d plasticInverseOf(std::uint64_t id) {
  return {{{0.1 * hashed(id), 0.02, 0.03}, {0.04, 0.05, 0.06}, {0.07, 0.08, 0.09}}};
}

/// Ids of a rank's particles and solids. Solids are in another order than particles.
struct SampleIds {
  std::uint64_t all;  ///< number of particles on all ranks
  std::vector<std::uint64_t> particles, solids;
  std::map<std::uint64_t, std::uint32_t> solidIndexOf;
  SampleIds(MPI_Comm comm, std::uint64_t N) : all(N) {
    for (std::uint64_t id = 0; id < N; id++)
      if (ownerOf(id, sizeOf(comm)) == rankOf(comm)) particles.push_back(id);
    for (std::uint64_t id : particles)
      if (solidAt(id)) solids.push_back(id);
    std::reverse(solids.begin(), solids.end());
    for (std::size_t k = 0; k < solids.size(); k++) solidIndexOf[solids[k]] = static_cast<std::uint32_t>(k);
  }
};

inline void fillParticles(const SampleIds& ids, Continuum& p) {
  for (AnyColumn* c : p.columns) p.activate(*c);
  p.resize(ids.particles.size(), 0);
  for (std::size_t i = 0; i < ids.particles.size(); i++) {
    const std::uint64_t id = ids.particles[i];
    for (AnyColumn* c : p.columns)
      if (c->keep == Keep::State)
        for (std::size_t b = 0; b < c->elementBytes; b++)
          c->bytes[i * c->elementBytes + b] = std::byte(std::uint8_t(37 * id + 11 * b));
    p.id[i] = id;
    p.position[i] = {hashed(id), hashed(id + 1000), hashed(id + 2000)};
    p.velocity[i] = 2.0 * p.position[i];
    p.temperature[i] = 300 + hashed(id);
    p.material[i] = p.body[i] = 0;
    p.phase[i] = solidAt(id) ? Solid : Liquid;
    p.solidIndex[i] = solidAt(id) ? ids.solidIndexOf.at(id) : noSolid;
  }
}

inline void fillSolids(const SampleIds& ids, Solids& s) {
  for (AnyColumn* c : s.columns) s.activate(*c);
  s.resize(ids.solids.size(), 0);
  for (std::size_t k = 0; k < ids.solids.size(); k++) {
    const std::uint64_t id = ids.solids[k];
    s.id[k] = id;
    s.volume[k] = 1 + hashed(id);
    s.plasticInverse[k] = plasticInverseOf(id);
    s.deformation[k] = identity3<double>();
    s.stress[k] = {1, 2, 3, 4, 5, double(id)};
  }
}

/// Bonds each solid to up to three others, and appends remote rows for those of other ranks.
inline void fillBonds(const SampleIds& ids, bool twoFrames, Bonds& bonds, Solids& s) {
  constexpr int most = 5;
  bonds.choose(twoFrames, twoFrames, false);
  resizeBonds(bonds, ids.solids.size(), most);
  std::vector<std::uint64_t> remote;
  for (std::size_t k = 0; k < ids.solids.size(); k++) {
    const std::uint64_t id = ids.solids[k];
    for (int n = 0; n < most; n++) {
      const std::size_t at = bonds.at(k, n);
      const std::uint64_t other = (id * 13 + std::uint64_t(n) * 29 + 1) % ids.all;
      bonds.neighbour[at] = static_cast<std::uint32_t>(k);
      if (!solidAt(other) || other == id || n == 2) continue;  // also a broken bond between other particles
      if (const auto f = ids.solidIndexOf.find(other); f != ids.solidIndexOf.end())
        bonds.neighbour[at] = f->second;
      else {
        bonds.neighbour[at] = static_cast<std::uint32_t>(ids.solids.size() + remote.size());
        remote.push_back(other);
      }
      if (!twoFrames) continue;
      bonds.x.set(at, hashed(other + id * 5)), bonds.y.set(at, n), bonds.z.set(at, 2);
      bonds.rx.set(at, 7 + double(id)), bonds.ry.set(at, 8), bonds.rz.set(at, 9);
      bonds.weight.set(at, 1 + hashed(id + other));
    }
  }
  s.resize(s.owned, remote.size());
  for (std::size_t k = 0; k < remote.size(); k++) s.id[s.owned + k] = remote[k];
}

/// A world whose values depend on ids only: N particles, two thirds of them solid, bonded to up to three
/// others on any rank.
struct Sample {
  World w;
  Sample(MPI_Comm comm, std::uint64_t N, bool twoFrames = true) {
    Material m;
    m.name = "wax";
    m.young = {1e5, 0};
    w.scene.materials.push_back(m);
    w.scene.output.fields = knownFrameFields();
    w.scene.bodies.emplace_back();
    const SampleIds ids(comm, N);
    fillParticles(ids, w.particles);
    fillSolids(ids, w.solids);
    fillBonds(ids, twoFrames, w.bonds, w.solids);
    for (const std::uint64_t id : ids.particles) {
      w.ledger.heatIn.add(hashed(id) * 1e-7);
      w.ledger.left.momentum[1].add(-std::abs(hashed(id)));
      w.counters.melted += static_cast<std::int64_t>(id);
    }
    w.ledger.initial.mass = 42.5;
    w.clock.time = 0.1 + 0.2;
    w.clock.step = 123;
    w.clock.frame = 7;
    w.clock.dt = 1e-5 / 3;
    w.clock.every = 0.04;
    w.clock.limitedBy = "sound";
  }
};

}  // namespace thaw::test
