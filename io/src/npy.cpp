// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/npy.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "jounce/io/detail/table_parts.hpp"

#include "io/src/table_npy.hpp"

namespace jounce {
namespace {

template <class Integer>
void append_little_endian(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

/// A text as Python writes it.
std::string literal(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += (c == '\'' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "'";
}

/// Magic, version, length and description, filled up so that the data begin at a multiple of 64.
std::string head_of(const std::string& description) {
  const bool ascii = std::all_of(description.begin(), description.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
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

NpyFile::NpyFile(const std::vector<NpyField>& fields, std::size_t rows) {
  std::string all;
  for (const NpyField& f : fields)
    all += (all.empty() ? "(" : ", (") + literal(f.name) +
           (f.type == NpyType::whole ? ", '<i8')" : ", '<f8')");
  bytes_ = head_of("{'descr': [" + all + "], 'fortran_order': False, 'shape': (" +
                   std::to_string(rows) + ",), }");
}

void NpyFile::add(std::uint64_t value) {
  append_little_endian(bytes_, value);
}

void NpyFile::add(double value) {
  append_little_endian(bytes_, std::bit_cast<std::uint64_t>(value));
}

std::string to_npy(const TableFile& file) {
  const auto& [x, p, v, a] = file.table.columns();
  const std::array all{&x, &p, &v, &a};
  std::vector<NpyField> fields;
  for (const std::string& name : io_detail::column_names(file.table.axis(), file.table.rule()))
    fields.push_back({name});
  NpyFile npy(fields, file.table.size());
  for (std::size_t i = 0; i < file.table.size(); ++i)
    for (std::size_t column = 0; column < fields.size(); ++column) npy.add((*all[column])[i]);
  return npy.bytes();
}

}  // namespace jounce
