// SPDX-License-Identifier: Apache-2.0
#include "io/image/annotate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/image/text.hpp"

namespace thaw {

namespace {

constexpr Rgb ink{44, 48, 56};

/// Shortest label that distinguishes the ticks; powers of ten for very large and small numbers.
std::string label(double value, double step, double largest) {
  if (value == 0) return "0";
  if (largest >= 1e5 || largest < 1e-3) {
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    const int digits = std::clamp(power - static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
    return fmt::format("{:.{}f}e{}", value / std::pow(10.0, power), digits, power);
  }
  return fmt::format("{:.{}f}", value, std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9))));
}

/// Sizes (pixels) and texts of a colour bar in a picture of a given height.
struct BarLayout {
  double unit, text, margin, beside;
  int wide;
  Ticks ticks;
  double widest = 0;  ///< width of the longest tick label
  std::string title;

  BarLayout(const ColourScale& scale, int height)
      : unit(height / 960.0),
        text(std::max(8.0, 15 * unit)),
        margin(28 * unit),
        beside(9 * unit),
        wide(std::max(6, static_cast<int>(20 * unit))),
        ticks(ticksBetween(scale.min, scale.max, 6, scale.whole ? 1 : 0)),
        title(scale.unit.empty() || scale.unit == "1" ? scale.title : scale.title + " [" + scale.unit + "]") {
    for (const std::string& l : ticks.labels) widest = std::max(widest, textWidth(l, text));
  }
  double titleHeight() const { return 1.05 * text; }
};

}  // namespace

Ticks ticksBetween(double min, double max, int most, double least) {
  Ticks ticks;
  if (!(max > min) || !std::isfinite(max - min)) {
    ticks.values.push_back(min);
    ticks.labels.push_back(fmt::format("{:.4g}", min));
    return ticks;
  }
  const double power = std::pow(10.0, std::floor(std::log10((max - min) / most)));
  double step = power;
  for (double factor : {2.0, 5.0, 10.0})
    if ((max - min) / step > most) step = factor * power;
  step = std::max(step, least);
  for (double k = std::ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; k++) {
    ticks.values.push_back(k * step);
    ticks.labels.push_back(label(k * step, step, std::max(std::abs(min), std::abs(max))));
  }
  return ticks;
}

int colourBarWidth(const ColourScale& scale, int height) {
  const BarLayout bar(scale, height);
  const double content = std::max(bar.wide + bar.beside + bar.widest,
                                  textWidth(bar.title, bar.titleHeight()));
  return static_cast<int>(std::ceil(content + 2 * bar.margin));
}

void drawColourBar(Image& image, const ColourScale& scale) {
  const BarLayout bar(scale, image.height);
  const int top = static_cast<int>(0.16 * image.height), tall = static_cast<int>(0.5 * image.height),
            left = static_cast<int>(image.width - bar.margin - bar.widest - bar.beside - bar.wide);
  const Palette palette = paletteOf(scale.map);
  const double right = left + bar.wide;
  const Rgb line = readableOn(image, {right, top + 0.0, right + bar.beside, top + 0.0 + tall}, ink);
  for (int y = -1; y <= tall; y++)
    for (int x = -1; x <= bar.wide; x++) {
      const bool edge = y < 0 || x < 0 || y == tall || x == bar.wide;
      // without a range, the one colour of all values
      const double value = scale.max > scale.min
                               ? scale.min + (1 - (y + 0.5) / tall) * (scale.max - scale.min)
                               : scale.min;
      mix(image, left + x, top + y,
          edge ? line : palette[static_cast<std::size_t>(paletteIndex(scale, value))], edge ? 0.5 : 1);
    }
  for (std::size_t i = 0; i < bar.ticks.values.size(); i++) {
    const double t = scale.max > scale.min ? (bar.ticks.values[i] - scale.min) / (scale.max - scale.min)
                                           : 0.5;
    const double y = top + (1 - t) * tall;
    for (int x = 0; x < static_cast<int>(5 * bar.unit) + 1; x++)
      mix(image, left + bar.wide + 1 + x, static_cast<int>(std::min(y, top + tall - 1.0)), line, 0.8);
    drawText(image, left + bar.wide + bar.beside, y + bar.text / 2, bar.ticks.labels[i],
             {bar.text, ink, Align::Left});
  }
  const double height = bar.titleHeight();
  drawText(image, image.width - bar.margin, top - 1.4 * bar.text,
           fittedText(bar.title, height, image.width - 2 * bar.margin), {height, ink, Align::Right});
}

void drawCaption(Image& image, const std::string& title, const std::string& time) {
  const double unit = image.height / 960.0, text = std::max(9.0, 18 * unit), margin = 28 * unit;
  const std::string behind = "   t = " + time,
                    begins = fittedText(title, text, image.width - 2 * margin - textWidth(behind, text));
  drawText(image, margin, margin + text, begins.empty() ? "t = " + time : begins + behind,
           {text, ink, Align::Left});
}

Image contactSheet(std::span<const Image> pictures, int columns, std::span<const std::string> labels) {
  if (pictures.empty() || columns < 1 || labels.size() != pictures.size())
    throw std::invalid_argument(
        "expected at least one picture, one column, and a label per picture for a contact sheet");
  const int width = pictures[0].width, height = pictures[0].height;
  for (const Image& p : pictures)
    if (p.width != width || p.height != height)
      throw std::invalid_argument("expected pictures of the same size for a contact sheet");
  const int across = std::min(columns, static_cast<int>(pictures.size())),
            down = (static_cast<int>(pictures.size()) + across - 1) / across;
  const int space = std::max(4, width / 40);
  double text = std::clamp(width / 26.0, 7.0, 20.0);
  for (const std::string& l : labels) text *= std::min(1.0, (width + 0.5 * space) / textWidth(l, text));
  const int below = static_cast<int>(2.2 * text);
  Image sheet(across * (width + space) + space, down * (height + below + space) + space, {247, 248, 249});
  for (std::size_t i = 0; i < pictures.size(); i++) {
    const int x = space + static_cast<int>(i) % across * (width + space),
              y = space + static_cast<int>(i) / across * (height + below + space);
    paste(sheet, pictures[i], x, y);
    drawText(sheet, x + width / 2.0, y + height + 1.6 * text, labels[i], {text, ink, Align::Centre});
  }
  return sheet;
}

}  // namespace thaw
