// SPDX-License-Identifier: Apache-2.0
// [load], and the keys of [optimize] for free shapes.
#include <array>
#include <utility>

#include "jounce/base/units.hpp"

#include "spec/src/cams/shape_figures.hpp"
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

ShapeWords words_of(const Spec& spec) {
  ShapeWords words{spec.units, spec.time_unit, {}, conversion(spec.time_unit, "s"), nullptr};
  if (spec.master) words.speed = spec.master->velocity;
  if (spec.optimize.shape.load) words.load = &*spec.optimize.shape.load;
  return words;
}

void read_ordered(TomlReader& table, const ShapeWords& words, ShapeSpec& shape) {
  for (const std::string& name : table.texts("minimize")) {
    shape.figures.push_back(figure_named(table, "minimize", name, words));
    shape.minimize.push_back({{shape.figures.back().figure, 1}});
  }
}

void read_weighted(TomlReader& table, const ShapeWords& words, ShapeSpec& shape) {
  shape.minimize.emplace_back();
  for (TomlReader& each : table.tables("minimize")) {
    shape.figures.push_back(read_figure(each, words));
    const double weight = each.optional_number("weight", "1").value_or(1);
    if (!(weight > 0)) each.fail("weight", number(weight), "must be greater than 0");
    shape.minimize.back().push_back({shape.figures.back().figure, weight});
    each.finish();
  }
}

void read_ceilings(TomlReader& table, const ShapeWords& words, ShapeSpec& shape) {
  for (TomlReader& each : table.tables("ceiling")) {
    const ShapeFigureSpec figure = read_figure(each, words);
    if (figure.times_length)
      each.fail("figure", '"' + figure.name + '"',
                "cannot have a limit: limit \"motor heating\" instead");
    const double at_most = each.number("at_most", figure.unit);
    if (!(at_most > 0)) each.fail("at_most", number(at_most), "must be greater than 0");
    shape.ceilings.push_back({figure.figure, computed(figure, at_most)});
    shape.figures.push_back(figure);
    each.finish();
  }
}

std::optional<Edge> read_edge(TomlReader& each, const char* key, const std::string& unit) {
  const auto ends = each.optional_range(key, unit);
  if (!ends) return std::nullopt;
  return Edge{ends->first, ends->second};
}

/// Reads `value` and `tolerance`; without a tolerance the value is exact.
void read_value(TomlReader& each, const std::string& unit, Corridor& corridor) {
  const auto value = read_edge(each, "value", unit);
  const double tolerance = each.optional_number("tolerance", unit).value_or(0);
  if (!(tolerance >= 0)) each.fail("tolerance", number(tolerance), "must not be negative");
  if (!value) {
    if (tolerance != 0)
      each.fail("tolerance", number(tolerance), "needs a value: add value = NUMBER");
    return;
  }
  if (corridor.lower || corridor.upper)
    each.fail("value", "", "cannot be combined with lower or upper: give the value, or the bounds");
  corridor.lower = Edge{value->at_from - tolerance, value->at_to - tolerance};
  corridor.upper = Edge{value->at_from + tolerance, value->at_to + tolerance};
}

Corridor read_corridor(TomlReader& each, const ShapeWords& words) {
  Corridor corridor;
  const std::string name = each.optional_text("quantity").value_or("slave");
  const NamedQuantity named = quantity_named(each, "quantity", name, words);
  corridor.quantity = named.quantity;
  if (const auto at = each.optional_number("at", words.units.x)) {
    if (each.has("from") || each.has("to"))
      each.fail("at", number(*at),
                "cannot be combined with from and to: give one place, or a range");
    corridor.from = corridor.to = *at;
  } else {
    corridor.from = each.number("from", words.units.x);
    corridor.to = each.number("to", words.units.x);
  }
  if (corridor.from > corridor.to)
    each.fail("from", number(corridor.from),
              "must be at most to = " + number(corridor.to) + " " + words.units.x +
                  ": write a corridor across the end of a periodic cam as two corridors");
  corridor.lower = read_edge(each, "lower", named.unit);
  corridor.upper = read_edge(each, "upper", named.unit);
  read_value(each, named.unit, corridor);
  if (!corridor.lower && !corridor.upper)
    each.fail("lower", "", "is missing: a corridor needs a lower bound, an upper bound or a value");
  if (corridor.lower && corridor.upper &&
      (corridor.lower->at_from > corridor.upper->at_from ||
       corridor.lower->at_to > corridor.upper->at_to))
    each.fail("lower", number(corridor.lower->at_from),
              "must not be above upper = " + number(corridor.upper->at_from) +
                  " anywhere in the corridor");
  each.finish();
  return corridor;
}

bool is_list_of_tables(TomlReader& table) {
  return table.has("minimize") && table.holds_tables("minimize");
}

/// Reads { jerk = "free" } or { jerk = 0 }.
EndJerk read_end_jerk(TomlReader& ends) {
  EndJerk jerk = EndJerk::as_given;
  if (ends.is_text("jerk")) {
    const std::string word = ends.text("jerk");
    if (word != "free") ends.fail("jerk", '"' + word + '"', "must be \"free\" or 0");
    jerk = EndJerk::free;
  } else {
    const double value = ends.number("jerk", "1");
    if (value != 0) ends.fail("jerk", number(value), "must be \"free\" or 0");
    jerk = EndJerk::zero;
  }
  ends.finish();
  return jerk;
}

}  // namespace

void read_free_shape(TomlReader& free, std::size_t segment, ShapeSpec& shape) {
  const auto pieces = free.optional_count("shape");
  if (!pieces) {
    for (const char* key : {"continuity", "monotone", "ends"})
      if (free.has(key)) free.fail(key, "", "needs a free shape: add shape = 100");
    return;
  }
  FreeShape found{.segment = segment, .pieces = *pieces};
  if (found.pieces > 2000)
    free.fail("shape", std::to_string(found.pieces), "must be 1 to 2000 pieces");
  if (const auto continuity = free.optional_count("continuity")) {
    if (*continuity < 2 || *continuity > 6)
      free.fail("continuity", std::to_string(*continuity),
                "must be 2 to 6, the number of continuous derivatives inside");
    found.continuity = static_cast<int>(*continuity);
  }
  found.monotone = free.optional_flag("monotone").value_or(false);
  if (auto ends = free.optional_table("ends")) found.end_jerk = read_end_jerk(*ends);
  shape.shapes.push_back(found);
}

void read_shape_optimize(TomlReader& table, Spec& spec) {
  ShapeSpec& shape = spec.optimize.shape;
  const ShapeWords words = words_of(spec);
  if (is_list_of_tables(table))
    read_weighted(table, words, shape);
  else
    read_ordered(table, words, shape);
  if (shape.minimize.empty() || shape.minimize.front().empty())
    table.fail("minimize", "",
               "is missing: name a figure of the free shapes, such as [\"peak geo_jerk\"]");
  read_ceilings(table, words, shape);
  for (TomlReader& each : table.tables("corridor"))
    shape.corridors.push_back(read_corridor(each, words));
  shape.refine = table.optional_flag("refine").value_or(false);
  spec.optimize.seconds = read_budget(table);
  spec.optimize.seed = table.optional_count("seed");
  spec.optimize.tolerance = table.optional_number("tolerance", "1");
  if (const auto t = spec.optimize.tolerance; t && !(*t >= 0 && *t <= 1))
    table.fail("tolerance", number(*t), "must be between 0 and 1");
}

}  // namespace jounce::spec_detail
