// SPDX-License-Identifier: Apache-2.0
// Figures of docs/validation/stability.md: each test of tests/stability prints its measurements.
#pragma once
#include <gtest/gtest.h>

#include <cstdarg>
#include <cstdio>

namespace thaw::test {

/// Prints a line "measured: TEST: ..." and stores it in the test's record. `build/release/tests/stability |
/// grep '^measured'` lists all.
[[gnu::format(printf, 1, 2)]] inline void measured(const char* format, ...) {
  char text[400];
  va_list list;
  va_start(list, format);
  std::vsnprintf(text, sizeof text, format, list);
  va_end(list);
  const char* name = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::printf("measured: %s: %s\n", name, text);
  testing::Test::RecordProperty("measured", text);
}

}  // namespace thaw::test
