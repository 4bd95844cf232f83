// SPDX-License-Identifier: Apache-2.0
// Instruction set name of a translation unit, for the kernel sets of the *_isa.cpp files.
#pragma once

namespace thaw {
namespace THAW_ISA {
namespace {

#define THAW_TEXT_OF(x) #x
#define THAW_TEXT(x) THAW_TEXT_OF(x)
/// "base", "avx2" or "avx512", from the namespace isa_base, isa_avx2 or isa_avx512.
constexpr const char* isaName = THAW_TEXT(THAW_ISA) + 4;
#undef THAW_TEXT
#undef THAW_TEXT_OF

}  // namespace
}  // namespace THAW_ISA
}  // namespace thaw
