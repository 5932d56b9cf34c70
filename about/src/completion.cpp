// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/completion.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace jounce {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

const OptionInfo* option_named(const std::vector<OptionInfo>& options, const std::string& name) {
  const auto found = std::ranges::find_if(options, [&](const OptionInfo& option) {
    return std::ranges::count(option.names, name) > 0;
  });
  return found == options.end() ? nullptr : &*found;
}

/// The words of a command line before the cursor.
struct Before {
  const OptionInfo* open = nullptr;  ///< option whose value stands at the cursor
  std::set<const OptionInfo*> given;
  std::size_t positionals = 0;
  bool options_end = false;  ///< after --
};

Before before(const std::vector<OptionInfo>& options, const std::vector<std::string>& words) {
  Before out;
  for (const std::string& word : words) {
    if (out.open != nullptr) {
      if (word != "=") out.open = nullptr;
    } else if (out.options_end || !is_option(word)) {
      ++out.positionals;
    } else if (word == "--") {
      out.options_end = true;
    } else if (const auto* option = option_named(options, word.substr(0, word.find('=')))) {
      out.given.insert(option);
      if (option->value != OptionValue::none && word.find('=') == std::string::npos)
        out.open = option;
    }
  }
  return out;
}

/// The values of an option that begin with `begun`, each after `prefix`.
Completion values(const OptionInfo& option, const std::string& begun,
                  const std::string& prefix = "") {
  Completion out;
  if (!option.words) {
    out.files = option.value == OptionValue::text;
    return out;
  }
  for (const std::string& word : option.words())
    if (word.starts_with(begun)) out.candidates.push_back({prefix + word, ""});
  return out;
}

/// The names of the options that are not given yet, or can be repeated. Long names, or short ones without a long one.
Completion names(const std::vector<OptionInfo>& options, const Before& line,
                 const std::string& begun) {
  Completion out;
  for (const OptionInfo& option : options) {
    if (line.given.contains(&option) && !option.repeated) continue;
    const std::string& name = option.names.back();
    if (name.starts_with(begun)) out.candidates.push_back({name, option.help});
  }
  return out;
}

Completion option_at(const std::vector<OptionInfo>& options, const Before& line,
                     const std::string& word) {
  const std::size_t sign = word.find('=');
  if (sign == std::string::npos) return names(options, line, word);
  const auto* option = option_named(options, word.substr(0, sign));
  if (option == nullptr || option->value == OptionValue::none) return {};
  return values(*option, word.substr(sign + 1), word.substr(0, sign + 1));
}

Completion verb_at(const ProgramInfo& program, const std::string& word) {
  if (word.starts_with('-')) return option_at(program.options, {}, word);
  Completion out;
  for (const VerbInfo& verb : program.verbs)
    if (verb.name.starts_with(word)) out.candidates.push_back({verb.name, verb.description});
  return out;
}

}  // namespace

Completion complete(const ProgramInfo& program, const std::vector<std::string>& words) {
  if (words.size() < 2) return verb_at(program, words.empty() ? "" : words.front());
  const VerbInfo* verb = program.verb(words.front());
  if (verb == nullptr) return {};
  const Before line = before(verb->options, {words.begin() + 1, words.end() - 1});
  const std::string& word = words.back();
  if (line.open != nullptr) return values(*line.open, word == "=" ? "" : word);
  if (word.starts_with('-') && !line.options_end) return option_at(verb->options, line, word);
  if (verb->positionals.empty()) return {};
  const std::size_t last = verb->positionals.size() - 1;
  if (line.positionals > last && !verb->positionals[last].repeated) return {};
  return values(verb->positionals[std::min(line.positionals, last)], word);
}

std::string completion_lines(const Completion& completion) {
  std::string out;
  for (const Candidate& each : completion.candidates) out += each.word + "\t" + each.help + "\n";
  return out + (completion.files ? ":files\n" : "");
}

}  // namespace jounce
