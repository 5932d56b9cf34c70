// SPDX-License-Identifier: Apache-2.0
#include "edit/src/session.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "jounce/base/file.hpp"
#include "jounce/base/hash.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr std::string_view side_mark = "# Unsaved text of `jounce edit`; SHA-256 of the file: ";

/// Identity, size and time of a file; "" if it does not exist. The same for unchanged files.
std::string stamp_of(const std::string& path) {
  struct stat about {};
  if (stat(path.c_str(), &about) != 0) return "";
  return fmt::format("{} {} {}.{}", about.st_ino, about.st_size, about.st_mtim.tv_sec,
                     about.st_mtim.tv_nsec);
}

}  // namespace

EditSession::EditSession(std::string path) : path_(std::move(path)) {
  if (path_ == "-")
    throw InputError("", "", "is standard input: give the name of a file, which Save can write")
        .at(path_);
  const std::string folder = std::filesystem::path(path_).parent_path().string();
  if (std::error_code none; !folder.empty() && !std::filesystem::is_directory(folder, none))
    throw InputError("", "", "the folder " + folder + " does not exist: make it first").at(path_);
  stamp_ = stamp_of(path_);
  if (stamp_.empty())
    on_disk_ = OnDisk::missing;
  else
    set_base(read_file(path_));
  versions_.push_back({base_, ""});
  recover();
}

void EditSession::set_base(std::string text) {
  base_ = std::move(text);
  base_hash_ = hex(sha256(base_));
}

/// The first line of a side file has the hash of the file to which its text belongs.
void EditSession::recover() {
  std::error_code none;
  if (!std::filesystem::exists(side_file(), none)) return;
  const std::string side = read_file(side_file());
  const std::size_t line = side.find('\n');
  if (!side.starts_with(side_mark) || line == std::string::npos)
    throw InputError("", "",
                     "was not written by `jounce edit`, which keeps unsaved text under this name: "
                     "rename the file")
        .at(side_file(), 1);
  has_side_file_ = true;
  std::string text = side.substr(line + 1);
  if (text == base_) return write_side_file();
  push(std::move(text), "recover the unsaved text");
  recovered_ = true;
  std::string hash = side.substr(side_mark.size(), line - side_mark.size());
  if (hash == base_hash_) return;
  base_hash_ = std::move(hash);
  file_ = base_;
  on_disk_ = OnDisk::changed;
}

std::optional<std::string> EditSession::undo_label() const {
  return now_ == 0 ? std::nullopt : std::optional(versions_[now_].label);
}

std::optional<std::string> EditSession::redo_label() const {
  return now_ + 1 == versions_.size() ? std::nullopt : std::optional(versions_[now_ + 1].label);
}

void EditSession::push(std::string text, std::string label) {
  versions_.resize(now_ + 1);
  versions_.push_back({std::move(text), std::move(label)});
  ++now_;
}

void EditSession::changed() {
  ++revision_;
  recovered_ = false;
  if (on_disk_ == OnDisk::changed && text() == file_) {
    set_base(file_);
    on_disk_ = OnDisk::same;
  }
  write_side_file();
}

/// An error does not stop the work: the text is in memory, and the state has the error.
void EditSession::write_side_file() {
  try {
    side_error_.clear();
    if (!is_saved()) {
      write_file(side_file(), fmt::format("{}{}\n{}", side_mark, base_hash_, text()));
      has_side_file_ = true;
    } else if (std::exchange(has_side_file_, false)) {
      std::filesystem::remove(side_file());
    }
  } catch (const std::system_error& error) {
    side_error_ = error.what();
  }
}

bool EditSession::set(std::int64_t revision, std::string text, std::string label) {
  if (revision != revision_) return false;
  if (text == versions_[now_].text) return true;
  push(std::move(text), std::move(label));
  changed();
  return true;
}

bool EditSession::undo() {
  if (now_ == 0) return false;
  --now_;
  changed();
  return true;
}

bool EditSession::redo() {
  if (now_ + 1 == versions_.size()) return false;
  ++now_;
  changed();
  return true;
}

bool EditSession::save() {
  poll();
  if (on_disk_ == OnDisk::changed) return false;
  write_file(path_, text());
  stamp_ = stamp_of(path_);
  set_base(text());
  on_disk_ = OnDisk::same;
  changed();
  return true;
}

void EditSession::use_file() {
  if (on_disk_ != OnDisk::changed) return;
  set_base(file_);
  on_disk_ = OnDisk::same;
  if (text() != file_) push(file_, "take the text of the file");
  changed();
}

void EditSession::use_mine() {
  if (on_disk_ != OnDisk::changed) return;
  set_base(file_);
  on_disk_ = OnDisk::same;
  changed();
}

bool EditSession::poll() {
  const std::string stamp = stamp_of(path_);
  if (stamp == stamp_) return false;
  const OnDisk before = on_disk_;
  if (stamp.empty()) {
    on_disk_ = OnDisk::missing;
  } else {
    std::string file;
    try {
      file = read_file(path_);
    } catch (const InputError&) {
      return false;  // it is being replaced: the next poll reads it
    }
    if (before == OnDisk::same && file == base_) {
      stamp_ = stamp;  // touched
      return false;
    }
    take(std::move(file));
  }
  stamp_ = stamp;
  changed();
  return true;
}

/// The text of the file on the disk has changed.
void EditSession::take(std::string file) {
  on_disk_ = OnDisk::same;
  if (file == base_) return;
  const bool unsaved = text() != base_ && text() != file;
  if (unsaved) {
    file_ = std::move(file);
    on_disk_ = OnDisk::changed;
    return;
  }
  if (text() != file) push(file, "change of the file by another program");
  set_base(std::move(file));
}

}  // namespace jounce
