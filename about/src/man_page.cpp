// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/man_page.hpp"

#include <cctype>
#include <string_view>

namespace jounce {
namespace {

/// The escape of a character that roff reads as a command, or prints as a typographic sign; "" for any other.
std::string_view escape(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return "";
  }
}

/// A text for roff, which prints it as it is.
std::string roff(std::string_view text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && c == '.') out += "\\&";
    const std::string_view escaped = escape(c);
    if (escaped.empty()) out += c;
    out += escaped;
    line_begins = c == '\n';
  }
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string section(std::string_view title) {
  return ".SH " + std::string(title) + "\n";
}

/// A paragraph with a tag: an option, a verb, an exit status. The tag is roff already.
std::string tagged(const std::string& tag, std::string_view text) {
  return ".TP\n" + tag + "\n" + roff(text) + "\n";
}

std::string placeholder(const OptionInfo& option) {
  return option.value == OptionValue::number ? "number" : "value";
}

/// "-o, --output value"; of a positional argument its name.
std::string tag_of(const OptionInfo& option) {
  std::string tag;
  for (const std::string& name : option.names) {
    if (!tag.empty()) tag += ", ";
    tag += name.starts_with('-') ? bold(name) : italic(name);
  }
  if (option.value != OptionValue::none && option.names.front().starts_with('-'))
    tag += " " + italic(placeholder(option));
  return tag;
}

/// The help of an option as sentences, with its default and what is required.
std::string text_of(const OptionInfo& option) {
  std::string text = option.help;
  if (!option.default_value.empty()) text += ". Default: " + option.default_value;
  if (option.required && option.names.front().starts_with('-')) text += ". Required";
  return text + (text.ends_with('.') ? "" : ".");
}

std::string options_section(std::string_view title, const std::vector<OptionInfo>& options) {
  if (options.empty()) return "";
  std::string out = section(title);
  for (const OptionInfo& option : options) out += tagged(tag_of(option), text_of(option));
  return out;
}

std::string exit_section(const ProgramInfo& program) {
  std::string out = section("EXIT STATUS");
  for (const auto& [status, meaning] : program.exit_statuses)
    out += tagged(bold(std::to_string(status)), meaning);
  return out;
}

std::string head(const std::string& name, const std::string& description, const BuildInfo& build) {
  return ".\\\" Made from the options of the program.\n.TH " + roff(upper(name)) + " 1 \"" +
         build.date + "\" \"jounce " + roff(build.version) + "\" \"User Commands\"\n" +
         section("NAME") + roff(name) + " \\- " + roff(description) + "\n";
}

std::string synopsis(const ProgramInfo& program, const VerbInfo& verb) {
  std::string out =
      section("SYNOPSIS") + bold(program.name + " " + verb.name) + " [" + italic("OPTIONS") + "]";
  for (const OptionInfo& positional : verb.positionals) {
    const std::string name = italic(positional.names.front()) + (positional.repeated ? "..." : "");
    out += positional.required ? " " + name : " [" + name + "]";
  }
  return out + "\n";
}

std::string examples_section(const VerbInfo& verb) {
  if (verb.examples.empty()) return "";
  std::string out = section("EXAMPLES") + ".nf\n";
  for (const std::string& line : verb.examples) out += roff(line) + "\n";
  return out + ".fi\n";
}

}  // namespace

std::string man_page(const ProgramInfo& program, const BuildInfo& build) {
  std::string out = head(program.name, program.description, build) + section("SYNOPSIS") +
                    bold(program.name) + " " + italic("VERB") + " [" + italic("OPTIONS") + "]\n" +
                    section("DESCRIPTION") + roff(program.notes) + "\n" + section("VERBS");
  for (const VerbInfo& verb : program.verbs)
    out += tagged(bold(program.name + "-" + verb.name) + "(1)", verb.description);
  out += options_section("OPTIONS", program.options) + exit_section(program);
  return out + section("SEE ALSO") + "The pages in " + italic("/usr/share/doc/" + program.name) +
         ".\n";
}

std::string man_page(const ProgramInfo& program, const VerbInfo& verb, const BuildInfo& build) {
  return head(program.name + "-" + verb.name, verb.description, build) + synopsis(program, verb) +
         options_section("ARGUMENTS", verb.positionals) + options_section("OPTIONS", verb.options) +
         exit_section(program) + examples_section(verb) + section("SEE ALSO") + bold(program.name) +
         "(1)\n";
}

std::map<std::string, std::string> man_pages(const ProgramInfo& program, const BuildInfo& build) {
  std::map<std::string, std::string> pages{{program.name + ".1", man_page(program, build)}};
  for (const VerbInfo& verb : program.verbs)
    pages[program.name + "-" + verb.name + ".1"] = man_page(program, verb, build);
  return pages;
}

}  // namespace jounce
