// SPDX-License-Identifier: Apache-2.0
// Images, PNG files, text, colours, colour bars and contact sheets.
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "io/image/annotate.hpp"
#include "io/image/linear_light.hpp"
#include "io/image/text.hpp"

using namespace thaw;

namespace {

Image readPng(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) throw std::runtime_error(png.message);
  png.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr))
    throw std::runtime_error(png.message);
  return image;
}

/// Luminance from weighted sRGB channels, approximately decoded.
double luminance(Rgb c) {
  const auto d = [](std::uint8_t x) { return std::pow(x / 255.0, 2.2); };
  return 0.2126 * d(c.r) + 0.7152 * d(c.g) + 0.0722 * d(c.b);
}

int inked(const Image& image) {
  int n = 0;
  for (Rgb p : image.pixels) n += p.r < 128;
  return n;
}

}  // namespace

TEST(Png, RoundTripsExactly) {
  Image image(37, 23);
  for (int y = 0; y < 23; y++)
    for (int x = 0; x < 37; x++)
      image.at(x, y) = {static_cast<std::uint8_t>(x * 6), static_cast<std::uint8_t>(y * 11),
                        static_cast<std::uint8_t>(x ^ y)};
  const auto path = std::filesystem::path(testing::TempDir()) / "thaw_png_test.png";
  writePng(image, path);
  EXPECT_EQ(readPng(path).pixels, image.pixels);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
  std::filesystem::remove(path);
}

TEST(Png, ErrorsNameTheFile) {
  try {
    writePng(Image(2, 2), "/no/such/folder/a.png");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/a.png"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
  }
  EXPECT_THROW(writePng(Image(), std::filesystem::path(testing::TempDir()) / "x.png"), std::runtime_error);
}

TEST(Png, FullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto path = std::filesystem::path(testing::TempDir()) / "thaw_full.png",
             part = std::filesystem::path(path.string() + ".part");
  std::filesystem::remove(part);
  std::filesystem::create_symlink("/dev/full", part);
  try {
    writePng(Image(500, 500), path);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), path.string() + ": cannot write: No space left on device");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::is_symlink(part));
}

TEST(Image, ScalingDownKeepsTheMean) {
  Image image(10, 6);
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i++) {
    image.pixels[i].g = static_cast<std::uint8_t>(i * 4);
    sum += image.pixels[i].g;
  }
  const Image small = scaledDown(image, 4, 4);
  double mean = 0;
  for (Rgb p : small.pixels) mean += p.g;
  EXPECT_NEAR(mean / 16, sum / 60, 0.5);
  EXPECT_EQ(scaledDown(image, 99, 99).pixels, image.pixels);
}

TEST(ColourMap, LightnessRises) {
  for (const char* name : {"ember", "sea", "grey"}) {
    const Palette p = paletteOf(colourMapNamed(name));
    for (std::size_t i = 8; i < p.size(); i += 8)
      EXPECT_GT(luminance(p[i]), luminance(p[i - 8])) << name << ' ' << i;
    for (std::size_t i = 1; i < p.size(); i++)
      EXPECT_LT(std::abs(p[i].r - p[i - 1].r) + std::abs(p[i].g - p[i - 1].g) + std::abs(p[i].b - p[i - 1].b),
                25)
          << name << ' ' << i;
  }
  EXPECT_THROW(colourMapNamed("jet"), std::invalid_argument);
}

TEST(ColourMap, NumbersOutsideTheRangeGetTheEnds) {
  const ColourScale scale{10, 20, ColourMap::Sea, "", ""};
  EXPECT_EQ(paletteIndex(scale, 0), 0);
  EXPECT_EQ(paletteIndex(scale, 10), 0);
  EXPECT_EQ(paletteIndex(scale, 15), 128);
  EXPECT_EQ(paletteIndex(scale, 1e300), 255);
  EXPECT_EQ(paletteIndex(scale, NAN), 0);
  EXPECT_EQ(paletteIndex({1, 1, ColourMap::Sea, "", ""}, 5), 0);
}

TEST(Ticks, AreRoundNumbersInsideTheRange) {
  EXPECT_EQ(ticksBetween(293, 383, 6).labels, (std::vector<std::string>{"300", "320", "340", "360", "380"}));
  EXPECT_EQ(ticksBetween(0, 1, 6).labels, (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(ticksBetween(-2e5, 2e5, 5).labels, (std::vector<std::string>{"-2e5", "-1e5", "0", "1e5", "2e5"}));
  EXPECT_EQ(ticksBetween(5, 5, 6).values, std::vector<double>{5});
  for (double top : {1e-12, 3e-4, 0.7, 12.0, 9.9e4, 1e20}) {
    const Ticks t = ticksBetween(0, top, 6);
    EXPECT_GE(t.values.size(), 2u) << top;
    EXPECT_LE(t.values.size(), 7u) << top;
    EXPECT_LE(t.values.back(), top * 1.0001);
  }
}

TEST(Ticks, OfWholeNumbersAreWhole) {
  EXPECT_EQ(ticksBetween(0, 2, 6, 1).labels, (std::vector<std::string>{"0", "1", "2"}));
  EXPECT_EQ(ticksBetween(3, 4, 6, 1).labels, (std::vector<std::string>{"3", "4"}));
  EXPECT_EQ(ticksBetween(0, 20, 6, 1).values, ticksBetween(0, 20, 6).values);
}

TEST(ColourBar, OfWholeNumbersHasFewerLabels) {
  const auto drawn = [](bool whole) {
    Image image(120, 400, {255, 255, 255});
    drawColourBar(image, {0, 1, ColourMap::Sea, "", "", whole});
    int pixels = 0;
    for (int y = 0; y < image.height; y++)
      for (int x = 0; x < image.width; x++) pixels += image.at(x, y).r < 255;
    return pixels;
  };
  EXPECT_LT(drawn(true), drawn(false));
}

TEST(ColourBar, MatchesThePictureForAConstantField) {
  for (const double value : {0.0, 5.0}) {
    const ColourScale scale{value, value, ColourMap::Sea, "", ""};
    Image image(120, 400, {255, 255, 255});
    drawColourBar(image, scale);
    const Rgb wanted = paletteOf(scale.map)[static_cast<std::size_t>(paletteIndex(scale, value))];
    int bar = 0;
    for (int y = 70; y < 260; y++)
      bar += std::find(&image.at(0, y), &image.at(0, y) + image.width, wanted) !=
             &image.at(0, y) + image.width;
    EXPECT_EQ(bar, 190);
  }
}

TEST(Text, DrawsInsideItsBox) {
  Image image(200, 40, {255, 255, 255});
  drawText(image, 100, 30, "1 W/(m K)", {14, {0, 0, 0}, Align::Centre});
  EXPECT_GT(inked(image), 100);
  const double width = textWidth("1 W/(m K)", 14);
  for (int y = 0; y < 40; y++)
    for (int x = 0; x < 200; x++)
      if (image.at(x, y).r < 200) { EXPECT_LT(std::abs(x + 0.5 - 100), width / 2 + 2); }
  EXPECT_EQ(textWidth("111", 14), textWidth("888", 14));
  EXPECT_EQ(textWidth("\xC3\xA9", 14), textWidth("?", 14));  // one letter of two bytes
  EXPECT_EQ(textWidth("", 14), 0);
}

TEST(Text, IsLegibleOnAnyBackground) {
  const auto relative = [](Rgb c) {
    const Light l = toLinear(c);
    return 0.2126 * l.x + 0.7152 * l.y + 0.0722 * l.z;
  };
  const Rgb ink{44, 48, 56};
  for (const Rgb behind :
       {Rgb{0, 0, 16}, Rgb{32, 48, 80}, Rgb{120, 120, 120}, Rgb{217, 130, 43}, Rgb{240, 242, 245}})
    for (const Rgb colour : {ink, Rgb{217, 130, 43}, Rgb{255, 255, 255}}) {
      Image image(100, 40, {255, 255, 255});
      for (int y = 0; y < 40; y++)
        for (int x = 0; x < 50; x++) image.at(x, y) = behind;
      const double a = relative(readableOn(image, {0, 10, 50, 30}, colour)), b = relative(behind);
      EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5);
    }
  const Image pale(100, 40, {232, 236, 241});
  EXPECT_EQ(readableOn(pale, {0, 0, 100, 40}, ink), ink) << "a readable colour is kept";
  Image dark(100, 40, {32, 48, 80});
  drawText(dark, 50, 30, "t = 1 s", {14, ink, Align::Centre});
  EXPECT_GT(
      std::max_element(dark.pixels.begin(), dark.pixels.end(), [](Rgb p, Rgb q) { return p.g < q.g; })->g,
      130);
}

TEST(Text, IsFittedToTheAvailableRoom) {
  EXPECT_EQ(fittedText("a title", 14, 1000), "a title");
  const std::string text =
      "one of a good many words, with \xC3\xA9\xC3\xA9\xC3\xA9 in it, and then some more of them";
  for (double width = 0; width < textWidth(text, 14); width += 3.3) {
    const std::string fitted = fittedText(text, 14, width);
    EXPECT_LE(textWidth(fitted, 14), width + 1e-9);
    if (fitted.empty()) continue;
    ASSERT_TRUE(fitted.ends_with("..."));
    const std::string begins = fitted.substr(0, fitted.size() - 3);
    EXPECT_TRUE(text.starts_with(begins) && (static_cast<unsigned char>(text[begins.size()]) & 0xC0) != 0x80)
        << fitted;
  }
  EXPECT_GT(textWidth(fittedText(text, 14, 300), 14), 280) << "it fills the available room";
}

// A long title must not move the time out of the picture.
TEST(Caption, ShowsTheTimeWithATitleOfAnyLength) {
  const auto drawn = [](const std::string& title, const std::string& time) {
    Image image(640, 480, {255, 255, 255});
    drawCaption(image, title, time);
    return image.pixels;
  };
  const std::string title(1000, 'w');
  EXPECT_NE(drawn(title, "0.10 s"), drawn(title, "0.20 s"));
  EXPECT_NE(drawn(title, "0.10 s"), drawn("", "0.10 s"));
  EXPECT_EQ(drawn(title, "0.10 s"), drawn(title + title, "0.10 s"));
}

/// Returns true if the leftmost and the rightmost column of a picture are white.
bool hasWhiteSides(const Image& image) {
  for (int y = 0; y < image.height; y++)
    for (const int x : {0, image.width - 1})
      if (!(image.at(x, y) == Rgb{255, 255, 255})) return false;
  return true;
}

TEST(ColourBar, TitlesOfAnyLengthAreWithinThePicture) {
  for (const std::string& title : {std::string("f"), std::string("temperature"), std::string(60, 'w')})
    for (const int height : {100, 760}) {
      const ColourScale scale{290, 370, ColourMap::Ember, title, "K"};
      const int width = colourBarWidth(scale, height);
      Image fitting(width, height, {255, 255, 255}), wider(width + 100, height, {255, 255, 255}),
          narrow(90, height, {255, 255, 255});
      for (Image* image : {&fitting, &wider, &narrow}) {
        drawColourBar(*image, scale);
        EXPECT_TRUE(hasWhiteSides(*image)) << title << " " << height << " " << image->width;
      }
      // the title of the bar that fits is not shortened: the wider picture has the same pixels
      int drawn = 0, all = 0;
      for (const Rgb p : fitting.pixels) drawn += p == Rgb{255, 255, 255} ? 0 : 1;
      for (const Rgb p : wider.pixels) all += p == Rgb{255, 255, 255} ? 0 : 1;
      EXPECT_EQ(drawn, all);
    }
}

TEST(ContactSheet, HoldsAllPictures) {
  const std::vector<Image> pictures(5, Image(80, 60, {255, 0, 0}));
  const std::vector<std::string> labels(5, "0 s");
  const Image sheet = contactSheet(pictures, 3, labels);
  int red = 0;
  for (Rgb p : sheet.pixels) red += p == Rgb{255, 0, 0};
  EXPECT_EQ(red, 5 * 80 * 60);
  EXPECT_THROW(contactSheet(pictures, 3, std::span(labels).first(4)), std::invalid_argument);
  EXPECT_THROW(contactSheet({}, 3, {}), std::invalid_argument);
}
