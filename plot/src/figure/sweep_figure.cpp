// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/sweep_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/plot/label.hpp"

namespace jounce {
namespace {

constexpr std::size_t most_panels = 8;
constexpr std::size_t most_lines = 4;
constexpr double same_figure = 1e-9;  // share of a figure: rounding

std::string label_of(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// An interval with a margin. Outliers beyond it would compress the rest.
struct Window {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void add(const std::vector<double>& all) {
    for (const double x : all)
      if (std::isfinite(x)) lo = std::min(lo, x), hi = std::max(hi, x);
  }
  [[nodiscard]] double room(double share) const { return lo < hi ? share * (hi - lo) : 0; }
  [[nodiscard]] bool near(double x) const {
    return lo > hi || (x >= lo - room(0.5) && x <= hi + room(0.5));
  }
  /// Points that are not drawn, so that the outermost do not stand on the frame.
  [[nodiscard]] Series margins(const Series& like) const {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {.label = like.label,
            .x = {lo - room(0.03), hi + room(0.03)},
            .y = {none, none},
            .style = like.style};
  }
};

/// Without the points that are far from the others, which are counted in the label.
Series near(Series series, const Window& x, const Window& y) {
  Series kept{.label = series.label, .style = series.style};
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!x.near(series.x[i]) || !y.near(series.y[i])) continue;
    kept.x.push_back(series.x[i]);
    kept.y.push_back(series.y[i]);
  }
  const std::size_t away = series.x.size() - kept.x.size();
  if (away > 0) kept.label += " (" + std::to_string(away) + " more far away)";
  return kept;
}

class Drawing {
 public:
  Drawing(const SweepSpec& spec, const SweepResult& result, const SweepSummary& summary)
      : spec_(spec), result_(result), summary_(summary) {
    figure_.title = spec.name.empty() ? spec.document.name : spec.name;
  }

  Figure front() {
    const std::size_t x = column_of(spec_, spec_.objectives[0].figure);
    figure_.x_label = label_of(spec_.given[x].name, spec_.given[x].unit);
    for (std::size_t o = 1; o < spec_.objectives.size(); ++o) {
      const std::size_t y = column_of(spec_, spec_.objectives[o].figure);
      Panel panel{.y_label = label_of(spec_.given[y].name, spec_.given[y].unit)};
      // The projection of a front of more than two objectives is not a line.
      Series best = of(summary_.front, x, y, "Pareto front",
                       spec_.objectives.size() > 2 ? Style::dots : Style::line);
      Series within = of(rows(Verdict::within), x, y, "within all limits", Style::dots);
      const auto limit = summary_.figures.empty() ? std::nullopt : summary_.figures[y].limit;
      Window along;
      Window across;
      for (const Series& each : {best, within}) along.add(each.x), across.add(each.y);
      along.add({spec_.given[x].value});
      across.add({spec_.given[y].value, limit.value_or(spec_.given[y].value)});
      Series broken =
          near(of(rows(Verdict::broken), x, y, "beyond a limit", Style::dots), along, across);
      along.add(broken.x);
      panel.series.push_back(along.margins(best));
      for (Series* each : {&best, &broken, &within})
        if (!each->x.empty()) panel.series.push_back(std::move(*each));
      panel.upper = limit;
      panel.markers.push_back({.x = spec_.given[x].value,
                               .y = spec_.given[y].value,
                               .text = "as given",
                               .hint = spec_.base.document().name,
                               .broken = !spec_.given_ok});
      figure_.panels.push_back(std::move(panel));
    }
    return std::move(figure_);
  }

  Figure shares() {
    figure_.x_label = "share of cases at or below [%]";
    const std::size_t combinations = spec_.cases() / spec_.samples;
    for (const std::size_t c : shown_columns()) {
      Panel panel = panel_of(c);
      if (combinations > 1 && combinations <= most_lines)
        for (std::size_t i = 0; i < combinations; ++i)
          panel.series.push_back(distribution(c, i * spec_.samples, spec_.samples,
                                              listed_text(spec_, i * spec_.samples)));
      else
        panel.series.push_back(distribution(c, 0, result_.rows.size(), "all cases"));
      figure_.panels.push_back(std::move(panel));
    }
    return std::move(figure_);
  }

  Figure over_parameter() {
    const SweepParameter& p = spec_.parameters.front();
    figure_.x_label = label_of(p.key, p.unit);
    const std::vector<Line> lines = lines_over_first();
    for (const std::size_t c : shown_columns()) {
      Panel panel = panel_of(c);
      std::vector<Series> drawn;
      for (const Line& line : lines) drawn.push_back(over_first(c, line));
      Window along;
      for (const Series& series : drawn) along.add(series.x);
      along.add({spec_.base.value(p.key)});
      panel.series.push_back(along.margins(drawn.front()));
      for (Series& series : drawn) panel.series.push_back(std::move(series));
      panel.markers.push_back({.x = spec_.base.value(p.key),
                               .y = spec_.given[c].value,
                               .text = "as given",
                               .broken = !spec_.given_ok});
      figure_.panels.push_back(std::move(panel));
    }
    return std::move(figure_);
  }

 private:
  [[nodiscard]] std::vector<std::size_t> rows(Verdict verdict) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < result_.rows.size(); ++i)
      if (result_.rows[i].verdict == verdict) all.push_back(i);
    return all;
  }

  [[nodiscard]] Series of(const std::vector<std::size_t>& which, std::size_t x, std::size_t y,
                          const std::string& label, Style style) const {
    Series series{.label = label, .style = style};
    for (const std::size_t i : which) {
      series.x.push_back(result_.rows[i].figures[x]);
      series.y.push_back(result_.rows[i].figures[y]);
    }
    return series;
  }

  /// Up to four values of a list, evenly spread, with its ends.
  static std::vector<double> spread_values(const std::vector<double>& all) {
    if (all.size() <= most_lines) return all;
    std::vector<double> some;
    for (std::size_t i = 0; i < most_lines; ++i)
      some.push_back(all[i * (all.size() - 1) / (most_lines - 1)]);
    return some;
  }

  /// The listed value of a parameter that is nearest to the value of the given spec.
  [[nodiscard]] double nearest_listed(const SweepParameter& p) const {
    const auto& all = std::get<Values>(p.how).all;
    const double given = spec_.base.value(p.key);
    return *std::min_element(all.begin(), all.end(), [&](double a, double b) {
      return std::abs(a - given) < std::abs(b - given);
    });
  }

  /// A line over the first parameter: one value of each other parameter, and the rows with these values.
  struct Line {
    std::string label;
    std::vector<double> others;
    std::vector<std::pair<double, std::size_t>> rows;  ///< value of the first parameter, row
  };

  /// The lines without their rows: all combinations of the other parameters, if there are at most four.
  /// Otherwise up to four values of the second parameter, with the other parameters as given. A value
  /// that all lines have is in the note instead of the labels.
  std::vector<Line> chosen_lines() {
    const std::size_t length = std::get<Values>(spec_.parameters.front().how).all.size();
    const bool draws_all = spec_.cases() <= length * most_lines;
    std::vector<Line> lines(1);
    for (std::size_t i = 1; i < spec_.parameters.size(); ++i) {
      const SweepParameter& p = spec_.parameters[i];
      const auto& all = std::get<Values>(p.how).all;
      const std::vector<double> drawn = draws_all ? all
                                        : i == 1  ? spread_values(all)
                                                  : std::vector{nearest_listed(p)};
      std::vector<Line> longer;
      for (const Line& line : lines)
        for (const double value : drawn) {
          Line& next = longer.emplace_back(line);
          next.others.push_back(value);
          if (drawn.size() > 1) next.label += (next.label.empty() ? "" : ", ") + text_of(p, value);
        }
      lines = std::move(longer);
      note_drawn(p, drawn, all.size());
    }
    return lines;
  }

  /// States the values that are drawn, if the legend does not show all values of the parameter.
  void note_drawn(const SweepParameter& p, const std::vector<double>& drawn, std::size_t of) {
    const std::string values = std::to_string(of) + " values";
    if (drawn.size() == 1)
      add_note(text_of(p, drawn.front()) + (of == 1 ? "" : " (1 of " + values + ")"));
    else if (drawn.size() < of)
      add_note(p.key + ": " + std::to_string(drawn.size()) + " of " + values + " drawn");
  }

  void add_note(const std::string& words) {
    figure_.x_note += (figure_.x_note.empty() ? "" : " · ") + words;
  }

  static std::string text_of(const SweepParameter& p, double value) {
    return p.key + " = " + short_number(value) + (p.unit.empty() ? "" : " " + superscripts(p.unit));
  }

  std::vector<Line> lines_over_first() {
    std::vector<Line> lines = chosen_lines();
    for (std::size_t r = 0; r < result_.rows.size(); ++r) {
      const auto numbers = spec_.numbers(result_.rows[r].number);
      for (Line& line : lines)
        if (std::equal(line.others.begin(), line.others.end(), numbers.begin() + 1,
                       [](double value, const auto& number) { return number.value == value; }))
          line.rows.emplace_back(numbers.front().value, r);
    }
    for (Line& line : lines) std::sort(line.rows.begin(), line.rows.end());
    return lines;
  }

  [[nodiscard]] Series over_first(std::size_t column, const Line& line) const {
    Series series{.label = line.label};
    for (const auto& [x, row] : line.rows) {
      series.x.push_back(x);
      series.y.push_back(result_.rows[row].figures[column]);
    }
    return series;
  }

  /// Columns with information: finite, and not the same in all cases.
  [[nodiscard]] std::vector<std::size_t> shown_columns() {
    std::vector<std::size_t> all;
    for (std::size_t c = 0; c < summary_.figures.size(); ++c) {
      const FigureSpread& f = summary_.figures[c];
      const double rounding = same_figure * std::max(std::abs(f.least), std::abs(f.greatest));
      if (std::isfinite(f.least) && std::isfinite(f.greatest) && f.greatest - f.least > rounding)
        all.push_back(c);
    }
    if (all.size() > most_panels) {
      const std::size_t more = all.size() - most_panels;
      add_note(std::to_string(more) + (more == 1 ? " more figure" : " more figures") +
               " vary: choose with `figures = [...]`");
      all.resize(most_panels);
    }
    return all;
  }

  [[nodiscard]] Panel panel_of(std::size_t column) const {
    const FigureSpread& f = summary_.figures[column];
    Panel panel{.y_label = label_of(f.given.name, f.given.unit), .upper = f.limit};
    if (f.given.name == "margin") panel.lower = 0;
    return panel;
  }

  [[nodiscard]] Series distribution(std::size_t column, std::size_t first, std::size_t count,
                                    const std::string& label) const {
    Series series{.label = label};
    for (std::size_t i = first; i < first + count; ++i)
      if (result_.rows[i].verdict != Verdict::impossible)
        series.y.push_back(result_.rows[i].figures[column]);
    std::sort(series.y.begin(), series.y.end());
    const auto n = static_cast<double>(series.y.size());
    for (std::size_t i = 0; i < series.y.size(); ++i)
      series.x.push_back(100 * (static_cast<double>(i) + 0.5) / n);
    return series;
  }

  const SweepSpec& spec_;
  const SweepResult& result_;
  const SweepSummary& summary_;
  Figure figure_;
};

}  // namespace

Figure sweep_figure(const SweepSpec& spec, const SweepResult& result, const SweepSummary& summary) {
  Drawing drawing(spec, result, summary);
  if (spec.objectives.size() > 1) return drawing.front();
  return spec.random() ? drawing.shares() : drawing.over_parameter();
}

SvgOptions sweep_look(const SweepSpec& spec) {
  SvgOptions options;
  if (spec.objectives.size() == 2) options.panel_height = 320;
  return options;
}

}  // namespace jounce
