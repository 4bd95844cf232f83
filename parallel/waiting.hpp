// How a rank waits for others: it looks, again and again, as MPI itself does, but it does not keep the core from the rank that it waits for.
#pragma once
#include <mpi.h>

namespace thaw {

/// Whether more ranks run on this rank's machine than cores are free for them (what all of them may be scheduled on, and a container's quota).
/// Collective over the ranks of `comm`; the same on all ranks of a machine.
bool ranksExceedCores(MPI_Comm comm);

/// Between two looks. Where ranks share cores (`crowded`) it sleeps at once: who is waited for needs the core. Else only once it has waited for longer
/// than messages take, since something else may run on that core then; a sleep delays by less than a tenth of that.
class Patience {
 public:
  explicit Patience(bool crowded) : crowded_(crowded) {}
  void pause();

 private:
  bool crowded_;
  int looks_ = 0;
};

}  // namespace thaw
