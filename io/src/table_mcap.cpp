// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/error.hpp"

// A table as an MCAP file (https://mcap.dev/spec): one channel with one message in JSON for each
// knot. Tools such as Foxglove plot its columns. The metadata of the channel have the properties
// of the table.
namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view magic("\x89MCAP0\r\n", 8);
constexpr const char* profile = "jounce-table";
constexpr const char* topic = "/jounce/table";

enum class Opcode : unsigned char {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  data_end = 0x0F,
};

/// The content of a record, in the encoding of MCAP: little-endian, a text with its length before it.
class Content {
 public:
  template <class Integer>
  Content& add(Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
      bytes_ += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
    return *this;
  }
  Content& add(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  Content& bytes(const std::string& bytes) {
    bytes_ += bytes;
    return *this;
  }
  [[nodiscard]] std::string record(Opcode opcode) const {
    Content head;
    head.add(static_cast<std::uint8_t>(opcode)).add(std::uint64_t{bytes_.size()});
    return head.bytes_ + bytes_;
  }
  [[nodiscard]] const std::string& text() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads contents; fails at their end.
class Cursor {
 public:
  Cursor(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) fail("", "", "is not complete: the file ends within a record");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  template <class Integer>
  Integer number() {
    Integer value = 0;
    const std::string_view bytes = take(sizeof value);
    for (std::size_t i = 0; i < sizeof value; ++i)
      value |= static_cast<Integer>(static_cast<Integer>(static_cast<unsigned char>(bytes[i]))
                                    << (8 * i));
    return value;
  }
  std::string text() { return std::string(take(number<std::uint32_t>())); }
  io_detail::TableHead texts() {
    Cursor all(take(number<std::uint32_t>()), name_);
    io_detail::TableHead map;
    while (!all.at_end()) {
      std::string key = all.text();
      map[std::move(key)] = all.text();
    }
    return map;
  }
  [[noreturn]] void fail(const std::string& key, const std::string& value,
                         const std::string& rule) const {
    throw InputError(key, printable(value), rule).at(name_);
  }

 private:
  std::string_view rest_;
  const std::string& name_;
};

/// The time of a knot in ns, for a plot: from the first knot. The knots of a cam have a distance of 1 ms.
std::uint64_t time_of(const TableFile& file, std::size_t knot) {
  constexpr double in_a_second = 1e9;
  constexpr std::uint64_t in_a_millisecond = 1'000'000;
  const std::vector<double>& x = file.table.columns().x;
  if (file.table.axis() != Domain::time || !is_convertible(file.units.x, "s"))
    return knot * in_a_millisecond;
  return static_cast<std::uint64_t>(
      std::llround((x[knot] - x.front()) * conversion(file.units.x, "s") * in_a_second));
}

std::string schema_of(const std::vector<std::string>& columns) {
  Json properties;
  for (const std::string& column : columns) properties[column] = {{"type", "number"}};
  return Json{{"type", "object"}, {"properties", properties}}.dump();
}

/// The parts of a file of this kind.
struct McapTable {
  std::optional<std::uint16_t> channel = {};
  io_detail::TableHead metadata = {};
  std::vector<std::string> knots = {};
};

void read_record(Opcode opcode, Cursor content, McapTable& table) {
  if (opcode == Opcode::channel) {
    const auto id = content.number<std::uint16_t>();
    (void)content.number<std::uint16_t>();  // its schema
    if (content.text() != topic) return;
    if (table.channel) content.fail("channel", topic, "is in the file twice");
    table.channel = id;
    if (const std::string encoding = content.text(); encoding != "json")
      content.fail("message_encoding", encoding, "must be json");
    table.metadata = content.texts();
  } else if (opcode == Opcode::message) {
    if (content.number<std::uint16_t>() != table.channel) return;
    constexpr std::size_t times = 4 + 8 + 8;  // sequence, log_time, publish_time
    (void)content.take(times);
    std::string knot;
    while (!content.at_end()) knot += content.take(1);
    table.knots.push_back(std::move(knot));
  } else if (opcode == Opcode::chunk) {
    content.fail("chunk", "",
                 "is not read: write the file without chunks (`mcap` calls this unchunked)");
  }
}

McapTable table_of(const std::string& text, const std::string& name) {
  Cursor file(text, name);
  McapTable table;
  (void)file.take(magic.size());
  while (true) {
    const auto opcode = static_cast<Opcode>(file.number<std::uint8_t>());
    const Cursor content(file.take(file.number<std::uint64_t>()), name);
    read_record(opcode, content, table);
    if (opcode == Opcode::footer) break;
  }
  if (file.take(magic.size()) != magic || !file.at_end())
    file.fail("", "", "is not complete: the file does not end with the magic bytes of MCAP");
  if (!table.channel) file.fail("channel", topic, "is missing");
  return table;
}

/// The columns, from one message for each knot.
void read_knots(const McapTable& table, const std::string& name, io_detail::TableParts& parts) {
  const auto names = io_detail::column_names(parts.axis, parts.rule);
  const std::array to{&parts.columns.x, &parts.columns.p, &parts.columns.v, &parts.columns.a};
  for (std::size_t knot = 0; knot < table.knots.size(); ++knot) {
    const Json values = Json::parse(table.knots[knot], nullptr, false);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Json value =
          values.is_object() && values.contains(names[i]) ? values[names[i]] : Json();
      if (!value.is_number() || !std::isfinite(value.get<double>()))
        throw InputError("knot[" + std::to_string(knot + 1) + "]." + names[i], value.dump(),
                         "must be a finite number")
            .at(name);
      to[i]->push_back(value.get<double>());
    }
  }
}

}  // namespace

std::string to_mcap(const TableFile& file) {
  const auto columns = io_detail::column_names(file.table.axis(), file.table.rule());
  const auto& [x, p, v, a] = file.table.columns();
  const std::array values{&x, &p, &v, &a};
  Content metadata;
  for (const auto& [key, value] : io_detail::head_of(file)) metadata.add(key).add(value);
  metadata.add(std::string("knots")).add(std::to_string(file.table.size()));
  std::string bytes(magic);
  bytes += Content().add(std::string(profile)).add(file.provenance.made_by).record(Opcode::header);
  bytes += Content()
               .add(std::uint16_t{1})
               .add(std::string("jounce.knot"))
               .add(std::string("jsonschema"))
               .add(schema_of(columns))
               .record(Opcode::schema);
  bytes += Content()
               .add(std::uint16_t{0})
               .add(std::uint16_t{1})
               .add(std::string(topic))
               .add(std::string("json"))
               .add(metadata.text())
               .record(Opcode::channel);
  for (std::size_t knot = 0; knot < file.table.size(); ++knot) {
    Json all;
    for (std::size_t i = 0; i < columns.size(); ++i) all[columns[i]] = (*values[i])[knot];
    const std::uint64_t time = time_of(file, knot);
    bytes += Content()
                 .add(std::uint16_t{0})
                 .add(static_cast<std::uint32_t>(knot))
                 .add(time)
                 .add(time)
                 .bytes(all.dump())
                 .record(Opcode::message);
  }
  bytes += Content().add(std::uint32_t{0}).record(Opcode::data_end);  // without a CRC
  bytes += Content()
               .add(std::uint64_t{0})
               .add(std::uint64_t{0})
               .add(std::uint32_t{0})
               .record(Opcode::footer);
  return bytes + std::string(magic);
}

bool io_detail::is_mcap(const std::string& text) {
  constexpr std::size_t before_profile = 8 + 1 + 8 + 4;
  return text.starts_with(magic) && text.size() > before_profile &&
         std::string_view(text).substr(before_profile).starts_with(profile);
}

io_detail::TableParts io_detail::parse_mcap(const std::string& text, const std::string& name) {
  const McapTable table = table_of(text, name);
  TableParts parts = parts_of(table.metadata, name);
  const auto knots = table.metadata.find("knots");
  if (knots == table.metadata.end() || knots->second != std::to_string(table.knots.size()))
    throw InputError("knots", knots == table.metadata.end() ? "" : printable(knots->second),
                     "the number of messages is " + std::to_string(table.knots.size()) +
                         ": is the file complete?")
        .at(name);
  read_knots(table, name, parts);
  return parts;
}

}  // namespace jounce
