// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jounce {

/// The text of a file while it is edited: its versions, the file on the disk, and a side file with
/// the unsaved text.
///
///     EditSession session("cam.toml");
///     session.set(session.revision(), text, "move knot 2");  // false: another revision
///     session.undo();
///     session.save();                                        // false: the file has changed
///
/// **Nothing is lost.** Every version of the text stays until the program ends. While the text
/// differs from the file, the side file (FILE.autosave) has the text; a session that begins later
/// finds it there. If another program changes the file, poll() takes the new text as a version; if
/// the text has unsaved changes, the session is in conflict, and neither text is replaced until
/// use_file() or use_mine() resolves it. Files are written completely or not at all.
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

  /// Reads the file, and the side file of an earlier session if there is one. Throws InputError for
  /// a file that cannot be read, and for a side file that no session has written.
  explicit EditSession(std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Number of the present state; every change increases it.
  [[nodiscard]] std::int64_t revision() const { return revision_; }
  [[nodiscard]] const std::string& text() const { return versions_[now_].text; }
  /// The text that was last read from the file, or saved.
  [[nodiscard]] const std::string& saved_text() const { return base_; }
  [[nodiscard]] bool is_saved() const { return text() == base_ && on_disk_ == OnDisk::same; }
  [[nodiscard]] OnDisk on_disk() const { return on_disk_; }
  /// In a conflict: the text of the file.
  [[nodiscard]] const std::string& file_text() const { return file_; }
  /// True until the first change, if the text comes from the side file of an earlier session.
  [[nodiscard]] bool is_recovered() const { return recovered_; }
  /// Name of the change that undo() or redo() concerns; nullopt: there is none.
  [[nodiscard]] std::optional<std::string> undo_label() const;
  [[nodiscard]] std::optional<std::string> redo_label() const;
  /// Path of the side file.
  [[nodiscard]] std::string side_file() const { return path_ + ".autosave"; }
  /// Error of the last attempt to write the side file; "": none.
  [[nodiscard]] const std::string& side_error() const { return side_error_; }

  /// Makes `text` the newest version; `label` names the change. Later versions, which undo() has
  /// left, are dropped. Returns false, without a change, if `revision` is not the present one.
  bool set(std::int64_t revision, std::string text, std::string label);
  /// Return false if there is no such version.
  bool undo();
  bool redo();
  /// Writes the file. Returns false, without a change, in a conflict.
  bool save();
  /// Resolve a conflict. use_file() makes the text of the file the newest version; undo() returns to
  /// the own text. use_mine() keeps the own text; save() then replaces the file.
  void use_file();
  void use_mine();
  /// Looks at the file on the disk. Returns true if the state has changed.
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
