// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/about/program.hpp"
#include "jounce/profiles/error.hpp"

/// Functions for the words of a command line. They run before its parser, or in addition to it.
namespace jounce {

/// True for "-x" and "--x"; false for "-" and for a negative number.
bool looks_like_option(const std::string& word);

/// Throws InputError if the value `text` of the option `name` is the next option: the option has no
/// value. The name of an argument, such as FILE, has no "-".
void require_value(const std::string& name, const std::string& text);

/// Returns the words as the user means them: -.5 becomes -0.5, because a parser would read -.5 as
/// an option. The words after "--" stay. Throws InputError for an empty word, and for "--log=",
/// which has no value.
std::vector<std::string> meant_words(std::span<const char* const> given);

/// Returns an error sentence if the first word of `given` is missing, or is not the name of a verb
/// (the sentence then names the nearest verb). Returns "" for a verb and for an option.
std::string wrong_verb(std::span<const char* const> given, const std::vector<std::string>& verbs);

/// Returns an error sentence for the first word that looks like an option and is none of `options`;
/// "" if there is no such word. `verb` is the verb of the options, or "" for the options of the
/// program. The sentence names the option whose help begins with the word ("Format, ..." for
/// --format), the nearest visible option, or the verbs that have an option of this name.
std::string wrong_option(std::span<const char* const> given,
                         const std::vector<std::string>& options, const ProgramInfo& program,
                         const std::string& verb);

/// Rewrites an error sentence of the parser (CLI11) in the style of the other messages, for example
/// for a missing argument or an option that is given twice. `extra`: the parser reports an argument
/// that it does not expect. With a verb, the sentence names all required words that are missing among the given ones,
/// because the parser reports only the first of them.
std::string parser_sentence(std::string text, bool extra, std::span<const char* const> given = {},
                            const VerbInfo* verb = nullptr);

/// Breaks a text at its spaces into lines of at most `width` characters. A longer word gets a line
/// of its own.
std::string wrapped(std::string text, std::size_t width);

}  // namespace jounce
