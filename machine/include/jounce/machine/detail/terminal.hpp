// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <termios.h>

#include "jounce/machine/detail/dashboard.hpp"

namespace jounce::dashboard {

/// True if standard output is a terminal and standard input can read keys.
bool is_screen();

/// True if the locale can show characters beyond ASCII.
bool is_utf8();

/// Returns the bytes that draw these rows from the upper left corner of a terminal, and clear the
/// rest of the screen.
std::string drawn(const std::vector<Row>& rows);

/// Uses the screen of standard output and the keys of standard input while the object exists:
///
///     Terminal terminal;
///     terminal.measure(view);
///     terminal.show(rows_of(watch.axes(), view));
///     while (const auto key = terminal.key()) press(view, watch.axes(), *key);
///
/// Signals that would end the program make key() return 'q' instead.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Sets width and height of the view to the size of the terminal.
  void measure(View& view) const;
  /// Draws the rows, if they have changed.
  void show(const std::vector<Row>& rows);
  /// Returns the next key without waiting; nullopt if no key was pressed. Returns 'q' for Ctrl-C,
  /// for a signal, and if the terminal is closed.
  std::optional<Key> key();

 private:
  termios before_{};
  std::string typed_;
  std::string shown_;
};

/// Shows the axes of `watch` on the terminal and executes the keys, until the key q is pressed or
/// `goes_on` returns false. Returns false if no axis sends a message within view.silence from the
/// start. Of `view`, only `ascii` and `silence` are read. Throws TransportError.
bool show_axes(Watch& watch, Transport& link, View view, const std::optional<wire::Key>& key,
               const std::function<bool()>& goes_on);

}  // namespace jounce::dashboard
