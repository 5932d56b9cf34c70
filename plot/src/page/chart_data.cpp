// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/chart_data.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "jounce/design/output_events.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "plot/src/figure/input_look.hpp"

namespace jounce {
namespace {

using nlohmann::json;

constexpr std::size_t bytes_per_number = 20;  // 17 digits, sign, point, comma
constexpr std::size_t most_blocks = 4000;     // more than the pixels of a screen
constexpr std::size_t most_names = 2000;      // names of segments, names of shades
constexpr std::size_t orders = 4;             // value and three derivatives

json piece(const Segment& f) {
  json c = json::array();
  for (int k = 0; k <= f.degree; ++k) c.push_back(f.c[static_cast<std::size_t>(k)]);
  json all = json::array({f.length, std::move(c)});
  if (f.sines == 0) return all;
  json sines = json::array();
  for (int i = 0; i < f.sines; ++i) {
    const SineTerm& term = f.sine[static_cast<std::size_t>(i)];
    for (const double value : {term.amplitude, term.angle, term.phase}) sines.push_back(value);
  }
  all.push_back(std::move(sines));
  return all;
}

template <class Over>
std::size_t bytes_of_pieces(const Curve<Over>& curve) {
  std::size_t numbers = 0;
  for (const Segment& f : curve.segments())
    numbers += static_cast<std::size_t>(f.degree + 2 + 3 * f.sines);
  return bytes_per_number * numbers;
}

/// The exact extrema of blocks of segments.
template <class Over>
json outline(const Curve<Over>& curve, std::size_t blocks) {
  const std::size_t pieces = curve.segments().size();
  json edges = json::array({curve.start()});
  std::vector<json> low(orders, json::array());
  std::vector<json> high(orders, json::array());
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::size_t first = block * pieces / blocks;
    const std::size_t last = (block + 1) * pieces / blocks - 1;
    const Ranges ranges = segment_extrema(curve, first, last);
    edges.push_back(curve.breaks()[last + 1]);
    for (std::size_t k = 0; k < orders; ++k) {
      low[k].push_back(ranges[k].min.value);
      high[k].push_back(ranges[k].max.value);
    }
  }
  return {{"edges", std::move(edges)}, {"low", low}, {"high", high}, {"count", pieces}};
}

template <class Over>
json curve_json(const Curve<Over>& curve, const std::string& label, std::size_t most_bytes) {
  json out;
  if (bytes_of_pieces(curve) <= most_bytes) {
    json pieces = json::array();
    for (const Segment& f : curve.segments()) pieces.push_back(piece(f));
    out = {{"start", curve.start()}, {"pieces", std::move(pieces)}};
  } else {
    const std::size_t per_block = bytes_per_number * (2 * orders + 1);
    out = outline(curve, std::min({most_blocks, most_bytes / per_block, curve.segments().size()}));
  }
  out["label"] = label;
  return out;
}

json names_json(const std::vector<Shade>& names) {
  json out = json::array();
  if (names.size() > most_names) return out;
  for (const Shade& name : names) out.push_back({name.from, name.to, name.label});
  return out;
}

/// A number that JSON has; a limit or a mark that is not finite is left out.
json optional_json(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

json panel_json(const Panel& panel, const std::string& name, const PanelUnit& unit) {
  json marks = json::array();
  for (const Marker& mark : panel.markers) marks.push_back({mark.x, mark.y, mark.broken});
  return {{"name", name},
          {"unit", superscripts(unit.name)},
          {"size", unit.size},
          {"noise", panel.noise},
          {"lower", optional_json(panel.lower)},
          {"upper", optional_json(panel.upper)},
          {"marks", std::move(marks)}};
}

/// The intervals in which each output is on.
json on_intervals(const std::vector<OutputEvent>& events, double end) {
  std::map<std::string, json> rows;
  std::map<std::string, double> since;
  for (const OutputEvent& event : events) {
    json& row = rows.try_emplace(event.output, json::array()).first->second;
    const auto running = since.find(event.output);
    if (event.on) {
      since.try_emplace(event.output, event.time);
    } else if (running != since.end()) {
      row.push_back({running->second, event.time});
      since.erase(running);
    }
  }
  for (const auto& [output, start] : since) rows[output].push_back({start, end});
  json out = json::array();
  for (auto& [output, row] : rows) out.push_back({output, std::move(row)});
  return out;
}

/// The outputs of a spec over time: its [compare], or its [[switch]] while the [master] runs.
json outputs_of(const Input& input, double end) {
  const bool has_switches =
      input.spec && input.axis.empty() &&
      (input.spec->compare || (input.spec->over_master() && input.spec->master &&
                               !input.spec->switches.table.switches.empty()));
  if (!has_switches) return json::array();
  return on_intervals(output_events({input}).all, end);
}

/// The segments of an input as its reports call them.
std::vector<Shade> segments_of(const Input& input, std::span<const double> breaks) {
  std::vector<Shade> all;
  for (const auto& [label, first, last] : groups(breaks.size() - 1, input.labels))
    all.push_back({breaks[first], breaks[last + 1], label});
  return all;
}

/// One view. `of` is the input that has the outputs.
json view_json(const Input& input, const std::optional<Input>& before, std::size_t most_bytes,
               const Input& of) {
  const Figure figure = figure_of(input, before);
  const CurveLook look = look_of(input);
  json view = {{"axis", superscripts(figure.x_label)},
               {"note", figure.x_note},
               {"unit", superscripts(input.labels.units.x)},
               {"degrees", figure.degrees},
               {"shades", names_json(figure.shades)},
               {"laws", figure.strips.size() > 1 ? names_json(figure.strips[1]) : json::array()},
               {"panels", json::array()},
               {"curves", json::array()}};
  std::visit(
      [&]<class Over>(const Curve<Over>& curve) {
        for (std::size_t k = 0; k < orders; ++k)
          view["panels"].push_back(
              panel_json(figure.panels[k], Over::names[k], panel_unit(look, static_cast<int>(k))));
        view["segments"] = names_json(segments_of(input, curve.breaks()));
        view["outputs"] = input.labels.over_master ? json::array() : outputs_of(of, curve.end());
        view["curves"].push_back(curve_json(curve, input.name, most_bytes));
        if (!before) return;
        const Curve<Over>& other = std::get<Curve<Over>>(*before->curve);
        const std::string label = before->name == input.name ? "before" : before->name;
        view["curves"].push_back(curve_json(in_units_of(input, *before, other), label, most_bytes));
      },
      *input.curve);
  return view;
}

/// The slave over time; nullopt without a [master], or if the slave has no motion for this master.
/// The report of such a spec has its findings, and only this view is missing.
std::optional<Input> slave_of(const Input& input) {
  if (!std::holds_alternative<Cam>(*input.curve) || !input.spec || !input.spec->master)
    return std::nullopt;
  try {
    return over_time(input);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string chart_data(const Input& input, const std::optional<Input>& before) {
  const std::optional<Input> slave = slave_of(input);
  const std::size_t curves = (slave ? std::size_t{2} : 1) * (before ? 2 : 1);
  const std::size_t each = most_chart_bytes / curves;
  json views = json::array({view_json(input, before, each, input)});
  if (slave)
    views.push_back(view_json(*slave, before ? slave_of(*before) : std::nullopt, each, input));
  return json{{"name", input.name}, {"views", std::move(views)}}.dump(
      -1, ' ', false, json::error_handler_t::replace);
}

}  // namespace jounce
