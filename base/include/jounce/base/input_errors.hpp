// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// All errors of one document. For callers that report only one error, the object is also an
/// InputError: the first error in the order of reading.
class InputErrors : public InputError {
 public:
  /// `all`: at least one error, in the order of reading.
  explicit InputErrors(std::vector<InputError> all);

  /// All errors, in the order of reading.
  [[nodiscard]] const std::vector<InputError>& all() const { return all_; }

 private:
  std::vector<InputError> all_;
};

/// Returns all errors of an InputErrors; for any other InputError, returns that error alone.
std::vector<InputError> all_errors(const InputError& error);

/// Returns the sentences of all errors, one a line; each line after the first begins with `prefix`.
std::string all_sentences(const InputError& error, const std::string& prefix);

/// Throws the error with other keys; errors in a document keep theirs.
[[noreturn]] void throw_renamed(const InputError& error,
                                const std::function<std::string(const std::string& key)>& renamed);

}  // namespace jounce
