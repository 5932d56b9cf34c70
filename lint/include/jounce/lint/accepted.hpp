// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/report/detail/diagnostic.hpp"
#include "jounce/spec/key_changes.hpp"

namespace jounce {

/// The accepted versions of files. They are in a folder of the same structure, or in a revision of
/// a git repository.
///
/// The accepted version of a file has the same path as the file. The path is relative to the
/// current folder or, for a revision, to the root of the repository. In a folder, the accepted
/// version of a spec may also be a table: `cams/feeder.csv` or `.json` for `cams/feeder.toml`.
///
/// A revision is extracted into a temporary folder, which the destructor removes. The repository
/// and its index stay unchanged.
class AcceptedVersions {
 public:
  /// Throws InputError (key "--baseline") for a text that is neither a folder nor a revision, and
  /// std::system_error if git cannot be run.
  explicit AcceptedVersions(std::string folder_or_revision);
  ~AcceptedVersions();
  AcceptedVersions(const AcceptedVersions&) = delete;
  AcceptedVersions& operator=(const AcceptedVersions&) = delete;

  /// The text that the constructor received.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The folder that contains the accepted versions.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// True for a revision of a git repository.
  [[nodiscard]] bool is_revision() const { return !temporary_.empty(); }

  /// Returns the path of a file relative to the folder.
  [[nodiscard]] std::filesystem::path relative(const std::string& file) const;
  /// Returns the path of the file to which an accepted version belongs, relative to the current
  /// folder.
  [[nodiscard]] std::string file_of(const std::filesystem::path& version) const;
  /// Returns the path of the accepted version of a file; nullopt if the file has none.
  [[nodiscard]] std::optional<std::filesystem::path> version_of(const std::string& file) const;

 private:
  std::string name_;
  std::filesystem::path folder_;
  std::filesystem::path root_;       ///< root of the repository, or the current folder
  std::filesystem::path temporary_;  ///< empty for a folder
};

/// The difference between a file and its accepted version.
struct FileChange {
  enum class What { same, changed, added, removed, renamed, wrong };
  What what = What::same;   ///< kind of the difference; wrong: the file cannot be read
  std::string file = {};    ///< path of the file; "" if it was removed
  std::string before = {};  ///< name of the accepted version; "" if the file was added
  std::vector<Comparison> comparisons = {};  ///< comparison of each axis
  std::vector<Tolerance> tolerances = {};    ///< tolerance of each comparison
  /// Changed keys of the spec that the comparisons do not cover; see take_key_changes().
  std::vector<KeyChange> keys = {};
  std::vector<Diagnostic> diagnostics = {};  ///< findings of the rules baseline/...
  std::vector<std::string> pictures = {};    ///< names of two pictures for each comparison
  std::vector<Output> files = {};            ///< the pictures, named without a folder
  std::vector<std::string> errors = {};      ///< the errors of a wrong file
  /// For a motion: the file, its accepted version, and the files that they name.
  std::vector<std::string> inputs = {};
};

/// Options of compare_with().
struct AcceptedOptions {
  /// Tolerances for tolerance_of(). Each applies to the motions that have its key and unit.
  std::vector<std::string> tolerances = {};
  bool pictures = false;  ///< true: draws each change, before and after
};

/// Compares files with their accepted versions, on all cores. The result has the files in their
/// order, followed by the removed files: accepted files among `names` (folders and patterns, see
/// find_files()) that no longer exist. A motion is compared exactly, a table with a table, and a
/// file without a motion by its text. Two specs of a motion are also compared key by key: a changed
/// limit counts as a changed motion, another key is a warning. A new file counts as renamed if a
/// removed file has the same bytes, or the same `name` in its spec.
///
/// Throws InputError (key "tolerance") for a tolerance that is wrong, or that fits no compared
/// motion.
std::vector<FileChange> compare_with(const AcceptedVersions& accepted,
                                     const std::vector<std::string>& files,
                                     const std::vector<std::string>& names,
                                     const AcceptedOptions& options = {});

/// Returns a summary ("compared with main: 1 changed, 1 added, 38 the same") and the changes as
/// text. `name` is the name of the accepted versions.
std::string to_text(const std::vector<FileChange>& changes, const std::string& name);

/// Returns the summary and the changes as Markdown, for a pull request. The pictures must be in the
/// same folder as the text.
std::string to_markdown(const std::vector<FileChange>& changes, const std::string& name);

}  // namespace jounce
