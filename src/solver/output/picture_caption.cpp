#include "solver/output/picture_caption.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "solver/output/picture_text.h"

namespace icebow {
namespace {

constexpr Color ink{22, 34, 48}, paper{250, 252, 253}, rule{198, 208, 216};
constexpr double line = 13.0, side = 7.0,
                 gap = 12.0;  // in dots: a line, a margin and a swatch, between entries

// The largest of 1, 2, 5 times a power of ten that is not longer.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (double factor : {5.0, 2.0})
    if (factor * power <= longest) return factor * power;
  return power;
}

struct Place {
  int row;
  double left;  //!< [px]
};

// Entries side by side, in as many rows as they need.
std::vector<Place> places(const std::vector<LegendEntry>& entries, int width_px) {
  const double dot = letter_dot(width_px);
  std::vector<Place> list;
  Place next{0, side * dot};
  for (const LegendEntry& entry : entries) {
    const double width = 1.6 * side * dot + text_width(entry.words, dot);
    if (next.left > side * dot && next.left + width > width_px - side * dot)
      next = {next.row + 1, side * dot};
    list.push_back(next);
    next.left += width + gap * dot;
  }
  return list;
}

// What of the title fits the width, and says so where not all does.
std::string fitted(std::string title, int width_px) {
  const double dot = letter_dot(width_px);
  const auto most = static_cast<std::size_t>(std::max(4.0, (width_px / dot - 2.0 * side) / 6.0));
  if (title.size() > most) title = title.substr(0, most - 3) + "...";
  return title;
}

}  // namespace

double title_height(const std::string& title, int width_px) {
  return title.empty() ? 0.0 : (line + 3.0) * letter_dot(width_px);
}

double legend_height(const std::vector<LegendEntry>& entries, int width_px) {
  if (entries.empty()) return 0.0;
  return (line * (places(entries, width_px).back().row + 1) + 4.0) * letter_dot(width_px);
}

void draw_title(Canvas& canvas, const std::string& title) {
  if (title.empty()) return;
  const double dot = letter_dot(canvas.width()), top = canvas.height();
  const double bottom = top - title_height(title, canvas.width());
  canvas.rectangle(0.0, bottom, canvas.width(), top, paper);
  canvas.rectangle(0.0, bottom, canvas.width(), bottom + 0.5, rule);
  draw_text(canvas, fitted(title, canvas.width()), side * dot, bottom + 5.0 * dot, dot, ink);
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries) {
  const double dot = letter_dot(canvas.width()), height = legend_height(entries, canvas.width());
  canvas.rectangle(0.0, 0.0, canvas.width(), height, paper);
  const std::vector<Place> where = places(entries, canvas.width());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double bottom = height - (line * (where[i].row + 1) - 1.0) * dot, left = where[i].left;
    canvas.rectangle(left - 0.5, bottom - 0.5, left + side * dot + 0.5, bottom + 7.0 * dot + 0.5, ink);
    canvas.rectangle(left, bottom, left + side * dot, bottom + 7.0 * dot, entries[i].color);
    draw_text(canvas, entries[i].words, left + 1.6 * side * dot, bottom, dot, ink);
  }
}

void draw_scale_bar(Canvas& canvas, double lambda, double above_px) {
  const double dot = letter_dot(canvas.width()), margin = 7.0 * dot;
  const double per_pixel = lambda * canvas.metres_per_pixel();
  const double metres = round_length(0.2 * canvas.width() * per_pixel), length = metres / per_pixel;
  if (canvas.width() < 100 || canvas.height() - above_px < 6.0 * margin) return;  // no room

  const std::string label = text("%g m", metres);
  const double label_width = text_width(label, dot);
  const double plate = std::max(length, label_width) + 2.0 * margin, foot = above_px + 0.5 * margin;
  canvas.rectangle(0.5 * margin, foot, 0.5 * margin + plate, foot + 21.0 * dot, paper);
  const double left = std::round(1.5 * margin), bottom = foot + 4.0 * dot;
  canvas.rectangle(left, bottom, left + length, bottom + 2.0 * dot, ink);
  for (double end : {left, left + length - dot})  // ticks
    canvas.rectangle(end, bottom - dot, end + dot, bottom + 3.0 * dot, ink);
  draw_text(canvas, label, left + 0.5 * (length - label_width), bottom + 6.0 * dot, dot, ink);
}

}  // namespace icebow
