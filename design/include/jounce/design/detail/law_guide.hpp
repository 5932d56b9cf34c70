// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/laws/law.hpp"

/// The guide to motion laws. It is generated from the data that design() uses, so the guide always
/// agrees with the laws.

namespace jounce {

/// Returns the form of a law that the guide shows: its default form; for `scca`, a form in the
/// middle of the family.
LawForm shown_form(Law law);

/// Returns the law of this name. Throws InputError (key "law"), with the nearest name, if no law
/// has the name.
Law law_of(const std::string& name);
/// Returns the names of all laws.
std::vector<std::string> law_names();
/// Returns the laws that have characteristic values, that is, a rise of their own from 0 to 1.
std::vector<Law> rising_laws();
/// Returns the characteristic values of one of the rising_laws().
Characteristics characteristics(Law law);

/// Returns the permitted ends of a law, as text.
const char* ends_in_words(Ends ends);

/// Returns a table with one line for each law: name, permitted ends, characteristic values.
std::string law_table();

/// Returns the full description of one law.
std::string law_text(Law law);

/// Returns the description as a JSON object with the characteristic values (null if infinite).
std::string law_json(Law law);
/// Returns a JSON list with law_json() of each law.
std::string laws_json();

/// Returns the text of docs/laws.md.
std::string laws_markdown();

}  // namespace jounce
