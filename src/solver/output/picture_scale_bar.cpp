#include <cmath>
#include <cstring>

#include "base/text.h"
#include "solver/output/picture_canvas.h"

namespace icebow {
namespace {

// 5 x 7 dots, top row first, the leftmost dot in bit 4.
constexpr char glyph_names[] = "0123456789.m";
constexpr std::uint8_t glyphs[][7] = {
    {14, 17, 19, 21, 25, 17, 14}, {4, 12, 4, 4, 4, 4, 14},  {14, 17, 1, 2, 4, 8, 31},
    {31, 2, 4, 2, 1, 17, 14},     {2, 6, 10, 18, 31, 2, 2}, {31, 16, 30, 1, 1, 17, 14},
    {6, 8, 16, 30, 17, 17, 14},   {31, 1, 2, 4, 8, 8, 8},   {14, 17, 17, 14, 17, 17, 14},
    {14, 17, 17, 15, 1, 2, 12},   {0, 0, 0, 0, 0, 12, 12},  {0, 0, 26, 21, 21, 21, 21},
};

void draw_text(Canvas& canvas, const std::string& words, double left, double bottom, double dot,
               const Color& color) {
  for (const char letter : words) {
    const double letter_left = left;
    left += 6 * dot;
    const char* place = std::strchr(glyph_names, letter);
    if (!place) continue;  // a space
    const std::uint8_t* glyph = glyphs[place - glyph_names];
    for (int row = 0; row < 7; ++row)
      for (int column = 0; column < 5; ++column)
        if (glyph[row] >> (4 - column) & 1) {
          const double x = letter_left + column * dot, y = bottom + (6 - row) * dot;
          canvas.rectangle(x, y, x + dot, y + dot, color);
        }
  }
}

// The largest of 1, 2, 5 times a power of ten that is not longer.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (double factor : {5.0, 2.0})
    if (factor * power <= longest) return factor * power;
  return power;
}

}  // namespace

void draw_scale_bar(Canvas& canvas) {
  const Color ink{22, 34, 48}, paper{250, 252, 253};
  const double dot = std::max(1.0, std::round(canvas.width() / 500.0)), margin = 7 * dot;
  const double metres = round_length(0.2 * canvas.width() * canvas.metres_per_pixel());
  const double length = metres / canvas.metres_per_pixel();
  if (canvas.width() < 100 || canvas.height() < 6 * margin) return;  // no room

  const std::string label = text("%g m", metres);
  const double text_width = (6.0 * static_cast<double>(label.size()) - 1.0) * dot;
  const double plate = std::max(length, text_width) + 2 * margin;
  canvas.rectangle(0.5 * margin, 0.5 * margin, 0.5 * margin + plate, 0.5 * margin + 21 * dot, paper);
  const double left = 1.5 * margin, bottom = 0.5 * margin + 4 * dot;
  canvas.rectangle(left, bottom, left + length, bottom + 2 * dot, ink);
  for (double end : {left, left + length - dot})  // ticks
    canvas.rectangle(end, bottom - dot, end + dot, bottom + 3 * dot, ink);
  draw_text(canvas, label, left + 0.5 * (length - text_width), bottom + 6 * dot, dot, ink);
}

}  // namespace icebow
