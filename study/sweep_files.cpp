#include "jounce/study/sweep_files.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "jounce/io/hash.hpp"
#include "jounce/io/printable.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce {
namespace {

constexpr std::array verdicts{"within", "broken", "impossible"};

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// RFC 4180: in quotes where a comma or a quote stands in it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

template <class Integer>
void append_little_endian(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

void append(std::string& bytes, std::size_t value) {
  append_little_endian(bytes, static_cast<std::uint64_t>(value));
}

void append(std::string& bytes, double value) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
}

/// A text as Python writes it.
std::string literal(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "'";
}

/// Magic, version, length and description, filled up so that the data begin at a multiple of 64:
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
std::string npy_head(const std::string& description) {
  bool ascii = true;
  for (const char c : description) ascii = ascii && static_cast<unsigned char>(c) < 0x80U;
  const bool is_long = description.size() > 65'000;
  const char version = !ascii ? 3 : is_long ? 2 : 1;
  const std::size_t prefix = version == 1 ? 10 : 12;
  const std::size_t whole = (prefix + description.size() + 1 + 63) / 64 * 64;
  std::string head("\x93NUMPY", 6);
  head += version;
  head += '\0';
  if (version == 1)
    append_little_endian(head, static_cast<std::uint16_t>(whole - prefix));
  else
    append_little_endian(head, static_cast<std::uint32_t>(whole - prefix));
  head += description;
  head.resize(whole - 1, ' ');
  return head + '\n';
}

}  // namespace

std::string to_csv(const SweepSpec& spec, const SweepResult& result) {
  std::string text = "# jounce sweep 1\n";
  text += "# sweep: " + printable(spec.document.name) + '\n';
  text += "# sweep sha256: " + hex(sha256(spec.document.text)) + '\n';
  text += "# spec: " + printable(spec.base.document().name) + '\n';
  text += "# spec sha256: " + hex(sha256(spec.base.document().text)) + '\n';
  text += "# made by: " + made_by() + "\ncase,";
  for (const SweepParameter& p : spec.parameters) text += cell(with_unit(p.key, p.unit)) + ',';
  for (const KeyFigure& f : spec.given) text += cell(with_unit(f.name, f.unit)) + ',';
  text += "verdict,why\n";
  for (const SweepRow& row : result.rows) {
    text += std::to_string(row.number + 1) + ',';
    for (const auto& change : spec.numbers(row.number)) text += number(change.value) + ',';
    for (const double value : row.figures)
      text += (row.verdict == Verdict::impossible ? "" : number(value)) + ',';
    text += std::string(verdicts[static_cast<std::size_t>(row.verdict)]) + ',' + cell(row.why);
    text += '\n';
  }
  return text;
}

std::string to_npy(const SweepSpec& spec, const SweepResult& result) {
  std::string fields = "('case', '<i8'), ";
  for (const SweepParameter& p : spec.parameters) fields += "(" + literal(p.key) + ", '<f8'), ";
  for (const KeyFigure& f : spec.given) fields += "(" + literal(f.name) + ", '<f8'), ";
  std::string bytes =
      npy_head("{'descr': [" + fields + "('verdict', '<i8')], 'fortran_order': False, 'shape': (" +
               std::to_string(result.rows.size()) + ",), }");
  for (const SweepRow& row : result.rows) {
    append(bytes, row.number + 1);
    for (const auto& change : spec.numbers(row.number)) append(bytes, change.value);
    for (const double value : row.figures) append(bytes, value);
    append(bytes, static_cast<std::size_t>(row.verdict));
  }
  return bytes;
}

}  // namespace jounce
