// SPDX-License-Identifier: Apache-2.0
// Text in pictures with a built-in font: 5x7 dots joined by round strokes, smooth at any size.
#pragma once
#include <string>
#include <string_view>

#include "io/image/image.hpp"

namespace thaw {

enum class Align { Left, Centre, Right };

struct TextStyle {
  double height = 14;      ///< pixels, of a capital letter
  Rgb colour{40, 44, 52};  ///< made lighter or darker where it would be hard to read
  Align align = Align::Left;
};

/// Returns the width of the text in pixels. Characters other than printable ASCII (a UTF-8 sequence counts as
/// one) show as '?'.
double textWidth(std::string_view text, double height);

/// Returns the text if it fits into `width` (pixels), else its beginning with "..."; "" if nothing fits.
std::string fittedText(std::string_view text, double height, double width);

/// Pixels from (left, top) to (right, bottom), exclusive.
struct PixelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// Returns the colour, made lighter or darker until its contrast with the mean of the picture in the box is
/// at least 4.5. This is the ratio of WCAG 2 for small text.
Rgb readableOn(const Image& image, const PixelBox& box, Rgb colour);

/// Draws one line of text with its baseline's left end, centre or right end at (x, y), in pixels from the
/// upper left corner.
void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style);

}  // namespace thaw
