// SPDX-License-Identifier: Apache-2.0
#include "controllers/src/exchange/formats.hpp"

#include <algorithm>
#include <array>

#include "jounce/io/table_file.hpp"

namespace jounce {
namespace controllers_detail {
namespace {

// In the order of their detection: files of columns last.
constexpr std::array all_rows{&codesys_format,
                              &plcopen_format,
                              &twincat_mc3_format,
                              &twincat_format,
                              &siemens_format,
                              &siemens_points_format,
                              &rockwell_format,
                              &ros_format,
                              &xps_format,
                              &zaber_format,
                              &galil_format,
                              &galil_pvt_format,
                              &trio_format,
                              &googol_pt_format,
                              &googol_pt_st_format,
                              &googol_follow_format,
                              &googol_follow_st_format,
                              &hmpl_format,
                              &hmpl_gear_format,
                              &kollmorgen_format,
                              &sew_format,
                              &pairs_format,
                              &xyva_format};

}  // namespace

std::span<const FormatRow* const> format_rows() {
  return all_rows;
}

const FormatRow& row_of(const ExchangeFormat& format) {
  return **std::find_if(all_rows.begin(), all_rows.end(),
                        [&](const FormatRow* row) { return &row->format == &format; });
}

}  // namespace controllers_detail

namespace {

/// True for a spec, which may mention commands of controllers in its comments.
bool is_spec(const std::string& text) {
  for (const controllers_detail::Line& line : controllers_detail::lines_of(text))
    if (line.text.starts_with("jounce") &&
        controllers_detail::trimmed(line.text.substr(6)).starts_with('='))
      return true;
  return false;
}

template <class Condition>
const ExchangeFormat* first_format(const Condition& holds) {
  for (const controllers_detail::FormatRow* row : controllers_detail::all_rows)
    if (holds(*row)) return &row->format;
  return nullptr;
}

}  // namespace

std::span<const ExchangeFormat* const> exchange_formats() {
  static const auto formats = [] {
    std::array<const ExchangeFormat*, controllers_detail::all_rows.size()> all{};
    std::transform(controllers_detail::all_rows.begin(), controllers_detail::all_rows.end(),
                   all.begin(), [](const auto* row) { return &row->format; });
    return all;
  }();
  return formats;
}

const ExchangeFormat* exchange_format_named(const std::string& word) {
  return first_format([&](const auto& row) { return word == row.format.name; });
}

const ExchangeFormat* exchange_format_of_path(const std::string& path) {
  const std::string lower = controllers_detail::lower(path);
  return first_format([&](const auto& row) {
    const std::string extension = row.format.extension;
    return !extension.empty() && lower.ends_with(extension);
  });
}

const ExchangeFormat* exchange_format_of_text(const std::string& text, const std::string& path) {
  if (is_table(text) || is_spec(text)) return nullptr;
  if (const ExchangeFormat* const format = exchange_format_of_path(path);
      format != nullptr && controllers_detail::row_of(*format).detects(text))
    return format;
  return first_format([&](const auto& row) { return !row.by_ending_only && row.detects(text); });
}

Interpolation rule_of(const ExchangeFormat& format) {
  switch (format.join) {
    case KnotJoin::quintic:
      return Interpolation::quintic_hermite;
    case KnotJoin::cubic:
    case KnotJoin::quadratic:
    case KnotJoin::clamped_spline:
      return Interpolation::cubic_hermite;
    case KnotJoin::lines:
    case KnotJoin::spline:
      break;
  }
  return Interpolation::linear;
}

}  // namespace jounce
