// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/accepted.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "jounce/lint/find_files.hpp"
#include "jounce/profiles/error.hpp"

#include "lint/src/git.hpp"

namespace jounce {
namespace {

namespace fs = std::filesystem;

using lint_detail::git;
using lint_detail::GitAnswer;

/// True in a clone without its history.
bool is_shallow() {
  return git({"rev-parse", "--is-shallow-repository"}).out == "true";
}

/// The full name of a commit. Throws InputError for a text that names none.
std::string commit_of(const std::string& revision) {
  const GitAnswer answer =
      git({"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
  if (answer.status != 0 || answer.out.empty())
    throw InputError("--baseline", revision,
                     std::string("is neither a folder nor a revision of git") +
                         (git({"rev-parse", "--git-dir"}).status != 0
                              ? ", and the current folder is in no repository: name a folder"
                          : is_shallow() ? ": this clone is shallow, so it has no other revisions: "
                                           "fetch the history (fetch-depth: 0)"
                                         : ": give one of the two, such as HEAD or origin/main"));
  return answer.out;
}

fs::path temporary_folder() {
  std::string name = (fs::temp_directory_path() / "jounce-baseline-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make the folder " + name);
  return name;
}

void require(const GitAnswer& answer) {
  if (answer.status != 0)
    throw std::system_error(EIO, std::generic_category(), "git: " + answer.out);
}

fs::path current() {
  return fs::canonical(fs::current_path());
}

}  // namespace

AcceptedVersions::AcceptedVersions(std::string folder_or_revision)
    : name_(std::move(folder_or_revision)) {
  if (fs::is_directory(name_)) {
    folder_ = name_;
    root_ = current();
    return;
  }
  const std::string commit = commit_of(name_);
  root_ = fs::canonical(git({"rev-parse", "--show-toplevel"}).out);
  temporary_ = temporary_folder();
  folder_ = temporary_ / "files";
  try {
    const std::string index = (temporary_ / "index").string();
    require(git({"read-tree", commit}, index));
    require(git({"-C", root_.string(), "checkout-index", "--all", "--quiet",
                 "--prefix=" + folder_.string() + "/"},
                index));
  } catch (...) {
    fs::remove_all(temporary_);
    throw;
  }
}

AcceptedVersions::~AcceptedVersions() {
  std::error_code none;
  if (!temporary_.empty()) fs::remove_all(temporary_, none);
}

fs::path AcceptedVersions::relative(const std::string& file) const {
  const fs::path path = fs::weakly_canonical(fs::absolute(file)).lexically_relative(root_);
  return path.empty() || *path.begin() == ".." ? fs::path(file).filename() : path;
}

std::string AcceptedVersions::file_of(const fs::path& version) const {
  const fs::path path = root_ / version.lexically_relative(folder_);
  return path.lexically_relative(current()).generic_string();
}

std::optional<fs::path> AcceptedVersions::version_of(const std::string& file) const {
  const fs::path same = folder_ / relative(file);
  if (fs::is_regular_file(same)) return same;
  if (is_revision()) return std::nullopt;
  for (const char* ending : {".csv", ".json"})
    if (const fs::path table = fs::path(same).replace_extension(ending);
        fs::is_regular_file(table) && is_jounce_file(table.string()))
      return table;
  return std::nullopt;
}

}  // namespace jounce
