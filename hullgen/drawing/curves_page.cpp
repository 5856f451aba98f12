#include "hullgen/drawing/curves_page.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/text.h"
#include "base/units.h"
#include "hullgen/drawing/lines_style.h"
#include "hullgen/drawing/svg_canvas.h"

namespace icebow {
namespace {

// The sheet [px], of A3's shape: six frames over one draft axis, levers and table below.
constexpr double width = 1500.0, height = 1060.0, margin = 60.0, top = 120.0, frame_height = 470.0,
                 gap = 26.0;
constexpr double frame_width = (width - 2.0 * margin - 5.0 * gap) / 6.0;
constexpr double lower_top = top + frame_height + 96.0, lever_width = 420.0, lever_height = 300.0;

struct Curve {
  const char* name;
  const char* style;
  std::function<double(const FormAtDraft&)> value;
};
struct Frame {
  const char* heading;
  std::vector<Curve> curves;
};

const std::vector<Frame>& frames() {
  static const std::vector<Frame> all = {
      {"Displacement [t]",
       {{"displacement", "outline", [](const auto& f) { return f.values.displacement / 1e3; }}}},
      {"Heights above the keel [m]",
       {{"KB", "outline", [](const auto& f) { return f.values.KB; }},
        {"KM_T", "measured", [](const auto& f) { return f.values.KM_T; }}}},
      {"LCB, LCF, forward + [% L]",
       {{"LCB", "outline", [](const auto& f) { return f.lcb_percent; }},
        {"LCF", "measured", [](const auto& f) { return f.lcf_percent; }}}},
      {"Coefficients",
       {{"C_B", "outline", [](const auto& f) { return f.values.block_coefficient; }},
        {"C_P", "measured", [](const auto& f) { return f.prismatic_coefficient; }},
        {"C_M", "flat", [](const auto& f) { return f.midship_coefficient; }},
        {"C_W", "dwl-cut", [](const auto& f) { return f.values.waterplane_coefficient; }}}},
      {"TPC [t/cm]", {{"TPC", "outline", [](const auto& f) { return f.tonnes_per_cm; }}}},
      {"MCT [t m/cm]", {{"MCT", "outline", [](const auto& f) { return f.moment_to_trim; }}}}};
  return all;
}

// A step of 1, 2 or 5 times a power of ten that divides the range into about so many parts.
double step_for(double range, double parts) {
  const double power = std::pow(10.0, std::floor(std::log10(range / parts)));
  for (const double n : {1.0, 2.0, 5.0})
    if (n * power * parts >= range) return n * power;
  return 10.0 * power;
}

// Values across, something up, with a grid at round numbers.
class Plot {
 public:
  Plot(SvgCanvas& svg, Pixel corner, double w, double h) : svg_(svg), corner_(corner), w_(w), h_(h) {}

  void across(double lower, double upper) { set(lower, upper, 4.0, x0_, x1_, dx_); }
  void up(double lower, double upper, double parts) { set(lower, upper, parts, y0_, y1_, dy_); }
  Pixel at(double x, double y) const {
    return {corner_.x + w_ * (x - x0_) / (x1_ - x0_), corner_.y + h_ * (1.0 - (y - y0_) / (y1_ - y0_))};
  }
  void grid(bool heights_named) {
    for (double x = x0_; x <= x1_ + 0.01 * dx_; x += dx_) {
      svg_.line(at(x, y0_), at(x, y1_), "grid");
      svg_.text({at(x, y0_).x, corner_.y + h_ + 16.0}, text("%g", std::abs(x) < 1e-9 * dx_ ? 0.0 : x),
                Anchor::middle, "quiet");
    }
    for (double y = y0_; y <= y1_ + 0.01 * dy_; y += dy_) {
      svg_.line(at(x0_, y), at(x1_, y), "grid");
      if (heights_named)
        svg_.text({corner_.x - 8.0, at(x0_, y).y + 4.0}, text("%g", std::abs(y) < 1e-9 * dy_ ? 0.0 : y),
                  Anchor::end, "quiet");
    }
    svg_.polyline({at(x0_, y0_), at(x1_, y0_), at(x1_, y1_), at(x0_, y1_), at(x0_, y0_)}, "tick");
  }
  void heading(const char* words) {
    svg_.text({corner_.x, corner_.y - 12.0}, words, Anchor::start, "heading");
  }
  double left() const { return x0_; }
  double right() const { return x1_; }

 private:
  static void set(double lower, double upper, double parts, double& from, double& to, double& step) {
    if (!(upper - lower > 1e-9 * std::max(std::abs(upper), 1e-9)))
      lower -= 0.5 * std::max(1.0, std::abs(lower)), upper += 0.5;
    step = step_for(upper - lower, parts);
    from = step * std::floor(lower / step + 1e-9);
    to = step * std::ceil(upper / step - 1e-9);
  }
  SvgCanvas& svg_;
  Pixel corner_;
  double w_, h_;
  double x0_ = 0.0, x1_ = 1.0, dx_ = 1.0, y0_ = 0.0, y1_ = 1.0, dy_ = 1.0;
};

void draw_frame(SvgCanvas& svg, const CurvesPage& page, const Frame& frame, int place) {
  Plot plot(svg, {margin + place * (frame_width + gap), top}, frame_width, frame_height);
  double lower = 1e300, upper = -1e300;
  for (const Curve& curve : frame.curves)
    for (const FormAtDraft& f : page.curves)
      lower = std::min(lower, curve.value(f)), upper = std::max(upper, curve.value(f));
  plot.across(lower, upper);
  plot.up(0.0, page.curves.back().values.draft, 8.0);
  plot.grid(place == 0);
  plot.heading(frame.heading);
  const double draft = page.at_draft.values.draft;
  svg.line(plot.at(plot.left(), draft), plot.at(plot.right(), draft), "dwl");
  for (const Curve& curve : frame.curves) {
    std::vector<Pixel> line;
    for (const FormAtDraft& f : page.curves) line.push_back(plot.at(curve.value(f), f.values.draft));
    svg.polyline(line, curve.style);
  }
  double share = 0.82;
  for (const Curve& curve : frame.curves) {
    const auto& f =
        page.curves[static_cast<std::size_t>(share * static_cast<double>(page.curves.size() - 1))];
    svg.label(plot.at(curve.value(f), f.values.draft), curve.name, Anchor::start, "name",
              {{6, 4}, {6, -10}, {-34, 4}, {-34, -10}, {6, 18}, {-34, 18}});
    share -= 0.17;
  }
}

void draw_levers(SvgCanvas& svg, const CurvesPage& page) {
  if (page.levers.size() < 2) return;
  const auto lever = [&](const RightingLever& l) { return l.KN - page.KG * std::sin(l.heel); };
  Plot plot(svg, {margin, lower_top}, lever_width, lever_height);
  double lower = 0.0, upper = 0.0;
  for (const RightingLever& l : page.levers)
    lower = std::min(lower, lever(l)), upper = std::max(upper, lever(l));
  plot.across(0.0, degrees(page.levers.back().heel));
  plot.up(lower, upper, 6.0);
  plot.grid(true);
  const std::string words =
      page.KG > 0.0 ? text("Righting lever GZ [m] over heel [deg], KG %.4g m", page.KG)
                    : std::string("Lever about the keel KN [m] over heel [deg]; GZ = KN \u2212 KG sin(heel)");
  plot.heading(words.c_str());
  std::vector<Pixel> line;
  for (const RightingLever& l : page.levers) line.push_back(plot.at(degrees(l.heel), lever(l)));
  svg.polyline(line, "outline");
  for (const Pixel& p : line) svg.dot(p, 2.5, "point");
  if (page.KG <= 0.0) return;
  const double GM = page.at_draft.values.KM_T - page.KG;  // the tangent at the origin, GM per radian
  const double to = std::min(degrees(1.0), plot.right());
  svg.line(plot.at(0.0, 0.0),
           plot.at(to * std::min(1.0, upper / std::max(GM, 1e-9)),
                   GM * radians(to) * std::min(1.0, upper / std::max(GM, 1e-9))),
           "ray");
}

void draw_table(SvgCanvas& svg, const CurvesPage& page) {
  struct Column {
    const char *name, *unit;
    std::function<std::string(const FormAtDraft&)> cell;
  };
  const auto column = [](const char* name, const char* unit, const char* pattern, auto value) {
    return Column{name, unit, [=](const FormAtDraft& f) {
                    char out[32];
                    std::snprintf(out, sizeof out, pattern, value(f));
                    return std::string(out);
                  }};
  };
  const std::vector<Column> columns = {
      column("Draft", "m", "%.3f", [](const auto& f) { return f.values.draft; }),
      column("Volume", "m\u00b3", "%.1f", [](const auto& f) { return f.values.volume; }),
      column("Displ.", "t", "%.1f", [](const auto& f) { return f.values.displacement / 1e3; }),
      column("LCB", "% L", "%+.2f", [](const auto& f) { return f.lcb_percent; }),
      column("LCF", "% L", "%+.2f", [](const auto& f) { return f.lcf_percent; }),
      column("KB", "m", "%.3f", [](const auto& f) { return f.values.KB; }),
      column("KM_T", "m", "%.3f", [](const auto& f) { return f.values.KM_T; }),
      column("TPC", "t/cm", "%.2f", [](const auto& f) { return f.tonnes_per_cm; }),
      column("MCT", "t m/cm", "%.1f", [](const auto& f) { return f.moment_to_trim; }),
      column("Wetted", "m\u00b2", "%.0f", [](const auto& f) { return f.values.wetted_area; }),
      column("C_B", "", "%.3f", [](const auto& f) { return f.values.block_coefficient; }),
      column("C_P", "", "%.3f", [](const auto& f) { return f.prismatic_coefficient; }),
      column("C_M", "", "%.3f", [](const auto& f) { return f.midship_coefficient; }),
      column("C_W", "", "%.3f", [](const auto& f) { return f.values.waterplane_coefficient; })};
  const double left = margin + lever_width + 60.0,
               pitch = (width - margin - left) / static_cast<double>(columns.size());
  double y = lower_top - 12.0;
  const auto row = [&](const char* style, auto cell) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      svg.text({left + pitch * static_cast<double>(k + 1), y}, cell(columns[k]), Anchor::end, style);
  };
  row("heading", [](const Column& c) { return std::string(c.name); });
  y += 17.0;
  row("quiet", [](const Column& c) { return std::string(c.unit); });
  svg.line({left, y + 7.0}, {width - margin, y + 7.0}, "tick");
  y += 24.0;
  const std::size_t step = std::max<std::size_t>(1, (page.curves.size() - 1) / 10);
  for (std::size_t k = 0; k < page.curves.size(); k += step, y += 20.0)
    row("cell", [&](const Column& c) { return c.cell(page.curves[k]); });
  svg.line({left, y - 13.0}, {width - margin, y - 13.0}, "tick");
  y += 6.0;
  row("dwl-name", [&](const Column& c) { return c.cell(page.at_draft); });
}

}  // namespace

std::string curves_page_svg(const CurvesPage& page, DrawnFor reader) {
  SvgCanvas svg(width, height, lines_style(), page.title + ": curves of form", reader);
  svg.text({margin, 44.0}, page.title + ": curves of form", Anchor::start, "title");
  const Hydrostatics& h = page.at_draft.values;
  svg.text({margin, 68.0},
           text("At the design draught of %.3f m: waterline %.2f x %.2f m, %.1f m\u00b3, %.1f t in water of "
                "%.0f kg/m\u00b3. Even keel; "
                "moulded surface as meshed, without appendages that the mesh does not have.",
                h.draft, h.length, h.beam, h.volume, h.displacement / 1e3, page.water_density),
           Anchor::start, "quiet");
  svg.text({margin - 34.0, top - 30.0}, "Draft [m]", Anchor::start, "quiet");
  for (std::size_t k = 0; k < frames().size(); ++k) draw_frame(svg, page, frames()[k], static_cast<int>(k));
  draw_levers(svg, page);
  draw_table(svg, page);
  svg.text({margin, height - 22.0},
           "LCB and LCF from half the waterline's length, positive forward. MCT with BM_L for GM_L. C_P = "
           "volume / (L A_M), A_M at half "
           "the waterline's length. Levers at constant displacement without change of trim, watertight to "
           "the mesh's top.",
           Anchor::start, "quiet");
  return svg.svg();
}

}  // namespace icebow
