// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "jounce/plot/label.hpp"

#include "plot/src/figure/panel.hpp"
#include "plot/src/figure/style.hpp"
#include "plot/src/figure/text.hpp"

namespace jounce {
namespace {

constexpr double margin = 8;         // px, around everything
constexpr double title_height = 24;  // px, of the rows that a figure may have
constexpr double legend_height = 20;
constexpr double header_height = 22;  // the y label above its panel
constexpr double strip_height = 14;   // names of shades, positions of knots
constexpr double least_name = 30;     // least width of a named interval
constexpr double axis_height = 20;
constexpr double panel_gap = 6;

struct Entry {
  std::string label;
  std::string kind;
  double x = 0;
  double y = 0;
};

PlotRange x_extent(const Figure& figure) {
  PlotRange extent;
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series)
      for (const double x : series.x) extent.add(x);
  }
  return axis_extent(extent);
}

double widest(const std::vector<std::string>& labels) {
  double width = 0;
  for (const std::string& label : labels) width = std::max(width, text_width(label, small_font));
  return width;
}

/// The greatest number of ticks that fit on `width` px.
Ticks x_ticks(const Figure& figure, PlotRange extent, double width) {
  const auto of = figure.degrees ? angle_ticks : figure.decades ? decade_ticks : ticks;
  for (int most = figure.decades ? 20 : 12; most > 1; --most) {
    Ticks found = of(extent, most);
    const double needed = (widest(found.labels) + 14) * static_cast<double>(found.at.size());
    if (needed <= width) return found;
  }
  return of(extent, 1);
}

/// One entry a label, in rows; none if there is only one series.
std::vector<Entry> legend(const Figure& figure, double left, double right) {
  std::vector<Entry> entries;
  const auto labels = line_labels(figure);
  for (const Panel& panel : figure.panels) {
    for (const Series& series : panel.series) {
      const std::string kind = series_class(series, labels);
      const auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) {
        return e.label == series.label && e.kind == kind;
      });
      if (same == entries.end()) entries.push_back({series.label, kind, 0, 0});
    }
  }
  if (entries.size() < 2) return {};
  double x = left;
  double y = 0;
  for (Entry& entry : entries) {
    entry.label = fitted(entry.label, small_font, right - left - 32);
    const double width = 32 + text_width(entry.label, small_font);
    if (x > left && x + width > right) {
      x = left;
      y += legend_height;
    }
    entry.x = x;
    entry.y = y;
    x += width + 18;
  }
  return entries;
}

/// The number of a name such as "line 38"; "" if the name has another form.
std::string number_of(const std::string& name) {
  const std::size_t blank = name.find(' ');
  if (blank == std::string::npos || blank + 1 == name.size()) return "";
  const std::string number = name.substr(blank + 1);
  return number.find_first_not_of("0123456789") == std::string::npos ? number : "";
}

/// A name over its interval, shortened to its width where allowed; nothing where that is too narrow.
struct Name {
  std::string label;
  double middle = 0;
};
std::optional<Name> fitted_name(const Shade& name, const Scale& x, bool may_be_cut) {
  const double from = x(std::max(name.from, x.of.lo));
  const double to = x(std::min(name.to, x.of.hi));
  const std::string label = fitted(name.label, small_font, to - from - 6);
  const std::string number = label == name.label || !may_be_cut ? "" : number_of(name.label);
  if (!number.empty()) {  // the end of the name differs, not its start
    if (text_width(number, small_font) > to - from - 2) return std::nullopt;
    return Name{number, (from + to) / 2};
  }
  if (label.empty() || to - from < least_name || (label != name.label && !may_be_cut))
    return std::nullopt;
  return Name{label, (from + to) / 2};
}

/// The rows of names of which something is shown.
std::vector<const std::vector<Shade>*> drawn_strips(const Figure& figure, const Scale& x) {
  std::vector<const std::vector<Shade>*> rows;
  for (const auto& row : figure.strips)
    if (std::any_of(row.begin(), row.end(), [&](const Shade& name) {
          return fitted_name(name, x, rows.empty()).has_value();
        }))
      rows.push_back(&row);
  return rows;
}

/// The names beside the shades that fit their ranges.
std::vector<Name> drawn_names(const Figure& figure, const Scale& x) {
  constexpr double room = 4;  // px, beside a name
  std::vector<Name> drawn;
  for (const Shade& name : figure.names) {
    const double from = x(std::max(name.from, x.of.lo));
    const double to = x(std::min(name.to, x.of.hi));
    if (text_width(name.label, small_font) + room <= to - from)
      drawn.push_back({name.label, (from + to) / 2});
  }
  return drawn;
}

/// The knots whose numbers are drawn.
std::vector<double> numbered_knots(const Figure& figure, const Scale& x) {
  return figure.names.empty() ? drawn_knots(figure, x) : std::vector<double>{};
}

/// Places of all parts.
struct Layout {
  double left = 0;
  double right = 0;
  double height = 0;
  std::vector<PanelAxis> axes;
  std::vector<Rectangle> plots;
  double strip_top = 0;  ///< top of the first panel's strip
  Scale x;
  Ticks x_ticks;
  std::vector<Entry> legend;
  std::vector<const std::vector<Shade>*> strips;
  std::vector<Name> names;
  bool shade_names = false;  ///< true if shades and the ranges beside them have a separate row
};

Layout lay_out(const Figure& figure, const SvgOptions& options) {
  Layout at;
  double widest_tick = 0;
  for (const Panel& panel : figure.panels) {
    at.axes.push_back(panel_axis(panel, options.panel_height));
    widest_tick = std::max(widest_tick, widest(at.axes.back().ticks.labels));
  }
  at.left = margin + widest_tick + 8;
  const PlotRange extent = x_extent(figure);
  at.x_ticks = x_ticks(figure, extent, options.width - at.left - 40);
  const double last_label = at.x_ticks.labels.empty() ? 0 : widest(at.x_ticks.labels);
  at.right = std::max(at.left + 10, options.width - margin - std::max(4.0, last_label / 2));
  at.x = {extent, at.left, at.right};
  at.legend = legend(figure, at.left, at.right);

  double y = margin + (figure.title.empty() ? 0 : title_height);
  if (!at.legend.empty()) y = y + at.legend.back().y + legend_height;
  at.strip_top = y + header_height;
  at.strips = drawn_strips(figure, at.x);
  at.names = drawn_names(figure, at.x);
  at.shade_names = !(figure.shades.empty() && at.names.empty()) && at.strips.empty();
  const std::size_t rows =
      at.strips.size() + (at.shade_names ? 1 : 0) + (numbered_knots(figure, at.x).empty() ? 0 : 1);
  const double strips = strip_height * static_cast<double>(rows);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const double top = y + header_height + (i == 0 ? strips : 0);
    at.plots.push_back({at.left, top, at.right, top + options.panel_height});
    y = top + options.panel_height + panel_gap;
  }
  at.height = y + axis_height + (figure.x_label.empty() ? 0 : axis_height - 4) + margin - 4;
  return at;
}

void text(std::string& out, const char* kind, double x, double y, const std::string& content) {
  out += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, coordinate(x),
                     coordinate(y), escaped(content));
}

void draw_legend(std::string& out, const Layout& at, double top) {
  for (const Entry& entry : at.legend) {
    const double y = top + entry.y + 10;
    const bool dots = entry.kind.starts_with("dots");
    out += fmt::format("<path class=\"{}\" d=\"M{} {}h{}\"/>\n", entry.kind,
                       coordinate(dots ? entry.x + 12 : entry.x), coordinate(y), dots ? 0 : 24);
    text(out, "soft", entry.x + 32, y + 4, entry.label);
  }
}

/// The names of stretches or shades and the positions of knots, above the first panel.
void draw_strips(std::string& out, const Figure& figure, const Layout& at) {
  double row = at.strip_top;
  for (const auto* names : at.strips) {
    const bool first = names == at.strips.front();
    for (const Shade& name : *names)
      if (const auto shown = fitted_name(name, at.x, first))
        text(out, first ? "mid" : "soft mid", shown->middle, row + strip_height - 4, shown->label);
    row += strip_height;
  }
  const auto write = [&](double x, const std::string& label, const char* kind,
                         Surroundings& around) {
    const double width = text_width(label, small_font);
    const double left = std::clamp(x - width / 2, at.left, std::max(at.left, at.right - width));
    const Rectangle box{left - 3, row, left + width + 3, row + strip_height};
    if (!place(around, {&box, 1})) return;
    around.taken.push_back(box);
    text(out, kind, left + width / 2, row + strip_height - 4, label);
  };
  const Rectangle row_frame{-4, 0, at.right + 4, at.height};
  if (at.shade_names) {
    Surroundings around{row_frame, {}, {}};
    for (const Shade& shade : figure.shades) {
      const double middle = at.x(std::clamp((shade.from + shade.to) / 2, at.x.of.lo, at.x.of.hi));
      write(middle, fitted(shade.label, small_font, at.right - at.left), "zonetext mid", around);
    }
    for (const Name& name : at.names) write(name.middle, name.label, "soft mid", around);
    row += strip_height;
  }
  Surroundings around{row_frame, {}, {}};
  for (const double knot : numbered_knots(figure, at.x))
    write(at.x(knot), short_number(knot / std::pow(10.0, at.x_ticks.exponent)), "soft mid", around);
}

void draw_x_axis(std::string& out, const Figure& figure, const Layout& at) {
  if (at.plots.empty()) return;
  std::string d;
  for (const Rectangle& plot : at.plots) {
    for (const double tick : at.x_ticks.at)
      d += fmt::format("M{} {}v4", coordinate(at.x(tick)), coordinate(plot.bottom));
  }
  out += fmt::format("<path class=\"frame\" d=\"{}\"/>\n", d);
  const double bottom = at.plots.back().bottom;
  for (std::size_t i = 0; i < at.x_ticks.at.size(); ++i)
    text(out, "soft mid", at.x(at.x_ticks.at[i]), bottom + 16, at.x_ticks.labels[i]);
  std::string label = with_factor(superscripts(figure.x_label), at.x_ticks.exponent);
  if (!figure.x_note.empty()) label += " · " + figure.x_note;
  if (figure.knots.size() > 2 && drawn_knots(figure, at.x).empty())
    label += fmt::format(" · {} knots, too dense to draw", figure.knots.size());
  text(out, "label mid", (at.left + at.right) / 2, bottom + 34,
       fitted(label, label_font, at.right - at.left));
}

/// Text of a figure for screen readers: "velocity [mm/s]: 2.1 at 42, −3.39 at 241.9; ...", the most
/// important marked values of each panel.
std::string description(const Figure& figure) {
  constexpr std::size_t most = 2;  // the least and the greatest value
  std::string out = figure.title;
  for (const Panel& panel : figure.panels) {
    std::string values;
    for (std::size_t i = 0; i < std::min(most, panel.markers.size()); ++i)
      values += fmt::format("{}{} at {}", values.empty() ? ": " : ", ", panel.markers[i].text,
                            short_number(panel.markers[i].x));
    if (!values.empty()) out += (out.empty() ? "" : "; ") + panel.y_label + values;
  }
  return out;
}

std::string opening(const Figure& figure, const SvgOptions& options, double height) {
  const std::string width = coordinate(options.width);
  const std::string size =
      options.inlined ? "" : fmt::format(R"( width="{}" height="{}")", width, coordinate(height));
  std::string name = options.inlined ? description(figure) : figure.title;
  if (name.empty()) name = "plot";
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"jf\"{} viewBox=\"0 0 {} {}\" "
      "role=\"img\" aria-label=\"{}\">\n",
      size, width, coordinate(height), escaped(superscripts(name)));
  if (options.inlined) return out;
  return out + "<style>" + figure_style() + "</style>\n" +
         fmt::format("<path class=\"paper\" d=\"M0 0h{}v{}H0z\"/>\n", width, coordinate(height));
}

}  // namespace

std::string svg(const Figure& figure, const SvgOptions& options) {
  const Layout at = lay_out(figure, options);
  std::string out = opening(figure, options, at.height);
  if (!figure.title.empty()) {
    text(out, "title", at.left, margin + 14,
         fitted(superscripts(figure.title), 1.06 * title_font, at.right - at.left));
  }
  draw_legend(out, at, margin + (figure.title.empty() ? 0 : title_height));
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Rectangle& plot = at.plots[i];
    const double shade_top = i == 0 ? at.strip_top : plot.top;
    draw_panel(out, figure, figure.panels[i], at.axes[i], {plot, at.x, shade_top});
  }
  draw_strips(out, figure, at);
  draw_x_axis(out, figure, at);
  return out + "</svg>\n";
}

}  // namespace jounce
