// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/command_words.hpp"

#include <algorithm>
#include <bitset>
#include <cctype>
#include <cmath>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/base/units.hpp"
#include "jounce/command/command_values.hpp"
#include "jounce/profiles/error.hpp"

#include "machine/src/operate/order_options.hpp"

namespace jounce {
namespace {

constexpr const char* move_word = "move";

/// A word with one of its commands. `inch` is move_relative with its distance as VALUE, unbuffered.
struct Form {
  std::string word;
  const CommandInfo* command;

  [[nodiscard]] bool inches() const { return word == "inch"; }
  [[nodiscard]] const FieldOption& about(const Field& field) const {
    return field_option(*command, field);
  }
  [[nodiscard]] OptionForm form(const Field& field) const { return about(field).form; }
  [[nodiscard]] bool takes(const Field& field) const {
    return !(inches() && form(field) == OptionForm::blend);
  }
  [[nodiscard]] std::string option(const Field& field) const {
    return inches() && &field == command->fields.begin() ? value_word : about(field).option;
  }
  /// The option that selects it among the forms of its word.
  [[nodiscard]] std::string selector() const { return option(command->fields[0]); }
};

/// All forms, by their numbers on the wire.
const std::vector<Form>& all_forms() {
  static const std::vector<Form> forms = [] {
    std::vector<Form> all;
    for (const CommandInfo* const command : sent_commands()) {
      if (*command->word != 0) all.push_back({command->word, command});
      if (command->kind == CommandKind::move_superimposed)
        all.push_back({"inch", &info(CommandKind::move_relative)});
    }
    return all;
  }();
  return forms;
}

std::vector<Form> forms_of(const std::string& word) {
  std::vector<Form> forms;
  std::copy_if(all_forms().begin(), all_forms().end(), std::back_inserter(forms),
               [&](const Form& form) { return form.word == word; });
  return forms;
}

std::string dashed(const std::string& option) {
  return option == value_word ? option : "--" + option;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::vector<std::string> choices_of(OptionForm form, const FieldRange& range) {
  if (form == OptionForm::direction) return {"shortest", "positive", "negative"};
  if (form != OptionForm::blend) return {};
  std::vector<std::string> choices{"low", "previous", "next", "high"};
  if (range.most >= static_cast<double>(PathBuffer::look_ahead)) choices.emplace_back("look-ahead");
  return choices;
}

/// The options of a word, VALUE among them: first those that select the command.
std::vector<std::string> taken_by(const std::string& word) {
  std::vector<std::string> names;
  const std::vector<Form> forms = forms_of(word);
  for (const Form& form : forms)
    if (form.command->fields.size() > 0) add_once(names, form.selector());
  for (const Form& form : forms)
    for (const Field& field : form.command->fields)
      if (form.takes(field)) add_once(names, form.option(field));
  return names;
}

/// The errors of an order that do not depend on each other.
class ErrorsOfOrder {
 public:
  /// Adds an error, unless one with the same sentence is there.
  void add(const InputError& error) {
    const auto same = [&](const InputError& one) {
      return std::string(one.what()) == error.what();
    };
    if (std::none_of(all_.begin(), all_.end(), same)) all_.push_back(error);
  }

  /// Adds the error that `work` throws.
  template <typename Work>
  void check(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      add(error);
    }
  }

  /// Throws the errors, if there are any.
  void finish() {
    if (all_.size() == 1) throw InputError(all_.front());
    if (!all_.empty()) throw InputErrors(std::move(all_));
  }

 private:
  std::vector<InputError> all_;
};

std::string text_of(const CommandWords& words, const std::string& option) {
  if (option == value_word) return words.value;
  const auto found = words.options.find(option);
  return found == words.options.end() ? "" : found->second;
}

bool flag_of(const CommandWords& words, const std::string& option) {
  const auto found = words.flags.find(option);
  return found != words.flags.end() && found->second;
}

/// The form that the words mean.
Form form_of(const CommandWords& words) {
  const std::vector<Form> forms = forms_of(words.what);
  if (forms.size() == 1) return forms.front();
  std::vector<std::string> selectors;
  for (const Form& form : forms) selectors.push_back(form.selector());
  const std::string list = listed(selectors, dashed);
  const Form* chosen = nullptr;
  for (const Form& form : forms) {
    if (text_of(words, form.selector()).empty()) continue;
    if (chosen != nullptr)
      throw InputError(
          dashed(form.selector()), text_of(words, form.selector()),
          "cannot be combined with " + dashed(chosen->selector()) +
              (words.what == "jog" ? ": jog a group with --along and --velocity, an axis with VALUE"
               : words.what == "set-position"
                   ? ": set the position of a group with --to, of an axis with VALUE"
                   : ": give only one of " + list));
    chosen = &form;
  }
  if (chosen == nullptr && forms.front().selector() == value_word) return forms.front();
  if (chosen == nullptr)
    throw InputError(
        words.what, "",
        "needs one of " + list +
            (words.what.starts_with("move-") ? ", or coordinates, such as x=10mm" : std::string()));
  return *chosen;
}

/// An option of a word: its first field.
CommandOption option_of(const std::string& word, const std::string& name) {
  for (const Form& form : forms_of(word))
    for (const Field& field : form.command->fields)
      if (form.takes(field) && form.option(field) == name)
        return {name, form.about(field).help, form.form(field), field.quantity,
                choices_of(form.form(field), field.range)};
  return {name, ""};
}

// ---- values ------------------------------------------------------------------------------------

std::string unit_of(Quantity quantity, const Units& units) {
  switch (quantity) {
    case Quantity::none:
      break;
    case Quantity::position:
      return units.position;
    case Quantity::velocity:
      return rate_unit(units.position, "s", 1);
    case Quantity::acceleration:
      return rate_unit(units.position, "s", 2);
    case Quantity::jerk:
      return rate_unit(units.position, "s", 3);
    case Quantity::master:
      return units.x;
    case Quantity::time:
      return "s";
    case Quantity::master_velocity:
      return rate_unit(units.x, "s", 1);
    case Quantity::master_acceleration:
      return rate_unit(units.x, "s", 2);
    case Quantity::master_jerk:
      return rate_unit(units.x, "s", 3);
  }
  return "";
}

double number_of(const std::string& name, const std::string& text, const std::string& unit) {
  if (text.empty())
    throw InputError(name, "", "is missing: give a number" + (unit.empty() ? "" : ", in " + unit));
  try {
    return quantity(text, unit);
  } catch (const InputError& error) {
    throw InputError(name, text, error.rule());
  }
}

/// The rule of a number that the range of its field does not permit, and how to use the default.
std::string rule_for_number(const std::string& word, const Field& field, const std::string& name,
                            double value) {
  const bool is_limit = field.range.may_be_nan && field.quantity != Quantity::time &&
                        field.quantity != Quantity::position;
  const std::string rule = broken_rule(field.range, value);
  if (rule.empty() || !is_limit || name == value_word) return rule;
  return rule + (word == "home"       ? "; leave it out to use [homing] of the axis's spec"
                 : is_of_groups(word) ? "; leave it out to use the limits of the path"
                                      : "; leave it out to use the limit of the axis");
}

/// "50%" or "0.5", as a factor.
std::optional<double> factor_in(const std::string& text) {
  const bool percent = !text.empty() && text.back() == '%';
  const auto factor = csv_number(percent ? text.substr(0, text.size() - 1) : text);
  return factor && percent ? *factor / 100 : factor;
}

double factor_of(const std::string& name, const std::string& text, const FieldRange& range) {
  const bool percent = text.back() == '%';
  const auto factor = factor_in(text);
  if (factor && broken_rule(range, *factor).empty()) return *factor;
  const bool is_percent = !percent && factor && *factor > range.most && *factor <= 100 * range.most;
  throw InputError(name, text,
                   std::string("must be ") + range.words +
                       (is_percent ? ": did you mean " + text + "%?" : std::string()));
}

/// "3:2" or "3".
std::pair<double, double> ratio_of(const std::string& name, const std::string& text) {
  if (text.empty())
    throw InputError(name, "", "is missing: give a ratio, such as " + name + " 3:2");
  const auto colon = text.find(':');
  const auto numerator = csv_number(text.substr(0, colon));
  const auto denominator = csv_number(colon == std::string::npos ? "1" : text.substr(colon + 1));
  const auto is_whole = [](double number) { return std::trunc(number) == number; };
  if (!numerator || !denominator || !is_whole(*numerator) || !is_whole(*denominator))
    throw InputError(name, text, "must be a ratio of whole numbers, such as 3:2");
  return {*numerator, *denominator};
}

double direction_of(const std::string& text) {
  return text == "positive" ? 1 : text == "negative" ? -1 : 0;
}

/// Rejects a word that is not one of the choices of the option.
void require_choice(const std::string& name, const std::string& text,
                    const std::vector<std::string>& choices) {
  if (!text.empty() && !choices.empty() &&
      std::find(choices.begin(), choices.end(), text) == choices.end())
    throw InputError(name, text, "must be one of " + listed(choices));
}

/// The option of a word that takes coordinates, and that stands for its arguments; "": none.
std::string coordinate_option(const std::string& word) {
  for (const Form& form : forms_of(word))
    for (const Field& field : form.command->fields)
      if (form.form(field) == OptionForm::coordinates) return form.option(field);
  return "";
}

/// The name of a coordinate in messages: "x", "--to", "--to: x".
std::string coordinate_name(const CommandWords& words, const std::string& option, std::size_t index,
                            const std::vector<std::string>& axes) {
  if (index >= axes.size()) return dashed(option);
  const bool typed = words.typed_coordinates && option == coordinate_option(words.what);
  return typed ? axes[index] : dashed(option) + ": " + axes[index];
}

/// The coordinate with this index in a list such as "10,5mm,,2"; NaN: not given.
double coordinate_of(const std::string& name, const std::string& text, std::size_t index,
                     const std::string& unit) {
  std::size_t begin = 0;
  for (std::size_t k = 0; k < index; ++k) {
    const std::size_t comma = text.find(',', begin);
    if (comma == std::string::npos) return as_configured;
    begin = comma + 1;
  }
  const std::string one = text.substr(begin, text.find(',', begin) - begin);
  if (const auto space = one.find_first_of(' ', one.find_first_not_of(' '));
      space != std::string::npos && csv_number(one.substr(space + 1)))
    throw InputError(name, text, "needs commas between the coordinates: 10,5");
  return one.empty() ? as_configured : number_of(name, one, unit);
}

void require_coordinates(const std::string& name, const std::string& text, std::size_t most) {
  const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
  if (count > most)
    throw InputError(name, text,
                     "has " + std::to_string(count) + " coordinates, and must have at most " +
                         std::to_string(most));
}

double whole_of(const std::string& name, const std::string& text, const FieldRange& range) {
  const auto number = csv_number(text);
  if (!number || !broken_rule(range, *number).empty())
    throw InputError(name, text, std::string("must be ") + range.words);
  return *number;
}

/// The trigger input of a touch probe.
double input_of(const std::string& text) {
  if (text == "home") return home_switch_input;
  if (text == "index") return index_input;
  const auto input = csv_number(text);
  if (!input || *input != std::floor(*input) || *input < 1 || *input > 4)
    throw InputError(value_word, text,
                     text.empty() ? "is missing: give a trigger input: 1 to 4, home or index"
                                  : "must be a trigger input: 1 to 4, home or index");
  return *input;
}

/// The edge of a touch probe.
double edge_of(const std::string& text) {
  for (const auto& [word, edge] : {std::pair{"rising", ProbeEdge::rising},
                                   {"falling", ProbeEdge::falling},
                                   {"both", ProbeEdge::both}})
    if (text == word) return static_cast<double>(edge);
  throw InputError("--edge", text, "must be rising, falling or both");
}

/// --buffered, --blend: as a number on the wire.
double buffer_mode_of(const CommandWords& words) {
  const std::map<std::string, double> blends{
      {"low", 2}, {"previous", 3}, {"next", 4}, {"high", 5}, {"look-ahead", 6}};
  const std::string blend = text_of(words, "blend");
  const bool buffered = flag_of(words, "buffered");
  if (!blend.empty() && buffered)
    throw InputError("--blend", blend,
                     "cannot be combined with --buffered: a move that blends is buffered");
  require_choice("--blend", blend, {"low", "previous", "next", "high", "look-ahead"});
  return !blend.empty() ? blends.at(blend) : buffered ? 1 : 0;
}

void require_unbuffered(const CommandWords& words, const Form& form) {
  const bool takes_it = std::any_of(
      form.command->fields.begin(), form.command->fields.end(),
      [&](const Field& f) { return form.form(f) == OptionForm::blend && form.takes(f); });
  if (buffer_mode_of(words) == 0 || takes_it) return;
  throw InputError(flag_of(words, "buffered") ? "--buffered" : "--blend", text_of(words, "blend"),
                   "applies only to move --to, move --by, jog of an axis, and the moves of a "
                   "group: omit it for " +
                       (form.word == move_word ? dashed(form.selector()) : form.word));
}

/// Rejects the options of the word that the form does not take: --direction of move --by.
void require_applies(const CommandWords& words, const Form& form) {
  const auto& fields = form.command->fields;
  ErrorsOfOrder errors;
  for (const auto& [option, text] : words.options) {
    const auto is_it = [&, &name = option](const Field& f) {
      return form.takes(f) && form.option(f) == name;
    };
    if (text.empty() || std::any_of(fields.begin(), fields.end(), is_it)) continue;
    errors.add(InputError(
        dashed(option), text,
        form.selector() == value_word
            ? "does not apply to " + form.word + " with VALUE" +
                  (words.value.empty() ? "" : " = " + words.value) + ": omit it"
            : "does not apply to " + form.word + " " + dashed(form.selector()) + ": omit it"));
  }
  errors.finish();
}

/// Number of coordinates of an option.
std::size_t coordinates(const Form& form, const std::string& option) {
  const auto& fields = form.command->fields;
  return static_cast<std::size_t>(std::count_if(
      fields.begin(), fields.end(), [&](const Field& f) { return form.option(f) == option; }));
}

/// The error for an order without a value, or without the option `name`, such as "--to".
InputError value_missing(const std::string& word, const std::string& name, const Field& field,
                         OptionForm form, const std::string& unit) {
  if (word == "combine")
    return {word, "", "VALUE is missing: give two ratios, such as combine 3:2 --second 1:2"};
  const bool is_ratio = form == OptionForm::ratio;
  const bool is_whole = form == OptionForm::whole;
  return {word, "",
          name + " is missing: give " +
              (is_ratio ? "a ratio" : (is_whole ? "an " : "a ") + std::string(field.name)) +
              ", such as " + (name == value_word ? "" : name + " ") +
              (is_ratio                     ? "3:2"
               : form == OptionForm::factor ? "50%"
               : is_whole                   ? "6"
                                            : "12.5" + unit)};
}

/// A number with a unit.
double number_in_range(const CommandWords& words, const Field& field, const FieldOption& about,
                       const std::string& name, const std::string& text, const std::string& unit) {
  const double value = number_of(name, text, unit);
  const std::string rule = about.range ? broken_rule(*about.range, value)
                                       : rule_for_number(words.what, field, name, value);
  if (!rule.empty())
    throw InputError(name, csv_number(text) && !unit.empty() ? text + " " + unit : text,
                     rule + about.reason);
  return value;
}

/// True for a number without a default.
bool is_required(const Field& field, OptionForm form) {
  return form == OptionForm::number && !field.range.may_be_nan && std::isinf(field.range.least);
}

double buffer_mode_in(const CommandWords& words, const Field& field) {
  if (text_of(words, "blend") == "look-ahead" &&
      field.range.most < static_cast<double>(PathBuffer::look_ahead))
    throw InputError("--blend", "look-ahead", "applies to the moves of a group only");
  return buffer_mode_of(words);
}

/// The value of a field, from its option. `index`: number of fields of the same option before it;
/// `otherwise`: its value if the option is not given.
double value_of(const CommandWords& words, const Form& form, const Field& field, std::size_t index,
                double otherwise, const Units& units, const std::vector<std::string>& axes,
                const std::vector<std::string>& coordinate_units) {
  const std::string option = form.option(field);
  const std::string name = dashed(option);
  const std::string text = text_of(words, option);
  const FieldOption& about = form.about(field);
  const std::string unit = *about.unit != 0 ? about.unit : unit_of(field.quantity, units);
  const FieldRange& range = about.range ? *about.range : field.range;
  const bool is_input = about.form == OptionForm::trigger_input;
  if (option == value_word && text.empty() && !is_input)
    throw value_missing(words.what, value_word, field, about.form, unit);
  if (text.empty() && is_required(field, about.form))
    throw value_missing(words.what, name, field, about.form, unit);
  switch (about.form) {
    case OptionForm::flag:
      return flag_of(words, option) ? 1 : 0;
    case OptionForm::blend:
      return buffer_mode_in(words, field);
    case OptionForm::ratio: {
      const auto [numerator, denominator] = ratio_of(name, text);
      if (field.range.not_zero && denominator == 0)
        throw InputError(name, text, "the " + std::string(field.name) + " must not be 0");
      return field.range.not_zero ? denominator : numerator;
    }
    case OptionForm::trigger_input:
      return input_of(text);
    case OptionForm::coordinates: {
      const bool angle = *about.unit != 0;
      const bool of_axis = !angle && coordinates(form, option) > 1;
      return coordinate_of(
          of_axis ? coordinate_name(words, option, index, axes) : name, text, index,
          !angle && index < coordinate_units.size() ? coordinate_units[index] : unit);
    }
    case OptionForm::direction:
      require_choice(name, text, choices_of(about.form, field.range));
      return direction_of(text);
    case OptionForm::factor:
      return text.empty() ? otherwise : factor_of(name, text, range);
    case OptionForm::whole:
      return text.empty() ? otherwise : whole_of(name, text, range);
    case OptionForm::edge:
      return text.empty() ? otherwise : edge_of(text);
    case OptionForm::number:
      break;
  }
  return text.empty() ? otherwise : number_in_range(words, field, about, name, text, unit);
}

/// The option of a word, written with this text.
std::string option_for_value(const std::string& word, const std::string& name,
                             const std::string& text) {
  const bool is_flag = option_of(word, name).form == OptionForm::flag;
  return is_flag ? dashed(name) : dashed(name) + " " + text;
}

/// The coordinate that an order of a group has for this axis: that with its name, or the only one; "" if
/// it has none.
std::string only_place(const std::string& axis, const CommandWords& words) {
  std::string list = text_of(words, "to");
  if (list.empty()) list = text_of(words, "by");
  const std::vector<std::string_view> places = csv_cells(list);
  for (const std::string_view place : places) {
    const bool is_of_axis = place.starts_with(axis + "=");
    if (is_of_axis || places.size() == 1)
      return std::string(place.substr(place.find('=') + 1));  // npos + 1 is 0
  }
  return "";
}

std::string or_name(const std::string& text, const char* name) {
  return text.empty() ? name : text;
}

/// The options of a word, with those that are no field of a command.
std::vector<std::string> with_common(std::vector<std::string> taken) {
  if (std::find(taken.begin(), taken.end(), "blend") != taken.end()) taken.emplace_back("buffered");
  taken.emplace_back("at");
  return taken;
}

}  // namespace

const std::vector<std::string>& command_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    for (const Form& form : all_forms()) add_once(all, form.word);
    return all;
  }();
  return words;
}

std::string meant_command(const std::string& name, const std::string& word) {
  const std::vector<std::string>& words = command_words();
  if (std::find(words.begin(), words.end(), name) != words.end())
    return "is not a command: did you mean jounce order " + word + " " + name + "?";
  if (word == "stop") return "is a verb of its own: did you mean jounce stop " + name + "?";
  if (word == "abort")
    return "is an option of a verb: did you mean jounce stop " + name + " --abort?";
  if (nearest(word, words).empty())
    return "is not a command: `jounce order --help` lists all, such as move, jog and home";
  return "";
}

std::string rule_of_axis(const std::string& name, const CommandWords& words) {
  const std::string& word = words.what;
  const std::string order =
      word == "jog"               ? "jog " + or_name(text_of(words, "velocity"), "VELOCITY")
      : word == "set-position"    ? "set-position " + or_name(only_place(name, words), "POSITION")
      : word.starts_with("move-") ? (text_of(words, "by").empty() ? "move --to " : "move --by ") +
                                        or_name(only_place(name, words), "POSITION")
                                  : "";
  return "is a single axis, without coordinates: name a group" +
         (order.empty() ? "" : ", or send `jounce order " + name + " " + order + "`");
}

std::vector<CommandOption> command_options() {
  std::vector<std::string> words = command_words();
  // Those of move come first: the other words share them.
  std::stable_partition(words.begin(), words.end(),
                        [](const std::string& word) { return word == move_word; });
  std::vector<CommandOption> options;
  for (const std::string& word : words)
    for (CommandOption& option : options_of(word)) {
      const auto known = std::find_if(options.begin(), options.end(),
                                      [&](const auto& one) { return one.name == option.name; });
      if (option.name != value_word && known == options.end())
        options.push_back(std::move(option));
      else if (option.name != value_word)
        for (const std::string& choice : option.choices) add_once(known->choices, choice);
    }
  return options;
}

std::vector<CommandOption> options_of(const std::string& word) {
  std::vector<CommandOption> options;
  for (const std::string& name : taken_by(word)) options.push_back(option_of(word, name));
  return options;
}

bool is_of_groups(const std::string& word) {
  const std::vector<Form> forms = forms_of(word);
  return std::all_of(forms.begin(), forms.end(),
                     [](const Form& form) { return is_path_kind(form.command->kind); });
}

namespace {

/// "--to 5 or --by 5", the options for a value of a command without VALUE; "" if it has neither.
std::string meant_distance(const std::vector<std::string>& taken, const std::string& text) {
  std::string options;
  const bool is_number = text.find_first_of("0123456789") != std::string::npos &&
                         text.find_first_of(":=,") == std::string::npos;
  if (!is_number) return "";
  for (const char* const option : {"to", "by"})
    if (std::find(taken.begin(), taken.end(), option) != taken.end())
      options += (options.empty() ? "" : " or ") + dashed(option) + " " + text;
  return options;
}

}  // namespace

namespace {

/// Rejects a value, or an option, that no form of the word has.
void require_in_word(const CommandWords& words, const std::vector<std::string>& taken) {
  const auto require = [&](const std::string& option, const std::string& text, bool given) {
    if (!given || std::find(taken.begin(), taken.end(), option) != taken.end()) return;
    if (option == value_word && !coordinate_option(words.what).empty())
      throw InputError(
          value_word, text,
          text.find('=') != std::string::npos ? "has the name of an axis: give --to " + text
          : text.find(',') == std::string::npos
              ? "needs the name of an axis, such as x=" +
                    (text.find_first_of("0123456789") == std::string::npos ? "10mm" : text)
              : "is a list without names: give --to " + text + ", or names, such as x=10 y=5");
    if (option == value_word && taken.size() == 1)
      throw InputError(value_word, text,
                       "does not apply to " + words.what + ": did you mean " +
                           option_for_value(words.what, taken.front(), text) + "?");
    if (option == value_word && !meant_distance(taken, text).empty())
      throw InputError(value_word, text,
                       "does not apply to " + words.what + ": did you mean " +
                           meant_distance(taken, text) + "?");
    throw InputError(dashed(option), text,
                     "does not apply to " + words.what +
                         (taken.empty() ? ", which takes no value; its only own option is --at"
                                        : ", which has " + listed(with_common(taken), dashed)));
  };
  ErrorsOfOrder errors;
  errors.check([&] { require(value_word, words.value, !words.value.empty()); });
  for (const auto& [option, given] : words.flags)
    if (option != "buffered")
      errors.check([&, &name = option, is = given] { require(name, "", is); });
  for (const auto& [option, text] : words.options)
    errors.check([&, &name = option, &one = text] { require(name, one, !one.empty()); });
  errors.finish();
}

}  // namespace

void require_taken(const CommandWords& words) {
  require_in_word(words, taken_by(words.what));
  const Form form = form_of(words);
  require_unbuffered(words, form);
  require_applies(words, form);
}

std::vector<std::string> options_with(const CommandWords& words, Quantity quantity, double value,
                                      const Units& units) {
  constexpr double six_digits_of = 1e-5;
  std::vector<std::string> names;
  for (const CommandOption& option : options_of(words.what)) {
    const std::string text = text_of(words, option.name);
    if (option.name == value_word || option.quantity != quantity || text.empty() ||
        option.form != OptionForm::number)
      continue;
    const double given = number_of(option.name, text, unit_of(quantity, units));
    if (std::abs(given - value) <= six_digits_of * std::abs(value))
      names.push_back(dashed(option.name));
  }
  return names;
}

CommandKind kind_of(const CommandWords& words) {
  return form_of(words).command->kind;
}

void require_held(const CommandWords& words, const std::string& seconds) {
  if (flag_of(words, "hold-to-run")) return;
  throw InputError("--seconds", seconds,
                   std::string("applies to jog --hold-to-run only") +
                       (words.what == "jog" ? ": add --hold-to-run" : ""));
}

namespace {

/// Rejects options of a command that do not suit each other.
void require_suitable(const CommandWords& words, const Form& form) {
  const Fields& fields = form.command->fields;
  std::bitset<most_fields> given;
  for (std::size_t i = 0; i < fields.size(); ++i)
    given[i] = !text_of(words, form.option(fields[i])).empty();
  const auto name = [&](const Field& field) { return dashed(form.option(field)); };
  const auto conflict = field_conflict(form.command->kind, given, name);
  if (!conflict) return;
  std::string remedy;
  if (conflict->missing) {
    const Field& missing = fields[*conflict->missing];
    remedy = ": add " + name(missing) + " ";
    for (const char c : std::string(missing.name))
      remedy += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const std::string option = form.option(fields[conflict->field]);
  throw InputError(dashed(option), text_of(words, option), conflict->rule + remedy);
}

/// The index of an axis among the axes of the group. `one`: the coordinate as given.
std::size_t axis_index(const std::string& name, const std::string& option, const std::string& one,
                       const std::vector<std::string>& axes) {
  const auto found = std::find(axes.begin(), axes.end(), name);
  if (found == axes.end())
    throw InputError(option, one,
                     "names " + (name.empty() ? "no axis" : name) +
                         ", but the axes of the group are " + listed(axes));
  return static_cast<std::size_t>(found - axes.begin());
}

/// "y=5,x=10" as a list in the order of the axes: "10,5".
std::string in_order(const std::string& option, const std::string& text,
                     const std::vector<std::string>& axes) {
  if (text.find('=') == std::string::npos) return text;
  std::vector<std::string> given(axes.size());
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string one = text.substr(begin, end - begin);
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos)
      throw InputError(option, text,
                       "has coordinates with and without a name: name all of them, or none");
    const std::size_t first = std::min(one.find_first_not_of(' '), equals);
    const std::size_t last = one.find_last_not_of(' ', equals == 0 ? 0 : equals - 1);
    std::string& place = given[axis_index(equals == 0 ? "" : one.substr(first, last + 1 - first),
                                          option, one, axes)];
    if (!place.empty()) throw InputError(option, text, "names an axis twice");
    place = one.substr(equals + 1);
    if (place.empty()) throw InputError(option, text, "has a name without a coordinate");
    begin = end + 1;
  }
  while (!given.empty() && given.back().empty()) given.pop_back();
  std::string list;
  for (const std::string& one : given) list += (&one == given.data() ? "" : ",") + one;
  return list;
}

constexpr const char* axis_option = "axis";

bool is_name(const std::string& text) {
  return !text.empty() && !csv_number(text);
}

/// The words with all coordinates in the order of the axes, and the number of a named axis.
CommandWords without_names(CommandWords words, const std::vector<std::string>& axes) {
  const auto named = [&](const std::string& option) {
    return words.typed_coordinates ? std::string("VALUE") : dashed(option);
  };
  for (const Form& form : forms_of(words.what))
    for (const Field& field : form.command->fields) {
      if (form.form(field) != OptionForm::coordinates) continue;
      const std::string option = form.option(field);
      const auto given = words.options.find(option);
      if (given != words.options.end())
        given->second = in_order(named(option), given->second, axes);
    }
  if (const auto axis = words.options.find(axis_option);
      axis != words.options.end() && is_name(axis->second))
    axis->second =
        std::to_string(axis_index(axis->second, dashed(axis_option), axis->second, axes) + 1);
  return words;
}

/// The error of a value that is not the only one.
InputError several_values(const std::string& word, const std::string& value) {
  const std::vector<std::string> taken = taken_by(word);
  const bool takes_one = std::find(taken.begin(), taken.end(), value_word) != taken.end();
  const bool has_axes = !coordinate_option(word).empty();
  if (!takes_one && !has_axes)
    return {value_word, value, "does not apply to " + word + ", which takes no VALUE"};
  return {value_word, value,
          "is one of several values: give " +
              std::string(!has_axes   ? "one value"
                          : takes_one ? "one value, or coordinates such as x=10 y=5"
                                      : "coordinates such as x=10 y=5")};
}

}  // namespace

void set_values(CommandWords& words, const std::vector<std::string>& values) {
  words.value.clear();
  for (const std::string& value : values) {
    if (is_unit(value))
      throw InputError(value_word, value,
                       "is a unit: write it right after its number, such as 50" + value);
    if (value.starts_with("--") && value != "--")
      throw InputError(value_word, value,
                       "is an option after --, where all words are values: write it before --. A "
                       "negative number needs no --");
  }
  std::string list;
  const auto ends_options = std::count(values.begin(), values.end(), "--");
  for (const std::string& value : values) {
    if (value == "--") continue;
    const bool named = value.find('=') != std::string::npos;
    if (values.size() > static_cast<std::size_t>(ends_options) + 1 && !named)
      throw several_values(words.what, value);
    (named ? list : words.value) += (named && !list.empty() ? "," : "") + value;
  }
  if (words.what == "jog" && !text_of(words, "along").empty() && text_of(words, "velocity").empty())
    words.options["velocity"] = std::exchange(words.value, "");
  if (list.empty()) return;
  const std::string option = coordinate_option(words.what);
  if (option.empty())
    throw InputError(value_word, list,
                     "has names of axes, but " + words.what + " has no coordinates: omit them");
  if (!text_of(words, option).empty())
    throw InputError(value_word, list,
                     "cannot be combined with " + dashed(option) + ": give one of the two");
  if (option == "to" && !text_of(words, "by").empty())
    throw InputError(value_word, list, "cannot be combined with --by: use --by " + list);
  words.options[option] = list;
  words.typed_coordinates = true;
}

bool names_axes(const CommandWords& words) {
  return std::any_of(words.options.begin(), words.options.end(), [](const auto& option) {
    return option.second.find('=') != std::string::npos ||
           (option.first == axis_option && is_name(option.second));
  });
}

bool has_coordinates(const CommandWords& words) {
  if (!text_of(words, axis_option).empty()) return true;
  for (const Form& form : forms_of(words.what))
    for (const Field& field : form.command->fields)
      if (form.form(field) == OptionForm::coordinates &&
          !text_of(words, form.option(field)).empty())
        return true;
  return false;
}

namespace {

/// The unit of the rates of a command of a group: that of the axis that it names, or of its first
/// coordinate with a value if none of these has the unit of the path.
Units units_of_rates(const CommandWords& words, const Form& form, Units units,
                     const std::vector<std::string>& coordinate_units) {
  const auto axis = csv_number(text_of(words, axis_option));
  if (axis && *axis >= 1 && *axis <= static_cast<double>(coordinate_units.size())) {
    units.position = coordinate_units[static_cast<std::size_t>(*axis) - 1];
    return units;
  }
  const Fields& fields = form.command->fields;
  const auto end = std::find_if(fields.begin(), fields.end(), [&](const Field& field) {
    return form.form(field) == OptionForm::coordinates;
  });
  const CommandKind kind = form.command->kind;
  const bool is_arc = kind == CommandKind::move_circular_absolute ||
                      kind == CommandKind::move_circular_relative;  // it moves two path axes
  if (end == fields.end() || is_arc || !is_path_kind(kind)) return units;
  const std::string list = text_of(words, form.option(*end));
  if (list.empty()) return units;
  std::string first;
  const std::vector<std::string_view> values = csv_cells(list);
  for (std::size_t k = 0; k < values.size() && k < coordinate_units.size(); ++k) {
    if (values[k].empty()) continue;
    if (coordinate_units[k] == units.position) return units;
    if (first.empty()) first = coordinate_units[k];
  }
  if (!first.empty()) units.position = first;
  return units;
}

/// The error of a contradiction at the option of its field: "denominator of the second master must
/// not be 0" is at --second.
InputError contradiction_error(const CommandWords& words, const Form& form,
                               const std::string& rule) {
  const auto& fields = form.command->fields;
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& each) {
    return form.takes(each) && rule.starts_with(std::string(each.name) + " must ");
  });
  const std::string option = field == fields.end() ? value_word : form.option(*field);
  const std::string text = option == value_word ? words.value : text_of(words, option);
  return InputError(text.empty() ? words.what : dashed(option), text, "the " + rule);
}

}  // namespace

ClientCommand command_of(const CommandWords& given, const Units& units,
                         const std::vector<std::string>& axes,
                         const std::vector<std::string>& coordinate_units) {
  const CommandWords words =
      names_axes(given) && !axes.empty() ? without_names(given, axes) : given;
  const Form form = form_of(words);
  const CommandKind kind = form.command->kind;
  CommandValues values = values_of(command_of(kind));
  const Units rates = units_of_rates(words, form, units, coordinate_units);
  std::map<std::string, std::size_t> seen;  // fields of each option so far
  ErrorsOfOrder errors;
  for (std::size_t i = 0; i < form.command->fields.size(); ++i) {
    const Field& field = form.command->fields[i];
    const std::string option = form.option(field);
    errors.check([&] {
      if (form.takes(field))
        values[i] =
            value_of(words, form, field, seen[option]++, values[i], rates, axes, coordinate_units);
      if (form.form(field) == OptionForm::coordinates)
        require_coordinates(dashed(option), text_of(words, option), coordinates(form, option));
    });
  }
  errors.finish();
  require_suitable(words, form);
  if (const std::string rule = contradiction(kind, values); !rule.empty())
    throw contradiction_error(words, form, rule);
  return jounce::command_of(kind, values);
}

}  // namespace jounce
