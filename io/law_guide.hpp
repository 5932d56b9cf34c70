#pragma once

#include <string>
#include <vector>

#include "jounce/cam/characteristics.hpp"
#include "jounce/cam/law.hpp"

/// The guide to choosing a law: made of what design() uses, so that it cannot say anything else.
namespace jounce {

/// The law's shape that the guide shows: its own, and of `scca` one in the middle of its family.
LawForm shown_form(Law law);

/// The laws that have characteristic values: a rise of their own from 0 to 1.
std::vector<Law> rising_laws();
Characteristics characteristics(Law law);

/// What the law may have at its ends, in words.
const char* ends_in_words(Ends ends);

/// One line a law: its word, its ends, its characteristic values.
std::string law_table();

/// One law, in full.
std::string law_text(Law law);

/// docs/laws.md.
std::string laws_markdown();

}  // namespace jounce
