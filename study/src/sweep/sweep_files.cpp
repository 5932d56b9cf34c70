// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sweep_files.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/io/detail/npy.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce {
namespace {

constexpr std::array verdicts{"within", "broken", "impossible"};

std::string column_title(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// RFC 4180: in quotes if it contains a comma or a quote.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string to_csv(const SweepSpec& spec, const SweepResult& result) {
  std::string text = "# jounce sweep 1\n";
  text += "# sweep: " + printable(spec.document.name) + '\n';
  text += "# sweep sha256: " + hex(sha256(spec.document.text)) + '\n';
  text += "# spec: " + printable(spec.base.document().name) + '\n';
  text += "# spec sha256: " + hex(sha256(spec.base.document().text)) + '\n';
  text += "# made by: " + made_by() + "\ncase,";
  for (const SweepParameter& p : spec.parameters) text += cell(column_title(p.key, p.unit)) + ',';
  for (const KeyFigure& f : spec.given) text += cell(column_title(f.name, f.unit)) + ',';
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
  std::vector<NpyField> fields{{"case", NpyType::whole}};
  for (const SweepParameter& p : spec.parameters) fields.push_back({p.key});
  for (const KeyFigure& f : spec.given) fields.push_back({f.name});
  fields.push_back({"verdict", NpyType::whole});
  NpyFile file(fields, result.rows.size());
  for (const SweepRow& row : result.rows) {
    file.add(std::uint64_t{row.number + 1});
    for (const auto& change : spec.numbers(row.number)) file.add(change.value);
    for (const double value : row.figures) file.add(value);
    file.add(static_cast<std::uint64_t>(row.verdict));
  }
  return file.bytes();
}

std::string SweepFiles::journal() const {
  for (const std::string& path : {csv, npy})
    if (!path.empty() && path != "-") return path + ".journal";
  return "";
}

void write_sweep(const SweepFiles& files, const SweepSpec& spec, const SweepResult& result) {
  std::vector<Output> all;
  if (!files.csv.empty()) all.push_back({files.csv, to_csv(spec, result)});
  if (!files.npy.empty()) all.push_back({files.npy, to_npy(spec, result)});
  write_files(all, spec.document.all_files());
}

std::string stopped_text(const SweepFiles& files, const SweepSpec& spec,
                         const SweepResult& result) {
  const std::string journal = files.journal();
  return "stopped after " + std::to_string(result.rows.size()) + " of " +
         std::to_string(spec.cases()) + " cases; " +
         (journal.empty() ? "with -o, the same command would continue from there"
                          : "continue with the same command (" + journal + ")");
}

}  // namespace jounce
