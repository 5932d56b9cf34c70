// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jounce {

/// An edited file: all versions of its text, the file on the disk, and a *side file* with the
/// unsaved text.
///
///     EditSession session("cam.toml");
///     session.set(session.revision(), text, "move knot 2");  // false: not the present revision
///     session.undo();
///     session.save();                                        // false: the file has changed
///
/// **Nothing is lost.** Every version of the text stays until the session ends. While the text
/// differs from the file, the side file (FILE.autosave) contains the text; a later session
/// continues with it. If another program changes the file, poll() adds the new text of the file as
/// a version. If the session has unsaved changes, there is a *conflict* instead: neither text is
/// replaced until use_file() or use_mine() resolves the conflict. Files are written completely or
/// not at all.
///
/// Not synchronized: threads that share a session need a lock. Functions that write throw
/// std::system_error if the system reports an error.
class EditSession {
 public:
  /// Relation of the file on the disk to the text that was last read from it or saved.
  enum class OnDisk {
    same,     ///< unchanged
    changed,  ///< another program has changed it, and the text has unsaved changes: a conflict
    missing,  ///< it does not exist
  };

  /// Reads the file, and the side file of an earlier session if there is one. A file that does not
  /// exist has an empty text, and save() makes it. Throws InputError if the file cannot be read, or
  /// if a session did not write the file with the name of the side file.
  explicit EditSession(std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Number of the present state. Every change of the text or of the file on the disk increases it.
  [[nodiscard]] std::int64_t revision() const { return revision_; }
  [[nodiscard]] const std::string& text() const { return versions_[now_].text; }
  /// The text that was last read from the file, or saved.
  [[nodiscard]] const std::string& saved_text() const { return base_; }
  [[nodiscard]] bool is_saved() const { return text() == base_ && on_disk_ == OnDisk::same; }
  [[nodiscard]] OnDisk on_disk() const { return on_disk_; }
  /// In a conflict: the text of the file on the disk.
  [[nodiscard]] const std::string& file_text() const { return file_; }
  /// True if the text comes from the side file of an earlier session and has not been changed
  /// since.
  [[nodiscard]] bool is_recovered() const { return recovered_; }
  /// Name of the change that undo() reverses or redo() repeats; nullopt: there is none.
  [[nodiscard]] std::optional<std::string> undo_label() const;
  [[nodiscard]] std::optional<std::string> redo_label() const;
  /// Path of the side file.
  [[nodiscard]] std::string side_file() const { return path_ + ".autosave"; }
  /// Error of the last attempt to write the side file; "": none.
  [[nodiscard]] const std::string& side_error() const { return side_error_; }

  /// Makes `text` the newest version; `label` names the change. Drops the versions to which redo()
  /// would return. Returns false, without a change, if `revision` is not the present one.
  bool set(std::int64_t revision, std::string text, std::string label);
  /// Go to the previous or to the next version. Return false if there is no such version.
  bool undo();
  bool redo();
  /// Writes the file. Returns false, without a change, in a conflict.
  bool save();
  /// Resolve a conflict. use_file() makes the text of the file the newest version; undo() then
  /// returns to the text of the session. use_mine() keeps the text of the session; save() then
  /// replaces the file.
  void use_file();
  void use_mine();
  /// Reads the file if it has changed on the disk. Returns true if the state of the session has
  /// changed.
  bool poll();

 private:
  struct Version {
    std::string text;
    std::string label;  ///< the change that made this version
  };

  void recover();
  void set_base(std::string text);
  void take(std::string file);
  void push(std::string text, std::string label);
  void changed();
  void write_side_file();

  std::string path_;
  std::vector<Version> versions_;
  std::size_t now_ = 0;
  std::int64_t revision_ = 1;
  std::string base_;
  std::string base_hash_;  // hash of the file to which the text belongs
  std::string file_;
  OnDisk on_disk_ = OnDisk::same;
  bool recovered_ = false;
  bool has_side_file_ = false;
  std::string side_error_;
  std::string stamp_;  // stamp of the file when it was last read
};

}  // namespace jounce
