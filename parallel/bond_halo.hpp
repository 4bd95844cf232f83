// BondHalo over MPI. Who has a solid particle is kept in a directory that is spread over the ranks by a hash of the id, so that a
// bond's other end is found wherever it is. Works on one rank as well.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/solid/bond_records.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw {

class MpiBondHalo : public BondHalo {
 public:
  explicit MpiBondHalo(const Communicator& comm) : comm_(comm) {}

  void migrate(Continuum& particles, Solids& solids, Bonds& bonds, const Migration& migration) override;
  bool relink(Continuum& particles, Solids& solids, Bonds& bonds, const Relink& work) override;
  void begin(Solids& solids, std::span<AnyColumn* const> columns) override;
  void finish(Solids& solids) override;

  /// Records of owned particles that are not solid yet on this rank (read from a checkpoint); the next relink makes slots of them.
  void adopt(std::vector<std::byte> records);
  const HaloTraffic& traffic() const { return traffic_; }

 private:
  struct Partner {
    int rank = 0;
    std::vector<std::uint32_t> slots;  // sent to, or remote rows filled from, this rank
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  enum Fate : std::uint8_t { Stays, Departs, Vanishes };

  void removeAndRenumber(Continuum& particles, Solids& solids, Bonds& bonds);
  void addSlots(Continuum& particles, Solids& solids, Bonds& bonds, std::span<const BondRequest> requests);
  std::uint32_t remoteRow(std::uint64_t id, std::size_t owned);
  void updateDirectory();
  std::vector<int> findOwners();
  void dropBondsTo(const std::vector<int>& owner, Solids& solids, Bonds& bonds);
  void subscribe(const std::vector<int>& owner, const Solids& solids);

  const Communicator& comm_;
  std::vector<std::vector<std::byte>> arrived_;                 // records that came in, not yet slots
  std::vector<std::uint8_t> fate_;                              // of owned slots, until the next relink
  std::unordered_map<std::uint64_t, std::uint32_t> slotOf_;     // owned slots and remote rows by id
  std::unordered_map<std::uint64_t, int> directory_;            // this rank's part: who has a solid particle
  std::vector<std::uint64_t> gone_, come_;                      // ids to strike out of, and write into, the directory
  std::vector<std::uint64_t> remote_;                           // ids of remote rows
  std::vector<Partner> sends_, receives_;
  std::vector<AnyColumn*> columns_;
  bool dirty_ = false;
  HaloTraffic traffic_;
};

}  // namespace thaw
