// SPDX-License-Identifier: Apache-2.0
// The inputs of a spec and of a table.
#include "jounce/design/input.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/hash.hpp"

namespace jounce {
namespace {

Input from_made(Made made, const Spec& spec, const std::string& path) {
  const AxisPart& part = made.part;
  const bool is_table = std::holds_alternative<Table>(spec.subject) && spec.then.empty();
  const std::string name = spec.name.empty() ? printable(path) : spec.name;
  return {.spec = spec,
          .curve = std::move(made.curve),
          .table = {.table = std::move(made.sampled.table),
                    .units = part.units,
                    .provenance = {.spec = path == "-" ? "" : printable(path),
                                   .spec_sha256 = hex(spec.document.hash),
                                   .made_by = made_by()}},
          .error = is_table ? std::nullopt : std::optional(made.sampled.error),
          .limits = part.limits,
          .labels = {.units = part.units,
                     .over_master = spec.over_master(),
                     .segments = std::move(made.segments)},
          .name = part.name.empty() ? name : name + " " + part.name,
          .axis = part.name,
          .options = part.table,
          .drive = part.drive,
          .residuals = std::move(made.residuals),
          .zones = std::move(made.zones),
          .binding = made.sampled.binding,
          .plan = std::move(made.plan),
          .overlap = std::move(made.overlap),
          .fit = made.fit,
          .files = spec.document.all_files()};
}

}  // namespace

Input input_of(TableFile file, const std::string& path) {
  LazyCurve curve(file.table);
  Labels labels{
      .units = file.units, .over_master = file.table.axis() == Domain::master, .segments = {}};
  return {.spec = std::nullopt,
          .curve = std::move(curve),
          .table = std::move(file),
          .error = std::nullopt,
          .limits = {},
          .labels = std::move(labels),
          .name = printable(path),
          .axis = ""};
}

std::vector<std::string> files_of(std::span<const Input> inputs) {
  std::vector<std::string> all;
  for (const Input& input : inputs) all.insert(all.end(), input.files.begin(), input.files.end());
  return all;
}

std::vector<Input> inputs_of(const Spec& spec, const std::string& path) {
  std::vector<Input> all;
  for (Made& made : make_axes(spec)) all.push_back(from_made(std::move(made), spec, path));
  return all;
}

}  // namespace jounce
