// SPDX-License-Identifier: Apache-2.0
#include "core/fields/aligned_memory.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace thaw {
namespace {

constexpr std::size_t largePage = std::size_t(1) << 21;

std::align_val_t alignmentOf(std::size_t bytes) {
  return std::align_val_t{bytes >= largePage ? largePage : 64};
}

}  // namespace

void* allocateAligned(std::size_t bytes) {
  void* block = ::operator new(bytes, alignmentOf(bytes));
#if defined(__linux__)
  // This is only a hint, so the result is not checked.
  if (bytes >= largePage) madvise(block, bytes / largePage * largePage, MADV_HUGEPAGE);
#endif
  return block;
}

void freeAligned(void* block, std::size_t bytes) { ::operator delete(block, alignmentOf(bytes)); }

void returnLargeBlocks() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

void trimFreedMemory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace thaw
