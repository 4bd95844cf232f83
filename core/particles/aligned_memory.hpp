// Memory of fields, lists and records.
#pragma once
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace thaw {

/// Bytes aligned to a cache line. Blocks of several MB are aligned to large pages and ask for them: with 4 kB
/// a step over a million particles misses the table of pages so often that it takes a twentieth longer.
void* allocateAligned(std::size_t bytes);
void freeAligned(void* block, std::size_t bytes);
/// Gives freed memory that the library keeps for later back to the system, where it can be: what the start
/// took is not asked for again.
void giveBackFreed();

/// For programs, once at their start: freed blocks of a megabyte go back to the system at once. Left alone,
/// glibc comes to keep blocks of up to 32 MB for itself once such have been freed, and a million elastic
/// particles on four ranks held twice what they use. A steady step allocates nothing, so it costs nothing.
void returnLargeBlocks();

/// Allocator of aligned memory that leaves new elements uninitialised (columns zero them explicitly).
template<class T> struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template<class U> AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocateAligned(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { freeAligned(p, n * sizeof(T)); }
  template<class U> void construct(U* p) { ::new (static_cast<void*>(p)) U; }
  template<class U, class... A> void construct(U* p, A&&... a) {
    ::new (static_cast<void*>(p)) U(std::forward<A>(a)...);
  }
  friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};
template<class T> using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace thaw
