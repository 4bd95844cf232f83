// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/path_names.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(PathNames, DefaultNamesBecomePaths) {
  EXPECT_EQ(withPaths("heated region 'heated region 0' holds no particle"),
            "heated_region.0 holds no particle");
  EXPECT_EQ(withPaths("oriented body 'oriented 12': near sheet 'sheet 3'"), "oriented.12: near sheet.3");
  EXPECT_EQ(withPaths("(first: of body 'body 0' in obstacle 'obstacle 1')"),
            "(first: of body.0 in obstacle.1)");
}

TEST(PathNames, ChosenNamesStay) {
  for (const char* text : {"sheet 'sail'", "sheet 'sheet '", "sheet 'sheet 2b'", "sheet 'sheet 2"})
    EXPECT_EQ(withPaths(text), text);
}

}  // namespace
}  // namespace thaw
