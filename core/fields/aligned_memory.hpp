// SPDX-License-Identifier: Apache-2.0
// Aligned memory of fields, lists and packed pair data.
#pragma once
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace thaw {

/// Returns memory aligned to a cache line. Blocks of several MB are aligned to large pages, and the kernel is
/// advised to use large pages for them. With 4 kB pages, TLB misses take several per cent of a step with a
/// million particles.
void* allocateAligned(std::size_t bytes);
void freeAligned(void* block, std::size_t bytes);
/// Returns freed memory that the allocator caches to the system, where the platform supports it. Call it
/// after set-up: a running simulation does not need that memory again.
void trimFreedMemory();

/// Makes the allocator return freed blocks of at least 1 MB to the system at once. Programs call it once at
/// their start. By default glibc raises its threshold and caches freed blocks of up to 32 MB. This doubles
/// the resident memory of large runs. A steady step allocates nothing, so the setting costs no time.
void returnLargeBlocks();

/// Allocator of aligned memory that leaves new elements uninitialised; columns zero them explicitly.
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
