// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce::fuzz {
namespace {

template <class Write>
void check(const TableFile& file, Write write) {
  const std::string text = write(file);
  const TableFile back = parse_table(text, "again");
  require(content_hash(back.table, back.units) == content_hash(file.table, file.units),
          "a table that was read is written and read as the same");
}

}  // namespace

void table(Input input) {
  const std::string text = text_of(input);
  try {
    const TableFile file = parse_table(text, "fuzz");
    check(file, to_csv);
    check(file, to_json);
  } catch (const InputError&) {
  }
  try {
    static_cast<void>(is_table(text));
    if (exchange_format_of_text(text) != nullptr) static_cast<void>(parse_exchange(text, "fuzz"));
  } catch (const InputError&) {
  }
  try {
    static_cast<void>(parse_exchange_tables(text, "fuzz.trj"));  // a format of this ending only
  } catch (const InputError&) {
  }
}

}  // namespace jounce::fuzz
