// SPDX-License-Identifier: Apache-2.0
// The first lines of a run's output.
#include <gtest/gtest.h>

#include "io/run/resolution_line.hpp"
#include "io/text/short_text.hpp"

namespace thaw {
namespace {

TEST(ResolutionLine, NamesTheSpacingsAndTheirOverrides) {
  Scene s;
  s.spacing = 0.02;
  EXPECT_EQ(resolutionLine(s, {"end=3", "surface.iso_level=0.5"}), "spacing 0.02 m; quality standard");
  s.quality = Quality::Preview;
  s.surface.on = true;
  s.oriented.emplace_back().name = "net";
  s.oriented.emplace_back().name = "skin";
  s.oriented[1].spacing = 0.005;
  EXPECT_EQ(
      resolutionLine(s, {"spacing=2 cm", "quality=preview", "oriented.skin.spacing = 0.005", "spacings=3"}),
      "spacing 0.02 m, oriented body 'skin' 0.005 m, surfels 0.01 m; quality preview (--set spacing=2 cm, "
      "--set quality=preview, --set oriented.skin.spacing = 0.005)");
}

TEST(ShortText, NeverSplitsACharacter) {
  EXPECT_EQ(shortText("abc", 3), "abc");
  EXPECT_EQ(shortText("abcd", 3), "abc...");
  EXPECT_EQ(shortText("ab\xC3\xA9"
                      "d",
                      3),
            "ab...");
  EXPECT_EQ(shortText(std::string(1000, 'x'), longestTitle).size(), longestTitle + 3);
}

}  // namespace
}  // namespace thaw
