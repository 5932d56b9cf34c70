// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/command_words.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

InputError empty_argument(const std::vector<std::string>& words, std::size_t i) {
  if (i == 0) return {"VERB", "", "is empty: write a verb, such as `jounce check`"};
  const bool named = i > 0 && looks_like_option(words[i - 1]);
  return {named ? words[i - 1] : "argument " + std::to_string(i) + " of " + words.front(), "",
          "is empty: write a value"};
}

/// The first number that is followed by a unit as a word of its own; "" for none.
std::string number_and_unit(std::span<const char* const> given) {
  for (std::size_t i = 1; i < given.size(); ++i) {
    const std::string number = given[i - 1];
    double value = 0;
    const auto [end, bad] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (bad == std::errc() && end == number.data() + number.size() && is_unit(given[i]))
      return number + " " + given[i];
  }
  return "";
}

std::string did_you_mean(const std::string& near) {
  return near.empty() ? "" : ": did you mean " + near + "?";
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_option(const VerbInfo& verb, const std::string& name) {
  return std::any_of(verb.options.begin(), verb.options.end(),
                     [&](const OptionInfo& option) { return contains(option.names, name); });
}

using Options = std::vector<const OptionInfo*>;

/// True if one of the names is a name of the option.
bool is_among(const OptionInfo& option, const std::vector<std::string>& names) {
  return std::any_of(option.names.begin(), option.names.end(),
                     [&](const std::string& name) { return contains(names, name); });
}

/// The options of a verb that are among the words, in the order of the help.
Options given_options(std::span<const char* const> given, const VerbInfo& verb) {
  std::vector<std::string> names;
  for (const std::string word : given) names.push_back(word.substr(0, word.find('=')));
  Options all;
  for (const OptionInfo& option : verb.options)
    if (is_among(option, names)) all.push_back(&option);
  return all;
}

/// "--a, --b and --c".
std::string listed(const Options& options) {
  std::string text;
  for (std::size_t i = 0; i < options.size(); ++i)
    text += (i == 0 ? "" : i + 1 == options.size() ? " and " : ", ") + options[i]->names.back();
  return text;
}

/// These options, each followed by the given options that need it.
Options with_dependents(const Options& options, const Options& given) {
  Options all;
  for (const OptionInfo* const option : options) {
    all.push_back(option);
    for (const OptionInfo* const other : given)
      if (is_among(*option, other->needs) &&
          std::find(options.begin(), options.end(), other) == options.end())
        all.push_back(other);
  }
  return all;
}

/// Those of the given options that exclude this one.
Options excluded_by(const OptionInfo& one, const Options& given) {
  Options all;
  for (const OptionInfo* const other : given)
    if (is_among(*other, one.excludes)) all.push_back(other);
  return all;
}

/// The error of options that exclude each other; "" for none.
std::string excluding_options(const Options& given) {
  for (const OptionInfo* const option : given) {
    const Options excluded = excluded_by(*option, given);
    if (excluded.empty()) continue;
    const Options alike =
        excluded.size() == 1 ? excluded_by(*excluded.front(), given) : Options{option};
    const Options first = with_dependents(alike, given);
    const Options second = with_dependents(excluded, given);
    return listed(alike) + " cannot be combined with " + listed(excluded) + ": " +
           (first.size() + second.size() == 2
                ? "give one of the two"
                : "leave out " + listed(first) + ", or leave out " + listed(second));
  }
  return "";
}

/// The error of an option that needs another one; "" for none.
std::string missing_option(const Options& given, const VerbInfo& verb) {
  for (const OptionInfo& needed : verb.options) {
    Options all;
    for (const OptionInfo* const one : given)
      if (is_among(needed, one->needs)) all.push_back(one);
    if (all.empty() || std::find(given.begin(), given.end(), &needed) != given.end()) continue;
    Options excluded;
    for (const OptionInfo* const one : given)
      if (is_among(*one, needed.excludes)) excluded.push_back(one);
    const std::string what = listed(all);
    const std::string text = what + (all.size() == 1 ? " needs " : " need ") + needed.names.back();
    return excluded.empty()
               ? text + ": add it, or leave out " + what
               : text + ", which cannot be combined with " + listed(excluded) + ": leave out " +
                     what + ", or replace " + listed(excluded) + " by " + needed.names.back();
  }
  return "";
}

/// The error of required words that are missing. The parser reports the first one: the required arguments that
/// follow an argument are then missing, too, and so are the required options that are not among the words.
std::string missing_words(const std::string& first, std::span<const char* const> given,
                          const VerbInfo& verb) {
  Options all;
  bool missing = false;
  for (const OptionInfo& one : verb.positionals) {
    missing = missing || one.names.back() == first;
    if (missing && one.required) all.push_back(&one);
  }
  const Options options = given_options(given, verb);
  for (const OptionInfo& one : verb.options)
    if (one.required && std::find(options.begin(), options.end(), &one) == options.end())
      all.push_back(&one);
  return all.size() < 2 ? first + " is missing" : listed(all) + " are missing";
}

/// The visible options of a verb; those of the program if it is null.
std::vector<std::string> visible_options(const ProgramInfo& program, const VerbInfo* verb) {
  std::vector<std::string> names;
  for (const OptionInfo& option : verb != nullptr ? verb->options : program.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// The option of the verb whose help begins with this word: --to ("Format, if ...") for "format"; "" for none.
std::string described_by(const VerbInfo& verb, std::string word) {
  word[0] = static_cast<char>(std::toupper(word[0]));
  const auto begins = [&](const OptionInfo& option) {
    return option.help.starts_with(word) && option.help.size() > word.size() &&
           std::isalpha(option.help[word.size()]) == 0;
  };
  const auto found = std::find_if(verb.options.begin(), verb.options.end(), begins);
  return found == verb.options.end() ? "" : found->names.back();
}

/// ", but of check, validate"; "" if no verb has it, or more than four verbs.
std::string verbs_with(const ProgramInfo& program, const std::string& name) {
  constexpr int most = 4;
  std::string verbs;
  int count = 0;
  for (const VerbInfo& one : program.verbs)
    if (has_option(one, name) && ++count <= most) verbs += (count > 1 ? ", " : "") + one.name;
  return count == 0 || count > most ? "" : ", but of " + verbs;
}

/// The hint for an option that has the name of an argument: --shell for SHELL. "" for another one.
std::string meant_argument(std::span<const char* const> given, const std::string& option,
                           const VerbInfo& verb) {
  std::string name = option.substr(option.find_first_not_of('-'));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  for (const OptionInfo& one : verb.positionals) {
    if (one.names.front() != name) continue;
    std::string command = "jounce";
    for (const std::string word : given) {
      const bool has_value = word.starts_with(option + "=");
      if (word == option) continue;
      command += " " + (has_value ? word.substr(option.size() + 1) : word);
    }
    return ": write " + name + " without " + option + ", `" + command + "`";
  }
  return "";
}

/// The hint for a wrong option.
std::string meant_option(const std::string& name, const ProgramInfo& program,
                         const std::string& verb) {
  const VerbInfo* const own = program.verb(verb);
  if (own != nullptr && (name == "-o" || name == "--output") &&
      std::any_of(own->positionals.begin(), own->positionals.end(),
                  [](const OptionInfo& one) { return one.names.front() == "OUT"; }))
    return ": name the output as the second argument";
  const std::string word = name.substr(name.find_first_not_of('-'));
  if (own != nullptr && word.size() > 1)
    if (const std::string option = described_by(*own, word); !option.empty())
      return did_you_mean(option);
  if (const std::string near = word.size() > 1 ? nearest(name, visible_options(program, own)) : "";
      !near.empty() && (near != "--help" || word[0] == 'h'))
    return did_you_mean(near);
  return verbs_with(program, name);
}

/// The error of `--` in words that the program cannot read.
std::string misplaced_dashes(std::span<const char* const> given,
                             const std::vector<std::string>& options) {
  const auto dashes = std::find(given.begin(), given.end(), std::string("--"));
  for (auto word = dashes + 1; word < given.end(); ++word)
    if (const std::string text = *word; contains(options, text.substr(0, text.find('='))))
      return "`--` ends the options: write " + text + " before it";
  return "`--` is not needed before a negative number: leave it out";
}

}  // namespace

bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (word[1] == '-' || std::isalpha(word[1]) != 0);
}

void require_value(const std::string& name, const std::string& text) {
  if (name[0] == '-' && looks_like_option(text))
    throw InputError(name, "", "has no value after it");
}

std::vector<std::string> meant_words(std::span<const char* const> given) {
  std::vector<std::string> words(given.begin(), given.end());
  const auto end = std::find(words.begin(), words.end(), "--");
  for (std::string& word : std::span(words.begin(), end)) {
    if (word.empty()) throw empty_argument(words, static_cast<std::size_t>(&word - words.data()));
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      throw InputError(word.substr(0, word.size() - 1), "", "has no value after =");
    if (word.size() > 2 && word.starts_with("-.") && std::isdigit(word[2]) != 0)
      word.insert(1, "0");
  }
  return words;
}

std::string wrong_verb(std::span<const char* const> given, const std::vector<std::string>& verbs) {
  const std::string word = given.empty() ? "" : given.front();
  if (word.empty()) return "the verb is missing";
  if (contains(verbs, word)) return "";
  if (word[0] == '-') {
    const auto verb = std::find_if(given.begin() + 1, given.end(),
                                   [&](const char* each) { return contains(verbs, each); });
    return verb == given.end() ? ""
                               : "`" + word + "` stands before the verb: write `jounce " +
                                     std::string(*verb) + "` first, then its options";
  }
  const bool is_file = word.find_first_of("./") != std::string::npos;
  return "`" + word + "` is not a verb" +
         (is_file ? ": write the verb first, such as `jounce check " + word + "`"
                  : did_you_mean(nearest(word, verbs)));
}

std::string wrong_option(std::span<const char* const> given,
                         const std::vector<std::string>& options, const ProgramInfo& program,
                         const std::string& verb) {
  if (const std::string pair = number_and_unit(given); !pair.empty())
    return "`" + pair + "` is one value: write it without a space";
  for (const std::string word : given) {
    if (word == "--") return misplaced_dashes(given, options);
    const std::string name = word.substr(0, word.find('='));
    if (!looks_like_option(name) ||
        std::find(options.begin(), options.end(), name) != options.end())
      continue;
    const VerbInfo* const own = program.verb(verb);
    const std::string argument = own == nullptr ? "" : meant_argument(given, name, *own);
    return "`" + name + "` is not an option of " + (verb.empty() ? program.name : verb) +
           (argument.empty() ? meant_option(name, program, verb) : argument);
  }
  const VerbInfo* const own = program.verb(verb);
  if (own == nullptr) return "";
  const Options all = given_options(given, *own);
  const std::string excluding = excluding_options(all);
  return excluding.empty() ? missing_option(all, *own) : excluding;
}

std::string parser_sentence(std::string text, bool extra, std::span<const char* const> given,
                            const VerbInfo* verb) {
  if (const std::string excludes = " excludes "; text.find(excludes) != std::string::npos)
    return text.replace(text.find(excludes), excludes.size(), " cannot be combined with ") +
           ": give one of the two";
  if (const auto most = text.find(": At Most 1 required"); most != std::string::npos)
    return text.substr(0, most) + " is given twice";
  const std::string valueless = ": 1 required value missing";
  if (text.ends_with(valueless))
    return text.substr(0, text.size() - valueless.size()) + " has no value after it";
  const std::string required = " is required";
  if (text.ends_with(required)) {
    const std::string first = text.substr(0, text.size() - required.size());
    return verb == nullptr ? first + " is missing" : missing_words(first, given, *verb);
  }
  if (const auto flag = text.find(" was given a disallowed flag override");
      flag != std::string::npos)
    return "--" + text.substr(0, flag) + " takes no value: write it alone, or leave it out";
  if (!extra) return text;
  const std::size_t colon = text.find(": ");
  const std::string all = text.substr(colon == std::string::npos ? 0 : colon + 2);
  // The parser reads the words from the last one on, so the first of several is at the end.
  const std::size_t space = all.rfind(' ');
  return "`" + all.substr(space == std::string::npos ? 0 : space + 1) +
         "` is one argument too many";
}

std::string wrapped(std::string text, std::size_t width) {
  for (std::size_t begin = 0; text.size() - begin > width;) {
    std::size_t at = text.rfind(' ', begin + width);
    if (at == std::string::npos || at <= begin) at = text.find(' ', begin);
    if (at == std::string::npos) break;
    text[at] = '\n';
    begin = at + 1;
  }
  return text;
}

}  // namespace jounce
