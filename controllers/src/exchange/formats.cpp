// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/formats.hpp"

#include <algorithm>
#include <array>

#include "jounce/io/table_file.hpp"

namespace jounce {
namespace controllers_detail {
namespace {

// In the order of their detection: files of columns last.
constexpr std::array all_rows{
    &codesys_format,  &twincat_format,    &siemens_format, &siemens_points_format,
    &rockwell_format, &kollmorgen_format, &sew_format,     &pairs_format,
    &xyva_format};

}  // namespace

std::span<const FormatRow* const> format_rows() {
  return all_rows;
}

const FormatRow& row_of(const CamFormat& format) {
  return **std::find_if(all_rows.begin(), all_rows.end(),
                        [&](const FormatRow* row) { return &row->format == &format; });
}

}  // namespace controllers_detail

namespace {

template <class Condition>
const CamFormat* first_format(const Condition& holds) {
  for (const controllers_detail::FormatRow* row : controllers_detail::all_rows)
    if (holds(*row)) return &row->format;
  return nullptr;
}

}  // namespace

std::span<const CamFormat* const> cam_formats() {
  static const auto formats = [] {
    std::array<const CamFormat*, controllers_detail::all_rows.size()> all{};
    std::transform(controllers_detail::all_rows.begin(), controllers_detail::all_rows.end(),
                   all.begin(), [](const auto* row) { return &row->format; });
    return all;
  }();
  return formats;
}

const CamFormat* cam_format_named(const std::string& word) {
  return first_format([&](const auto& row) { return word == row.format.name; });
}

const CamFormat* cam_format_of_path(const std::string& path) {
  const std::string lower = controllers_detail::lower(path);
  return first_format([&](const auto& row) {
    const std::string extension = row.format.extension;
    return !extension.empty() && lower.ends_with(extension);
  });
}

const CamFormat* cam_format_of_text(const std::string& text) {
  if (is_table(text)) return nullptr;
  return first_format([&](const auto& row) { return row.detects(text); });
}

Interpolation rule_of(const CamFormat& format) {
  switch (format.join) {
    case KnotJoin::quintic:
      return Interpolation::quintic_hermite;
    case KnotJoin::clamped_spline:
      return Interpolation::cubic_hermite;
    case KnotJoin::lines:
    case KnotJoin::spline:
      break;
  }
  return Interpolation::linear;
}

}  // namespace jounce
