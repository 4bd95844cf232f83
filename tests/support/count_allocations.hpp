// SPDX-License-Identifier: Apache-2.0
// Counts calls of operator new and their bytes. Include it in one source file of a separate program.
#pragma once
#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0}, allocatedBytes{0};
}

// not inline: the compiler would report malloc and free as a mismatch with new and delete
[[gnu::noinline]] void* operator new(std::size_t n) {
  allocations++;
  allocatedBytes += static_cast<long>(n);
  if (void* p = std::malloc(n > 0 ? n : 1)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t n, std::align_val_t a) {
  allocations++;
  allocatedBytes += static_cast<long>(n);
  const std::size_t align = static_cast<std::size_t>(a);
  if (void* p = std::aligned_alloc(align, (n + align - 1) / align * align)) return p;
  throw std::bad_alloc();
}
// used by std::inplace_merge
[[gnu::noinline]] void* operator new(std::size_t n, const std::nothrow_t&) noexcept {
  allocations++;
  allocatedBytes += static_cast<long>(n);
  return std::malloc(n > 0 ? n : 1);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
