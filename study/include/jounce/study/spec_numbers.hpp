// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// A spec whose numbers can be changed in its text, by key. Comments, order and layout stay, so the
/// difference from the given text is small.
///
///     const SpecNumbers cam(read_spec("cam.toml").document);
///     cam.value("segment[2].end.master");                                  // 120
///     const std::vector<SpecNumbers::Change> later{{"segment[2].end.master", 125}};
///     const Spec other = cam.spec(later);
///
/// Keys are written as in the file and in error messages, with entries of arrays counted from 1:
/// "move.velocity", "segment[3].end.slave", "drive.mass[1].inertia", "shares[2]". For a number that
/// the file omits, and for a value that is not a number, functions throw InputError with key and
/// rule. The object does not change after its construction, so several threads may use it at the
/// same time.
class SpecNumbers {
 public:
  /// Uses only the name and the text of the document. Throws InputError if the text is not TOML.
  /// Only spec() checks that the text is a spec.
  explicit SpecNumbers(Document document);

  /// A new value for a number.
  struct Change {
    std::string key = {};  ///< key of the number
    double value = 0;  ///< finite, in the unit that the number has in the file ("12.5 mm/s": mm/s)
  };

  /// Returns the number at this key, in the unit that it has in the file.
  [[nodiscard]] double value(const std::string& key) const;
  /// Returns the unit that follows the number in the file; "" if the file gives no unit, so that
  /// the unit of the spec applies.
  [[nodiscard]] std::string unit(const std::string& key) const;
  /// True if the number is written as a whole number: 12, but not 12.0 or "12 mm".
  [[nodiscard]] bool is_whole(const std::string& key) const;
  /// Returns the text with other numbers. Throws InputError for a key that is given twice, and for
  /// a value that is not finite.
  [[nodiscard]] std::string text(std::span<const Change> changes) const;
  [[nodiscard]] Spec spec(std::span<const Change> changes) const;  ///< reads the spec from text()

  /// The given document.
  [[nodiscard]] const Document& document() const { return document_; }

 private:
  struct Place {
    std::size_t begin = 0;  ///< first byte of the number in the text
    std::size_t end = 0;
    double value = 0;
    std::string unit = {};
    bool quoted = false;
    bool whole = false;
  };
  struct Reader;

  [[nodiscard]] const Place& place(const std::string& key) const;

  Document document_;
  std::map<std::string, Place> numbers_;
  std::map<std::string, int> others_;  ///< other keys, and their lines
};

}  // namespace jounce
