// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/knot_arrays.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::controllers_detail {
namespace {

/// Fields of a type, for a message: "dX, dY, dV, dA".
std::string fields_text(const KnotType& type) {
  std::string text;
  const auto add = [&](std::string_view field) {
    if (!field.empty()) text += (text.empty() ? "" : ", ") + std::string(field);
  };
  std::for_each(type.fields.begin(), type.fields.end(), add);
  std::for_each(type.others.begin(), type.others.end(), add);
  return text;
}

/// The knots of a file, read one word after another.
class Reader {
 public:
  Reader(const std::string& text, const KnotType& type, const Place& place)
      : code_(text, place), type_(type), place_(place) {}

  std::vector<KnotArray> read() {
    std::string name;    // the word before the last colon
    std::string before;  // the last word
    for (std::string word = code_.name(); !word.empty(); before = word, word = code_.name()) {
      if (word == ":") name = before;
      if (lower(word) == "array") declared(name);
      if (word == "[") element(before);
      if (word == ":=") constant(before);
    }
    for (auto& [array, elements] : assigned_) take(array, elements);
    return std::move(all_);
  }

 private:
  struct Assigned {
    std::map<std::int64_t, Knot> elements;
    std::size_t at = 0;
    int line = 0;
  };

  /// Behind ARRAY: an array of the type is a cam, every other is skipped.
  void declared(const std::string& name) {
    const StReader::Mark range = code_.here();
    std::string word = code_.next();
    while (word != "of" && word != ";" && !word.empty()) word = code_.next();
    if (word != "of") return;
    std::string of = unqualified(code_.next());
    std::erase(of, '"');  // TIA Portal writes a data type in quotes
    if (lower(of) != lower(type_.name)) return;
    if (code_.peek() == ";" && assigns()) return;
    const StReader::Mark values = code_.here();
    code_.go_to(range);
    const double points = points_of_range();
    code_.go_to(values);
    KnotArray array{.name = name};
    initial_values(array);
    if (points != static_cast<double>(array.knots.size()))
      code_.fail("ARRAY", jounce::number(points) + " points",
                 "there are " + std::to_string(array.knots.size()) + ": is the file complete?");
    array.at = code_.here().at;
    all_.push_back(std::move(array));
  }

  /// True if elements are assigned later in the file.
  bool assigns() {
    const StReader::Mark here = code_.here();
    bool found = false;
    const std::string field = "." + lower(type_.fields[0]);
    for (std::string word = code_.next(); !word.empty() && !found; word = code_.next())
      found = word == field;
    code_.go_to(here);
    return found;
  }

  /// Number of points of `[0..4]`.
  double points_of_range() {
    code_.expect("[");
    const double first = code_.number("ARRAY");
    code_.expect("..");
    const double last = code_.number("ARRAY");
    code_.expect("]");
    return last - first + 1;
  }

  /// `[(...), (...)]`; in CoDeSys 2.3 without the brackets.
  void initial_values(KnotArray& array) {
    if (code_.peek() == ";") code_.fail("points", "", "are missing: give the array initial values");
    code_.expect(":=");
    const bool bracket = code_.peek() == "[";
    if (bracket) code_.expect("[");
    for (std::string sign = ","; sign == ",";) {
      element_or_repetition(array);
      sign = code_.next();
      if (sign != "," && sign != (bracket ? "]" : ";"))
        code_.fail("points", sign,
                   sign.empty() ? "are not complete: the file ends here"
                                : std::string("must be `,` or `") + (bracket ? "]`" : ";`"));
    }
  }

  /// `(dX := 0, ...)`, or as often as a number before it states: `2((dX := 0, ...))`.
  void element_or_repetition(KnotArray& array) {
    constexpr std::int64_t most = 32767;  // the greatest INT
    const auto count = whole(code_.peek());
    if (count) {
      if (*count < 1 || *count > most)
        code_.fail("points", std::to_string(*count),
                   "is a number of repetitions: it must be from 1 to " + std::to_string(most));
      static_cast<void>(code_.next());
      code_.expect("(");
    }
    code_.expect("(");
    array.knots.insert(array.knots.end(), static_cast<std::size_t>(count.value_or(1)), structure());
    if (count) code_.expect(")");
  }

  /// `dX := 0, dY := 0, ...)` after its parenthesis.
  Knot structure() {
    Knot element;
    element.line = code_.line();
    for (std::string sign = ","; sign == ",";) {
      const std::string word = code_.next();
      code_.expect(":=");
      field(word, element);
      sign = code_.next();
      if (sign != "," && sign != ")")
        code_.fail("point", sign,
                   sign.empty() ? "is not complete: the file ends here" : "must be `,` or `)`");
    }
    return element;
  }

  /// The value of one field, after its `:=`.
  void field(const std::string& word, Knot& element) {
    const auto is_word = [&](std::string_view name) {
      return !name.empty() && lower(name) == word;
    };
    const auto field = std::find_if(type_.fields.begin(), type_.fields.end(), is_word);
    if (field != type_.fields.end()) {
      const auto i = static_cast<std::size_t>(field - type_.fields.begin());
      if (std::exchange(element.given[i], true))
        code_.fail(std::string(*field), "", "is given twice: remove one");
      element.values[i] = code_.number(std::string(*field));
      return;
    }
    const auto other = std::find_if(type_.others.begin(), type_.others.end(), is_word);
    if (other == type_.others.end())
      code_.fail("point", word, "must be one of " + fields_text(type_));
    std::string value = code_.name();
    if (const auto known = constants_.find(lower(value)); known != constants_.end())
      value = std::to_string(known->second);
    element.others[std::string(*other)] = unqualified(value);
  }

  /// Behind `name[`: `2].leadingValue := 120.0;`. Anything else is not an element of a cam.
  void element(const std::string& array) {
    const StReader::Mark here = code_.here();
    const auto index = whole(code_.next());
    const bool closes = code_.next() == "]";
    const std::string member = code_.next();
    const std::string name = member.empty() ? "" : member.substr(1);
    if (!index || !closes || !member.starts_with('.') || !has(name) || code_.peek() != ":=") {
      code_.go_to(here);
      return;
    }
    code_.expect(":=");
    Assigned& assigned = assigned_[array];
    Knot& element = assigned.elements[*index];
    if (element.line == 0) element.line = code_.line();
    assigned.line = code_.line();
    field(name, element);
    if (const std::string end = code_.next(); end != ";")
      code_.fail("point", end,
                 "must be `;`" + std::string(end.empty() ? ": is the file complete?" : ""));
    assigned.at = code_.here().at;
  }

  /// Behind `i :=`: a whole number is the value of a variable until its next assignment.
  void constant(const std::string& variable) {
    const StReader::Mark here = code_.here();
    const auto value = whole(code_.next());
    const bool ends = code_.next() == ";";
    code_.go_to(here);
    if (value && ends) constants_[lower(variable)] = *value;
  }

  void take(const std::string& name, const Assigned& assigned) {
    KnotArray array{.name = name, .at = assigned.at};
    std::int64_t next = assigned.elements.begin()->first;
    for (const auto& [index, element] : assigned.elements) {
      if (index != next++)
        place_.fail(element.line, name + "[" + std::to_string(next - 1) + "]", "",
                    "is missing: the elements must have consecutive numbers");
      array.knots.push_back(element);
    }
    all_.push_back(std::move(array));
  }

  [[nodiscard]] bool has(const std::string& word) const {
    const auto is_word = [&](std::string_view name) {
      return !name.empty() && lower(name) == word;
    };
    return std::any_of(type_.fields.begin(), type_.fields.end(), is_word) ||
           std::any_of(type_.others.begin(), type_.others.end(), is_word);
  }

  /// A whole number, or the value of a variable.
  [[nodiscard]] std::optional<std::int64_t> whole(const std::string& word) const {
    if (const auto known = constants_.find(word); known != constants_.end()) return known->second;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
  }

  StReader code_;
  const KnotType& type_;
  const Place& place_;
  std::vector<KnotArray> all_ = {};
  std::map<std::string, Assigned> assigned_ = {};
  std::map<std::string, std::int64_t> constants_ = {};
};

}  // namespace

std::string unqualified(const std::string& name) {
  return name.substr(name.find_last_of('.') + 1);
}

std::string word_of(const Knot& knot, const char* field) {
  const auto found = knot.others.find(field);
  return found == knot.others.end() ? "" : lower(found->second);
}

bool is_line(const Knot& from, const Knot& to) {
  constexpr double omitted_digits = 1e-9;  // digits of a slope that a program leaves out
  const auto [x0, p0, v0, a0] = from.values;
  const auto [x1, p1, v1, a1] = to.values;
  const double slope = (p1 - p0) / (x1 - x0);
  const double near = omitted_digits * std::max(std::abs(slope), 1.0);
  return a0 == 0 && a1 == 0 && std::abs(v0 - slope) <= near && std::abs(v1 - slope) <= near;
}

std::string real_literal(double value) {
  std::string text = number(value);
  if (text.find('.') != text.npos) return text;
  const auto e = text.find('e');
  return text.insert(e == text.npos ? text.size() : e, ".0");
}

std::vector<KnotArray> knot_arrays(const std::string& text, const KnotType& type,
                                   const Place& place) {
  return Reader(text, type, place).read();
}

Exchanged cam_of_knots(const KnotArray& array, const KnotType& type, Interpolation rule) {
  Exchanged cam{.name = array.name, .rule = rule};
  const std::array columns{&cam.columns.x, &cam.columns.p, &cam.columns.v, &cam.columns.a};
  for (const Knot& knot : array.knots) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (!type.fields[i].empty()) columns[i]->push_back(knot.values[i]);
    cam.lines.push_back(knot.line);
  }
  return cam;
}

std::string knots_text(const Columns& columns, const KnotType& type) {
  const std::array all{&columns.x, &columns.p, &columns.v, &columns.a};
  const std::size_t n = columns.x.size();
  std::string text;
  for (std::size_t knot = 0; knot < n; ++knot) {
    text += "    (";
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!type.fields[i].empty())
        text += (i == 0 ? "" : ", ") + std::string(type.fields[i]) +
                " := " + real_literal((*all[i])[knot]);
    text += knot + 1 < n ? "),\n" : ")\n";
  }
  return text;
}

bool declares_array(const std::string& text, std::string_view type) {
  const std::string code = lower(text);
  for (std::size_t at = code.find(type); at != code.npos; at = code.find(type, at + 1)) {
    std::string_view before = std::string_view(code).substr(0, at);
    while (!before.empty() && (before.back() == '.' || before.back() == '_' ||
                               std::isalnum(static_cast<unsigned char>(before.back())) != 0))
      before.remove_suffix(1);  // the name of a library
    const std::string_view words = before.substr(0, before.find_last_not_of(" \t\r\n") + 1);
    if (words.size() < before.size() && words.ends_with("of")) return true;
  }
  return false;
}

}  // namespace jounce::controllers_detail
