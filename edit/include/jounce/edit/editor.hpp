// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/web/server.hpp"

namespace jounce {

/// The editor of a file in a browser: `jounce edit`.
///
///     const Editor editor("cam.toml", web::Listening(0));
///     print(editor.address());   // "http://127.0.0.1:40131/#3f0c...": permits reading and changes
///
/// The text of the file is the only state (session.hpp). The page shows its curves and findings, and
/// changes the text. docs/reference/http.md describes the interface between page and server, which
/// other programs can use. Every request needs the token of the address; the guards of web::Server
/// apply. The file is written only by a request to save it.
class Editor {
 public:
  /// Opens the file, and serves its page until the object is destroyed. Throws InputError for a
  /// file that cannot be read, and for one that another editor has open.
  Editor(const std::string& file, web::Listening listening);
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  /// Address of the page, including the token.
  [[nodiscard]] std::string address() const;
  /// True if the text has no unsaved changes.
  [[nodiscard]] bool is_saved() const;
  /// The file with the unsaved text.
  [[nodiscard]] std::string side_file() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
