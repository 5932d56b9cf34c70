// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// A spec whose numbers can be changed by key, in its text: comments, order and layout stay, so the
/// chosen numbers can be written back and give a small diff.
///
///     const SpecNumbers cam(read_spec("cam.toml").document);
///     cam.value("segment[2].end.master");                                  // 120
///     const std::vector<SpecNumbers::Change> later{{"segment[2].end.master", 125}};
///     const Spec other = cam.spec(later);
///
/// Keys are those of the file, entries of arrays counted from 1, as in error messages:
/// "move.velocity", "segment[3].end.slave", "drive.mass[1].inertia", "shares[2]". A number that the
/// file omits, and a value that is not a number, cannot be changed: InputError with key and rule.
/// The object does not change after construction: any number of threads may use it at once.
class SpecNumbers {
 public:
  /// Uses only the name and the text of the document. Throws InputError if that is not TOML; spec()
  /// checks that it is a spec.
  explicit SpecNumbers(Document document);

  struct Change {
    std::string key;
    double value = 0;  ///< finite, in the unit of the file at that place ("12.5 mm/s": mm/s)
  };

  [[nodiscard]] double value(const std::string& key) const;
  /// Unit as written after the number; "" if the file has none (the unit of the spec).
  [[nodiscard]] std::string unit(const std::string& key) const;
  [[nodiscard]] bool is_whole(
      const std::string& key) const;  ///< text as written: 12, not 12.0 or "12 mm"
  /// The text with other numbers. Throws InputError for a key that is given twice.
  [[nodiscard]] std::string text(std::span<const Change> changes) const;
  [[nodiscard]] Spec spec(std::span<const Change> changes) const;  ///< parsed from text()

  [[nodiscard]] const Document& document() const { return document_; }

 private:
  struct Place {
    std::size_t begin = 0;  ///< bytes of the text
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
