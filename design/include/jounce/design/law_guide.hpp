// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/laws/law.hpp"

/// The guide to choosing a law: generated from the data of design(), so both always agree.
namespace jounce {

/// The shape of the law in the guide: its own, or for `scca` one in the middle of its family.
LawForm shown_form(Law law);

/// The law of this name. Throws InputError (key "law"), with the nearest name, if there is none.
Law law_of(const std::string& name);

/// The laws that have characteristic values: a rise of their own from 0 to 1.
std::vector<Law> rising_laws();
Characteristics characteristics(Law law);

/// Permitted ends of the law, as text.
const char* ends_in_words(Ends ends);

/// One line for each law: its word, its ends, its characteristic values.
std::string law_table();

/// One law, in full.
std::string law_text(Law law);

/// The law as a JSON object: its words, and its characteristic values (null where they are infinite).
std::string law_json(Law law);
/// The same of all laws, a list.
std::string laws_json();

/// docs/laws.md.
std::string laws_markdown();

}  // namespace jounce
