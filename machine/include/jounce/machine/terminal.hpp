// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <termios.h>

#include "jounce/machine/dashboard.hpp"

namespace jounce::dashboard {

/// True if there is a terminal to draw on and keys to read.
bool is_screen();

/// True if the locale draws more than ASCII.
bool is_utf8();

/// Rows as bytes for a terminal: from its upper left corner on, everything else cleared.
std::string drawn(const std::vector<Row>& rows);

/// The whole screen of standard output and the keys of standard input, during its lifetime:
///
///     Terminal terminal;
///     terminal.measure(view);
///     terminal.show(rows_of(watch.axes(), view));
///     while (const auto key = terminal.key()) press(view, watch.axes(), *key);
///
/// Signals that would end the program end the reading instead.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Columns and rows into the view.
  void measure(View& view) const;
  void show(const std::vector<Row>& rows);
  /// The next key that was pressed, at once; 'q' for Ctrl-C, a signal, or a terminal that is gone.
  std::optional<Key> key();

 private:
  termios before_{};
  std::string typed_;
  std::string shown_;
};

}  // namespace jounce::dashboard
