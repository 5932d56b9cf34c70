// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>

#include "jounce/web/server.hpp"

namespace jounce {

/// Serves a page in which a browser edits a spec: `jounce edit`.
///
///     const Editor editor("cam.toml", web::Listening(0));   // port 0: any free port
///     print(editor.address());   // "http://127.0.0.1:40131/#3f0c...", with the token
///
/// The text of the file is the only state (session.hpp). The page shows the curves and findings of
/// the text, and changes the text. Other programs can use the interface between page and server,
/// too: docs/reference/http.md describes it. Every request except those for the files of the page
/// needs the token in the address. The guards of web::Server apply. Only a request to save writes
/// the file.
class Editor {
 public:
  /// Opens the file, and serves the page until the object is destroyed. If the file does not exist
  /// or is empty, the page offers the `templates`: the text of an example spec by its kind. Throws
  /// InputError for a file that cannot be read or is not a spec, and for a file that another editor
  /// has open. A spec with errors is accepted.
  Editor(const std::string& file, web::Listening listening,
         std::map<std::string, std::string> templates = {});
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  /// Address of the page, including the token.
  [[nodiscard]] std::string address() const;
  /// True if the text has no unsaved changes.
  [[nodiscard]] bool is_saved() const;
  /// Path of the file that contains the unsaved text.
  [[nodiscard]] std::string side_file() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
