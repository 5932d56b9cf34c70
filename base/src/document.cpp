// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/document.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "jounce/base/units.hpp"

namespace jounce {
namespace {

bool is_pure(const std::string& unit) {
  return unit.empty() || unit == "1";
}

/// The unit in which the text gives the number of a key, and the factor to it.
struct Measure {
  std::string unit;
  double factor = 1;
};

std::optional<Measure> measure_of(const Document& document, const std::string& key) {
  if (const auto noun = document.nouns.find(key); noun != document.nouns.end())
    return is_pure(noun->second) ? std::nullopt : std::optional(Measure{noun->second});
  auto unit = document.units.find(key);
  if (unit == document.units.end()) {
    unit = document.known.find(key);
    if (unit == document.known.end()) return std::nullopt;
  }
  if (is_pure(unit->second)) return std::nullopt;
  std::string given = document.given_unit(key, unit->second);
  if (!is_convertible(unit->second, given)) given = unit->second;
  return Measure{given, given == unit->second ? 1 : conversion(unit->second, given)};
}

/// Twelve digits hide the rounding of a change of unit.
std::string converted_text(double value) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 12);
  std::from_chars(text.data(), end.ptr, value);
  return InputError("", value, "").value();
}

/// The number that begins at the text, and its length; 0: none.
std::size_t number_at(const std::string& text, std::size_t at, double& value) {
  const char first = text[at];
  if (first != '-' && (first < '0' || first > '9')) return 0;
  const auto [end, bad] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  return bad == std::errc() ? static_cast<std::size_t>(end - (text.data() + at)) : 0;
}

/// True if no unit and no other word of the same quantity follows a number.
bool ends_here(std::string_view rest) {
  constexpr std::string_view marks = ",:;)";
  if (rest.empty() || marks.find(rest.front()) != std::string_view::npos) return true;
  constexpr std::string_view to = " to ";
  if (rest.starts_with(to)) {  // a range; "1 to 1e6 cycles" counts cycles
    double value = 0;
    const std::string end(rest.substr(to.size()));
    const std::size_t length = end.empty() ? 0 : number_at(end, 0, value);
    return length > 0 && ends_here(std::string_view(end).substr(length));
  }
  constexpr std::array<std::string_view, 9> words{" are ",  " at ",  " and ",  " (",     " from ",
                                                  " with ", " for ", " there", " along "};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return rest.starts_with(word); });
}

/// True if the text between two numbers joins them to one list or range.
bool joins(std::string_view between) {
  return between == " to " || between == ", ";
}

std::string_view last_word(std::string_view text) {
  return text.substr(text.find_last_of(" (") + 1);
}

/// The key whose number follows the text `before`; "" if it is not known. In the first clause of a
/// rule, it is the key of the error.
std::string subject(std::string_view before, const std::string& own, const Document& document) {
  constexpr std::string_view must_be = " must be";
  const auto without = [&](std::string_view end) {
    const bool ends = before.ends_with(end);
    if (ends) before.remove_suffix(end.size());
    return ends;
  };
  const auto named = [&](std::string_view word) {
    const std::string other = own.substr(0, own.rfind('.') + 1) + std::string(word);
    return document.units.contains(other) ? other : std::string(word);
  };
  const bool is_first = before.find_first_of(":;") == std::string_view::npos;
  if (without(" =")) {
    const std::string other = named(last_word(before));
    return document.units.contains(other) || !is_first || !before.starts_with("must be") ? other
                                                                                         : own;
  }
  if (without(" take")) return own;
  for (const auto& [noun, unit] : document.nouns)
    if (before.ends_with(noun) &&
        (before.size() == noun.size() || before[before.size() - noun.size() - 1] == ' '))
      return noun;
  constexpr std::array<std::string_view, 10> comparisons{
      " at least", " at most", " greater than", " less than", " longer than",
      " below",    " above",   " beyond",       " from",      " before"};
  if (before.ends_with(','))  // "must be at most position_max, 300"
    return is_first && (before.starts_with("must ") || before.starts_with("exceeds ")) ? own : "";
  if (is_first &&
      (before == "is" || before == "is past" || (before.starts_with("is ") && without(" and"))))
    return own;
  for (const std::string_view comparison : comparisons) {
    if (!without(comparison)) continue;
    without(must_be);
    const std::string other = named(last_word(before));
    return document.units.contains(other) ? other : is_first ? own : "";
  }
  return is_first && before == must_be.substr(1) ? own : "";
}

/// The rule with the units of its numbers: `must be at least 0.5 s`, `line_speed must be at most 29.6 m/min`.
/// `factor`: from the number of the error to that of its key.
std::string with_units(const std::string& rule, const std::string& own, double factor,
                       const Document& document) {
  std::string all;
  std::string last;  // key of the number before
  std::size_t last_end = 0;
  for (std::size_t at = 0; at < rule.size();) {
    double value = 0;
    const bool begins = at > 0 && rule[at - 1] == ' ';
    const std::size_t length = begins ? number_at(rule, at, value) : 0;
    if (length == 0) {
      all += rule[at++];
      continue;
    }
    const std::string text = rule.substr(at, length);
    at += length;
    const std::string_view whole = rule;
    const std::size_t begin = at - length;
    const bool continues = !last.empty() && joins(whole.substr(last_end, begin - last_end));
    const std::string key = !ends_here(whole.substr(at)) ? ""
                            : continues                  ? last
                                        : subject(whole.substr(0, begin - 1), own, document);
    last = key;
    last_end = at;
    const auto measure = key.empty() || value == 0 ? std::nullopt : measure_of(document, key);
    const double scale = measure ? measure->factor * (key == own ? factor : 1) : 1;
    const bool large = text.find("e+") != std::string::npos;  // 100000, not 1e+05
    all += scale == 1 && !large ? text : converted_text(value * scale);
    if (measure) all += " " + measure->unit;
  }
  return all;
}

/// True for several numbers: "10, 20".
bool is_list(const std::string& text) {
  std::size_t at = 0;
  for (std::size_t count = 1;; ++count) {
    double value = 0;
    const std::size_t length = at < text.size() ? number_at(text, at, value) : 0;
    at += length;
    if (length == 0 || at == text.size()) return length > 0 && count > 1;
    if (text.compare(at, 2, ", ") != 0) return false;
    at += 2;
  }
}

/// The error with the units of its numbers, in the units of the text. `factor`: see with_units().
InputError with_unit(const InputError& error, double factor, const Document& document) {
  const std::string rule = with_units(error.rule(), error.key(), factor, document);
  const auto measure = measure_of(document, error.key());
  double value = 0;
  const std::string& text = error.value();
  if (measure && measure->factor == 1 && is_list(text))
    return InputError(error.key(), text + " " + measure->unit, rule);
  if (!measure || text.empty() || number_at(text, 0, value) != text.size())
    return InputError(error.key(), text, rule);
  const std::string shown = measure->factor == 1 ? InputError("", value, "").value()
                                                 : converted_text(value * measure->factor);
  return InputError(error.key(), shown + " " + measure->unit, rule);
}

/// The error under the key of the text, with the number of the text.
InputError scaled(const InputError& error, const Document::Given& given) {
  const std::string& text = error.value();
  double value = 0;
  if (text.empty() || number_at(text, 0, value) != text.size())
    return InputError(given.key, text, error.rule());
  return InputError(given.key, converted_text(value * given.factor), error.rule());
}

/// The error of a number that the text does not have. `reason`: "" or why the number is needed.
InputError missing(const std::string& key, const std::string& unit, const std::string& reason) {
  const std::string name = key.substr(key.rfind('.') + 1);
  return {key, "",
          "is missing: add " + name + " = NUMBER" + (is_pure(unit) ? "" : ", in " + unit) +
              (reason.empty() ? "" : ": " + reason)};
}

/// The reason of an error that reports a missing number without the form to add; otherwise nullopt.
std::optional<std::string> reason_of_missing(const InputError& error) {
  static const std::string begin = "is missing: ";
  const std::string& rule = error.rule();
  if (!error.value().empty() || !rule.starts_with(begin)) return std::nullopt;
  const std::string reason = rule.substr(begin.size());
  if (reason.starts_with("add ") || reason.starts_with("give ")) return std::nullopt;
  return reason;
}

}  // namespace

std::vector<std::string> Document::all_files() const {
  std::vector<std::string> all = files;
  all.push_back(name);
  return all;
}

InputError Document::located(const InputError& unplaced) const {
  if (!unplaced.document().empty()) return unplaced;
  const auto other = converted.find(unplaced.key());
  const bool is_converted = other != converted.end();
  const InputError own = is_converted ? scaled(unplaced, other->second) : unplaced;
  const auto unit = known.find(own.key());
  const bool absent = unit != known.end() && !places.contains(own.key()) && own.value() == "0" &&
                      own.rule().starts_with("must be greater than 0");
  const auto reason = absent ? "" : reason_of_missing(own);
  const InputError error = reason && unit != known.end()
                               ? missing(own.key(), unit->second, *reason)
                               : with_unit(own, is_converted ? other->second.factor : 1, *this);
  for (std::string key = error.key();; key.erase(key.find_last_of(".["))) {
    if (const auto it = places.find(key); it != places.end())
      return error.at(name, it->second.line, it->second.column);
    if (key.find_last_of(".[") == std::string::npos) return error.at(name);
  }
}

std::string Document::given_unit(const std::string& key, const std::string& otherwise) const {
  const auto unit = given.find(key);
  return unit == given.end() ? otherwise : unit->second;
}

std::string with_units(const std::string& text, const std::map<std::string, std::string>& nouns) {
  Document document;
  document.nouns = nouns;
  return with_units(text, "", 1, document);
}

InputError Document::naming(const std::string& key, const std::string& file,
                            const InputError& error) const {
  const bool unread = error.key().empty() && error.value().empty() && error.line() == 0;
  return unread ? located(InputError(key, file, error.rule())) : error;
}

}  // namespace jounce
