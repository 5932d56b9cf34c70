// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

/// The words that a user gives to a command line, before and beside its parser.
namespace jounce {

/// True for "-x" and "--x"; false for "-" and for a negative number.
bool looks_like_option(const std::string& word);

/// Returns the words as the user means them: -.5 becomes -0.5, because a parser would take it for an option. The words
/// after "--" stay. Throws InputError for an empty word, and for "--log=", which has no value.
std::vector<std::string> meant_words(std::span<const char* const> given);

/// Returns a sentence on the first of these words if it is missing or not the name of a verb, with the nearest verb;
/// "" for a verb and for an option.
std::string wrong_verb(std::span<const char* const> given, const std::vector<std::string>& verbs);

/// Returns a sentence on the first word that looks like an option and is none of `options`, with the nearest option; ""
/// if there is none. `names_output`: the verb takes its output as its second argument, not as an option. `owner`: whose
/// options they are, such as "this verb".
std::string wrong_option(std::span<const char* const> given,
                         const std::vector<std::string>& options, bool names_output = false,
                         const std::string& owner = "this verb");

/// Returns the sentence of a parser (CLI11) in the words of the other messages: what is missing, or given twice.
/// `extra`: the parser reports an argument that it does not expect.
std::string parser_sentence(std::string text, bool extra);

/// Breaks a text at its spaces into lines of at most `width` characters. A longer word gets a line of its own.
std::string wrapped(std::string text, std::size_t width);

}  // namespace jounce
