// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/lint.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "jounce/base/detail/parallel.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/design/detail/diagnostics.hpp"
#include "jounce/design/detail/path_text.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/spec/axis_drive.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/spec.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/study/detail/sweep_spec.hpp"
#include "jounce/validate/loop.hpp"

namespace jounce {
namespace {

bool is_key_file(const std::string& path) {
  return path.ends_with(".key") && is_jounce_file(path);
}

/// Reads the specs of the axes of a machine; if they are right, examines the whole machine.
void require_axes(const MachineSpec& machine, const ExamineMachine& executor) {
  std::vector<InputError> errors;
  for (const MachineSpec::Axis& axis : machine.axes) {
    const std::string key = axis.key + ".spec";
    const InputError other_kind =
        machine.document.located(InputError(key, axis.spec, "must be a spec of kind \"axis\""));
    const auto located = [&](const InputError& error) {
      const bool is_other =
          error.key() == "kind" && (error.value() == "\"machine\"" || error.value() == "\"sweep\"");
      return is_other ? other_kind : machine.document.naming(key, axis.spec, error);
    };
    try {
      const Spec spec = read_spec(axis.spec);
      if (!std::holds_alternative<AxisSpec>(spec.subject)) throw InputError(other_kind);
      if (executor.axis) executor.axis(spec);
    } catch (const InputError& error) {
      for (const InputError& one : all_errors(error)) errors.push_back(located(one));
    }
  }
  if (!errors.empty()) throw InputErrors(std::move(errors));
  if (executor.machine) executor.machine(machine);
}

bool has_no_commands(const Spec& spec) {
  const auto* path = std::get_if<PathSpec>(&spec.subject);
  return path != nullptr && path->program.commands().empty();
}

/// Checks a spec that describes no motion; false if it describes one.
bool lint_without_motion(const Spec& spec, const ExamineMachine& executor, FileResult& result) {
  if (std::holds_alternative<AxisSpec>(spec.subject)) {
    (void)axis_drive(spec);
    if (executor.axis) executor.axis(spec);
    return true;
  }
  if (!std::holds_alternative<DriveAlone>(spec.subject)) return has_no_commands(spec);
  Report report;
  if (spec.drive)
    if (auto unstable = unstable_loop(spec.drive->drive))
      report.findings.push_back(*std::move(unstable));
  result.diagnostics = diagnostics_of(report, spec, result.file);
  return true;
}

void examine_motions(std::vector<Input> inputs, const Examine& examine, FileResult& result) {
  std::vector<Report> reports = examine(inputs);
  if (const Input& first = inputs.front(); first.plan) {
    const Report along = path_report(*first.spec, *first.plan);
    auto& findings = reports.front().findings;
    findings.insert(findings.end(), along.findings.begin(), along.findings.end());
  }
  for (std::size_t i = 0; i < reports.size(); ++i) {
    auto part = diagnostics_of(reports[i], inputs[i], result.file);
    std::move(part.begin(), part.end(), std::back_inserter(result.diagnostics));
  }
}

void lint_text_into(FileResult& result, std::string text, const Examine& examine,
                    const ExamineMachine& executor) {
  const std::string& path = result.file;
  if (is_finished_table(text, path)) {
    result.kind = "table";
    return examine_motions(table_inputs(text, path), examine, result);
  }
  result.kind = spec_kind(text);
  const std::string name = path == "-" ? "standard input" : path;
  if (result.kind == "sweep") {
    (void)parse_sweep(std::move(text), path);
  } else if (const auto axes = parse_machine(text, name)) {
    require_axes(*axes, executor);
  } else {
    (void)parse_spec(std::move(text), name, [&](const Spec& spec) {
      if (!lint_without_motion(spec, executor, result))
        examine_motions(inputs_of(spec, path), examine, result);
    });
  }
}

void lint_into(FileResult& result, const Examine& examine, const std::string& machine,
               const ExamineMachine& executor) {
  const std::string& path = result.file;
  if (!machine.empty() && !is_jounce_file(path)) {
    result.kind = "G-code";
    return examine_motions(gcode_inputs(path, machine), examine, result);
  }
  if (is_key_file(path)) {
    result.kind = "key";
    (void)read_key(path);
    return;
  }
  lint_text_into(result, read_file(path), examine, executor);
}

/// The result of `lint`, which adds the findings of a file to it.
template <class Lint>
FileResult result_of(const std::string& path, const Lint& lint) {
  FileResult result{path};
  try {
    lint(result);
  } catch (const InputError& error) {
    result.diagnostics = diagnostics_of(error, path);
  }
  sort(result.diagnostics);
  return result;
}

}  // namespace

FileResult lint_file(const std::string& path, const Examine& examine, const std::string& machine,
                     const ExamineMachine& executor) {
  return result_of(path,
                   [&](FileResult& result) { lint_into(result, examine, machine, executor); });
}

FileResult lint_text(const std::string& path, std::string text, const Examine& examine) {
  return result_of(
      path, [&](FileResult& result) { lint_text_into(result, std::move(text), examine, {}); });
}

std::vector<FileResult> lint_files(const std::vector<std::string>& paths, const Examine& examine,
                                   const std::string& machine,
                                   const std::function<void(double)>& progress,
                                   const ExamineMachine& executor) {
  std::vector<FileResult> results(paths.size());
  on_all_cores(
      paths.size(),
      [&](std::size_t i) { results[i] = lint_file(paths[i], examine, machine, executor); },
      progress);
  return results;
}

bool is_without_motion(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  if (is_key_file(path)) return true;
  const std::string text = read_file(path);
  if (is_finished_table(text, path)) return false;
  const std::string kind = spec_kind(text);
  if (kind == "path") {
    try {
      return has_no_commands(parse_spec(text, path));
    } catch (const InputError&) {
      return false;  // the reader of the motion reports the error
    }
  }
  return kind == "axis" || kind == "machine" || kind == "drive" || kind == "sweep";
}

std::string repository_path(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path here = fs::current_path(none);
  const fs::path full = fs::weakly_canonical(fs::absolute(path, none), none);
  for (fs::path root = full.parent_path(); !root.empty(); root = root.parent_path()) {
    if (fs::exists(root / ".git", none)) return full.lexically_relative(root).generic_string();
    if (root == root.root_path()) break;
  }
  const fs::path relative = full.lexically_relative(fs::weakly_canonical(here, none));
  return relative.empty() || *relative.begin() == ".." ? path : relative.generic_string();
}

}  // namespace jounce
