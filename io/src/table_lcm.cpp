// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <sstream>
#include <utility>

#include "jounce/base/detail/lcm_log.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/error.hpp"

#include "jounce_table/table_file_t.hpp"

// A table as an event log of LCM: one event, a message of the type in io/lcm/table_file_t.lcm. The
// tools and the bindings of LCM read it.
namespace jounce {
namespace {

using jounce_table::table_file_t;

constexpr std::string_view table_channel = "JOUNCE.table_file";
constexpr std::string_view sync_word = "\xED\xA1\xDA\x01";
constexpr std::size_t event_head = 28;  ///< bytes before the channel

/// The texts of the message, under their keys.
struct Field {
  const char* key;
  std::string table_file_t::*text;
};
constexpr std::array fields{Field{"axis", &table_file_t::axis},
                            Field{"rule", &table_file_t::rule},
                            Field{"outside", &table_file_t::outside},
                            Field{"x_unit", &table_file_t::x_unit},
                            Field{"position_unit", &table_file_t::position_unit},
                            Field{"sha256", &table_file_t::sha256},
                            Field{"spec", &table_file_t::spec},
                            Field{"spec_sha256", &table_file_t::spec_sha256},
                            Field{"made_by", &table_file_t::made_by}};

[[noreturn]] void reject_message(const std::string& name) {
  throw InputError(std::string(table_channel), "",
                   "is not a message of the type table_file_t: is the file complete?")
      .at(name);
}

/// Decodes the message. A length of a text or a list in it may be wrong, so the sizes are compared first.
table_file_t message_of(const std::string& data, const std::string& name) {
  constexpr std::size_t fingerprint = 8;
  constexpr std::size_t least = 4;  // bytes of a length, and of the zero after a text
  std::size_t at = fingerprint;
  const auto number = [&]() {
    if (data.size() < at + least) reject_message(name);
    std::size_t value = 0;
    for (std::size_t i = 0; i < least; ++i)
      value = value << 8U | static_cast<unsigned char>(data[at + i]);
    at += least;
    return value;
  };
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t length = number();
    if (length < 1 || data.size() - at < length || data[at + length - 1] != '\0')
      reject_message(name);
    at += length;
  }
  const std::size_t columns = number();
  const std::size_t knots = number();
  if (columns < 2 || columns > 4 || knots > data.size() ||
      data.size() - at != columns * knots * sizeof(double))
    reject_message(name);
  table_file_t message;
  if (message.decode(data.data(), 0, static_cast<int>(data.size())) !=
      static_cast<int>(data.size()))
    reject_message(name);
  return message;
}

}  // namespace

std::string to_lcm_log(const TableFile& file) {
  const Columns& c = file.table.columns();
  table_file_t message;
  for (const auto& [key, value] : io_detail::head_of(file))
    for (const Field& field : fields)
      if (key == field.key) message.*field.text = value;
  for (const std::vector<double>* column : {&c.x, &c.p, &c.v, &c.a})
    if (!column->empty()) message.value.push_back(*column);
  message.columns = static_cast<std::int32_t>(message.value.size());
  message.knots = static_cast<std::int32_t>(c.x.size());
  std::string data(static_cast<std::size_t>(message.getEncodedSize()), '\0');
  message.encode(data.data(), 0, static_cast<int>(data.size()));
  std::string log;
  base_detail::append(log, 0, 0, table_channel, data);
  return log;
}

bool io_detail::is_lcm_log(const std::string& text) {
  return text.starts_with(sync_word) && text.size() > event_head &&
         std::string_view(text).substr(event_head).starts_with(table_channel);
}

io_detail::TableParts io_detail::parse_lcm_log(const std::string& text, const std::string& name) {
  std::istringstream stream(text);
  base_detail::LcmLogReader log(stream, name);
  const auto event = log.next();
  if (!event)
    throw InputError("", "", "is not complete: the file ends within its first event").at(name);
  const table_file_t message = message_of(event->data, name);
  if (log.next() || log.cut())
    throw InputError("", "", "contains more than one event: a file contains one table").at(name);
  TableHead head;
  for (const Field& field : fields) head[field.key] = message.*field.text;
  TableParts parts = parts_of(head, name);
  if (message.value.size() != column_names(parts.axis, parts.rule).size())
    throw InputError("columns", std::to_string(message.columns),
                     std::string("does not fit the rule ") + jounce::name(parts.rule))
        .at(name);
  const std::array to{&parts.columns.x, &parts.columns.p, &parts.columns.v, &parts.columns.a};
  for (std::size_t i = 0; i < message.value.size(); ++i) *to[i] = message.value[i];
  return parts;
}

}  // namespace jounce
