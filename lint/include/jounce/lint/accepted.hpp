// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/report/diagnostic.hpp"

namespace jounce {

/// The accepted versions of files: a folder with the same structure, or a revision of a git repository.
///
/// A file has its accepted version under its own path (relative to the current folder, or to the root of the
/// repository). In a folder, that version may also be a table: `cams/feeder.csv` or `.json` for `cams/feeder.toml`.
///
/// A revision is written into a temporary folder, which the destructor removes; the repository and its index are not
/// changed.
class AcceptedVersions {
 public:
  /// Throws InputError (key "--baseline") for a text that is not a folder or a revision,
  /// std::system_error if git cannot be run.
  explicit AcceptedVersions(std::string folder_or_revision);
  ~AcceptedVersions();
  AcceptedVersions(const AcceptedVersions&) = delete;
  AcceptedVersions& operator=(const AcceptedVersions&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] bool is_revision() const { return !temporary_.empty(); }

  /// Path of a file relative to the folder.
  [[nodiscard]] std::filesystem::path relative(const std::string& file) const;
  /// The path that an accepted version has among the files, relative to the current folder.
  [[nodiscard]] std::string file_of(const std::filesystem::path& version) const;
  /// The accepted version of a file; nothing if there is none.
  [[nodiscard]] std::optional<std::filesystem::path> version_of(const std::string& file) const;

 private:
  std::string name_;
  std::filesystem::path folder_;
  std::filesystem::path root_;       ///< root of the repository, or the current folder
  std::filesystem::path temporary_;  ///< empty for a folder
};

/// The change of one file.
struct FileChange {
  enum class What { same, changed, added, removed, renamed };
  What what = What::same;
  std::string file;                          ///< "" if removed
  std::string before = {};                   ///< name of the accepted version
  std::vector<Comparison> comparisons = {};  ///< for each axis
  std::vector<Tolerance> tolerances = {};    ///< tolerance of each comparison
  std::vector<Diagnostic> diagnostics = {};  ///< rules baseline/...
  std::vector<std::string> pictures = {};    ///< names of the two pictures of each comparison
  std::vector<Output> files = {};            ///< the pictures, named without a folder
};

struct AcceptedOptions {
  /// Tolerance for the numbers of an axis with these labels.
  std::function<Tolerance(const Labels&)> tolerance = [](const Labels&) { return Tolerance{}; };
  bool pictures = false;  ///< draws each change: before, and after over before
};

/// Compares files with their accepted versions, on all cores: first the files in their order, then the removed ones
/// among `names` (folders and patterns, as find_files() takes them). A motion is compared exactly, a table with a
/// table; a file without a motion by its text. A file that is new here and whose bytes or whose `name` an accepted
/// file has that is gone is renamed.
std::vector<FileChange> compare_with(const AcceptedVersions& accepted,
                                     const std::vector<std::string>& files,
                                     const std::vector<std::string>& names,
                                     const AcceptedOptions& options = {});

/// "compared with main: 1 changed, 1 added, 38 the same", then the changes as text.
std::string to_text(const std::vector<FileChange>& changes, const std::string& name);

/// The same as Markdown for a pull request, with the pictures in the folder of the text.
std::string to_markdown(const std::vector<FileChange>& changes, const std::string& name);

}  // namespace jounce
