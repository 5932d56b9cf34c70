// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/detail/parallel.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/design/detail/version.hpp"
#include "jounce/design/files/file_difference.hpp"
#include "jounce/lint/accepted.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/lint/lint.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

namespace fs = std::filesystem;
using What = FileChange::What;

Diagnostic diagnostic(const char* rule, Level level, const std::string& file, std::string message) {
  Diagnostic d;
  d.rule = rule;
  d.level = level;
  d.place.file = file;
  d.message = std::move(message);
  return d;
}

/// The curve of a spec. `as_table`: that of its table, for a comparison with another table.
Version version(const Input& input, const std::string& name, bool as_table) {
  Version made = version_of(input, name);
  if (!as_table || !input.spec) return made;
  made.curve = *LazyCurve(input.table.table);
  made.knots.clear();
  made.knot_names.clear();
  made.table.reset();
  return made;
}

/// A statement for each quantity beyond its tolerance, and for each other difference.
void add_diagnostics(FileChange& change, const Comparison& c, const Tolerance& tolerance,
                     const std::string& axis) {
  const auto& names = c.labels.over_master ? OverMaster::names : OverTime::names;
  for (std::size_t k = 0; k < c.changes.size(); ++k) {
    if (!c.beyond[k]) continue;
    const Extremum& largest = c.changes[k].largest;
    const double allowed = permitted(c.changes[k], k, tolerance).value_or(0);
    const std::string unit = c.labels.unit_of(names[k]);
    const bool exact = allowed == c.changes[k].rounding;
    Diagnostic d = diagnostic(
        "baseline/changed", Level::broken, change.file,
        fmt::format(
            "{} differs from the accepted version by {} at {}; {}", names[k],
            with_unit(largest.value, unit), with_unit(largest.where, c.labels.units.x),
            exact ? "no difference is permitted" : with_unit(allowed, unit) + " is permitted"));
    d.axis = axis;
    d.quantity = names[k];
    d.unit = unit;
    d.value = largest.value;
    d.limit = exact ? 0 : allowed;
    if (!exact && allowed > 0) d.margin = (allowed - std::abs(largest.value)) / allowed;
    d.where = largest.where;
    d.where_unit = c.labels.units.x;
    change.diagnostics.push_back(std::move(d));
  }
  for (const auto& [what, before, after] : c.remarks) {
    Diagnostic d =
        diagnostic("baseline/changed", Level::broken, change.file,
                   fmt::format("{} differs from the accepted version: {} -> {}", what,
                               before.empty() ? "none" : before, after.empty() ? "none" : after));
    d.axis = axis;
    d.quantity = what;
    change.diagnostics.push_back(std::move(d));
  }
}

/// One statement for all changed keys outside the motion, at the first of them.
void add_key_diagnostic(FileChange& change) {
  if (change.keys.empty()) return;
  const KeyChange& first = change.keys.front();
  Diagnostic d = diagnostic("baseline/changed", Level::warning, change.file,
                            "the spec " + to_text(change.keys));
  d.place.line = first.place.line;
  d.place.column = first.place.column;
  d.key = first.key;
  change.diagnostics.push_back(std::move(d));
}

/// "cams/feeder.toml x" as a name of a file without folders.
std::string picture_name(const std::string& file, const std::string& axis, const char* which) {
  std::string name = file + (axis.empty() ? "" : "-" + axis);
  for (char& c : name)
    if (c == '/' || c == '\\' || c == ' ') c = '-';
  name.erase(0, name.find_first_not_of(".-"));
  return name + "." + which + ".svg";
}

void draw(FileChange& change, Input before, const Input& after) {
  before.name = change.before;
  const std::pair<const char*, Figure> figures[]{{"before", figure_of(before)},
                                                 {"after", figure_of(after, before)}};
  for (const auto& [which, figure] : figures) {
    change.pictures.push_back(picture_name(change.file, after.axis, which));
    change.files.push_back({change.pictures.back(), svg(figure, {.width = 560})});
  }
}

/// The tolerances of a run, of which each file uses those that fit its motions.
class Tolerances {
 public:
  explicit Tolerances(const std::vector<std::string>& texts)
      : texts_(texts), used_(texts.size(), false) {}

  Tolerance of(const Labels& labels) {
    std::vector<std::string> fitting;
    const std::lock_guard lock(mutex_);
    any_ = true;
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      if (!tolerance_fits(texts_[i], labels)) continue;
      used_[i] = true;
      fitting.push_back(texts_[i]);
    }
    return tolerance_of(fitting, labels);
  }

  /// Throws if a tolerance fits none of the compared motions.
  void require_all_used() const {
    for (std::size_t i = 0; i < texts_.size(); ++i)
      if (any_ && !used_[i])
        throw InputError("tolerance", texts_[i],
                         "fits none of the compared motions: use a quantity and a unit of one of "
                         "them, or leave out this tolerance");
  }

 private:
  const std::vector<std::string>& texts_;
  std::mutex mutex_;
  std::vector<bool> used_;
  bool any_ = false;  ///< true after the first motion
};

/// Compares the motions of two files, axis by axis.
void compare_motions(FileChange& change, const std::vector<Input>& before,
                     const std::vector<Input>& after, Tolerances& tolerances, bool pictures) {
  std::vector<std::pair<const Input*, const Input*>> pairs;
  for (const Input& now : after) {
    const auto old = before.size() == 1 && after.size() == 1
                         ? before.begin()
                         : std::find_if(before.begin(), before.end(),
                                        [&](const Input& each) { return each.axis == now.axis; });
    if (old == before.end()) {
      change.diagnostics.push_back(
          diagnostic("baseline/changed", Level::broken, change.file,
                     fmt::format("the axis {} is not in the accepted version", now.axis)));
      continue;
    }
    const bool as_table = !old->spec || !now.spec;
    change.tolerances.push_back(tolerances.of(now.labels));
    change.comparisons.push_back(compare(version(*old, change.before, as_table),
                                         version(now, change.file, as_table),
                                         change.tolerances.back()));
    pairs.emplace_back(&*old, &now);
  }
  if (before.front().spec && after.front().spec)
    change.keys = take_key_changes(*before.front().spec, *after.front().spec, change.comparisons);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [old, now] = pairs[i];
    add_diagnostics(change, change.comparisons[i], change.tolerances[i], now->axis);
    if (pictures && !change.comparisons[i].equal()) draw(change, *old, *now);
  }
  for (const Input& old : before)
    if (after.size() + before.size() > 2 &&
        std::none_of(after.begin(), after.end(),
                     [&](const Input& each) { return each.axis == old.axis; }))
      change.diagnostics.push_back(
          diagnostic("baseline/changed", Level::broken, change.file,
                     fmt::format("the axis {} of the accepted version is missing", old.axis)));
  add_key_diagnostic(change);
}

/// The motions of the file. If it, or a file that it names, is wrong, nullopt, with the errors in the change.
std::optional<std::vector<Input>> motions_of(FileChange& change) {
  try {
    return read_inputs(change.file);
  } catch (const InputError& error) {  // the check of the file reports it
    change.what = What::wrong;
    for (const InputError& one : all_errors(error)) change.errors.emplace_back(one.what());
    return std::nullopt;
  }
}

/// Compares a file that has a motion with its accepted version.
void compare_motion(FileChange& change, const std::string& accepted, Tolerances& tolerances,
                    bool pictures) {
  const auto after = motions_of(change);
  if (!after) return;
  change.inputs = files_of(*after);
  try {
    const std::vector<Input> before = read_inputs(accepted);
    const std::vector<std::string> files = files_of(before);
    change.inputs.insert(change.inputs.end(), files.begin(), files.end());
    compare_motions(change, before, *after, tolerances, pictures);
  } catch (const InputError& error) {
    if (error.key() == "tolerance") throw;
    Diagnostic d = diagnostic("baseline/changed", Level::broken, change.file, error.what());
    if (error.document() == accepted)
      d.message = "the accepted version " + change.before + " cannot be compared: " +
                  InputError(error.key(), error.value(), error.rule()).what();
    change.diagnostics.push_back(std::move(d));
  }
}

/// Fills in the change of a file that has an accepted version.
void compare_file(FileChange& change, const std::string& accepted, Tolerances& tolerances,
                  bool pictures) {
  if (!is_without_motion(change.file))
    compare_motion(change, accepted, tolerances, pictures);
  else if (read_file(change.file) != read_file(accepted))
    change.diagnostics.push_back(diagnostic(
        "baseline/changed", Level::warning, change.file,
        "the text differs from the accepted version; the file has no motion to compare"));
  if (!change.diagnostics.empty() && change.what == What::same) change.what = What::changed;
}

/// The name that a file shows to people: that of its path in the repository.
std::string shown(const AcceptedVersions& accepted, const fs::path& version) {
  const std::string relative = version.lexically_relative(accepted.folder()).generic_string();
  return accepted.is_revision() ? accepted.name() + ":" + relative : version.generic_string();
}

/// The accepted files that no file has: among the same folders and patterns as the files.
std::vector<fs::path> unmatched(const AcceptedVersions& accepted,
                                const std::vector<std::string>& names,
                                const std::set<fs::path>& matched) {
  std::vector<std::string> places;
  for (const std::string& name : names)
    if (!is_one_file(name))
      places.push_back((accepted.folder() / accepted.relative(name)).string());
  std::vector<fs::path> left;
  for (const std::string& file : find_files(places))
    if (!matched.contains(fs::path(file).lexically_normal())) left.emplace_back(file);
  return left;
}

/// The `name` of a spec; "" for any other file.
std::string spec_name(const std::string& path) {
  try {
    return read_spec(path).name;
  } catch (const InputError&) {
    return "";
  }
}

/// The accepted file that was renamed to this one, by its bytes or by the name in the spec. Removes it from `left`.
std::optional<fs::path> take_renamed(std::vector<fs::path>& left, const std::string& file) {
  std::string text;
  try {
    text = read_file(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
  const std::string name = spec_name(file);
  auto found = std::find_if(left.begin(), left.end(),
                            [&](const fs::path& each) { return read_file(each.string()) == text; });
  if (found == left.end() && !name.empty())
    found = std::find_if(left.begin(), left.end(),
                         [&](const fs::path& each) { return spec_name(each.string()) == name; });
  if (found == left.end()) return std::nullopt;
  fs::path taken = *found;
  left.erase(found);
  return taken;
}

}  // namespace

std::vector<FileChange> compare_with(const AcceptedVersions& accepted,
                                     const std::vector<std::string>& files,
                                     const std::vector<std::string>& names,
                                     const AcceptedOptions& options) {
  std::vector<FileChange> changes;
  std::vector<std::optional<fs::path>> versions;
  std::set<fs::path> matched;
  for (const std::string& file : files) {
    changes.push_back({What::same, file});
    versions.push_back(accepted.version_of(file));
    if (versions.back()) matched.insert(versions.back()->lexically_normal());
  }
  std::vector<fs::path> left = unmatched(accepted, names, matched);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    FileChange& change = changes[i];
    if (!versions[i]) {
      versions[i] = take_renamed(left, change.file);
      change.what = versions[i] ? What::renamed : What::added;
    }
    if (versions[i]) change.before = shown(accepted, *versions[i]);
    if (change.what == What::renamed)
      change.diagnostics.push_back(diagnostic("baseline/renamed", Level::note, change.file,
                                              "the accepted version is " + change.before));
    if (change.what == What::added)
      change.diagnostics.push_back(diagnostic("baseline/added", Level::note, change.file,
                                              "the file has no accepted version"));
  }
  Tolerances tolerances(options.tolerances);
  on_all_cores(changes.size(), [&](std::size_t i) {
    if (versions[i]) compare_file(changes[i], versions[i]->string(), tolerances, options.pictures);
  });
  tolerances.require_all_used();
  for (const fs::path& gone : left) {
    FileChange change{What::removed, "", shown(accepted, gone)};
    change.diagnostics.push_back(
        diagnostic("baseline/removed", Level::note, accepted.file_of(gone),
                   "the file no longer exists; it is in " + accepted.name()));
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace jounce
