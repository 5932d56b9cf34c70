// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// The fuzz targets. Each takes any bytes and returns: an InputError is an answer, everything else
/// (another exception, a broken promise, memory or arithmetic out of bounds) is a finding. Run by
/// libFuzzer where JOUNCE_FUZZ is on (scripts/fuzz), and in every test run over the kept files.
namespace jounce::fuzz {

using Input = std::span<const std::uint8_t>;

void wire(Input input);       ///< packets: decoded, encoded again
void session(Input input);    ///< a conversation with Receiver and Sender
void table(Input input);      ///< table files: CSV, JSON, other makers' formats
void spec(Input input);       ///< specs and drive files: TOML
void gcode(Input input);      ///< programs of DIN 66025
void recording(Input input);  ///< recordings and tick logs: CSV
void points(Input input);     ///< points beside a spec: CSV
void rows(Input input);       ///< a conversation with RowSender and Receiver; rows into FIFOs
void key(Input input);        ///< key files; packets where a key is set
void log(Input input);        ///< the record of a run: LCM logs, replayed
void text(Input input);       ///< any text, as a terminal and JSON may be given it
void page(Input input);       ///< orders to a live page, and packets that it shows
void executor(Input input);   ///< messages of an owner to an executor, and the motion of its axes

/// Ends the process with these words: a promise was broken.
[[noreturn]] void broken(const char* promise);
inline void require(bool kept, const char* promise) {
  if (!kept) broken(promise);
}

inline std::string text_of(Input input) {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// Bytes that are taken from the front of the input; zeros after its end.
class Source {
 public:
  explicit Source(Input input) : rest_(input) {}
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  std::size_t below(std::size_t n) { return byte() % n; }
  Input take(std::size_t n) {
    const Input first = rest_.first(n < rest_.size() ? n : rest_.size());
    rest_ = rest_.subspan(first.size());
    return first;
  }

 private:
  Input rest_;
};

}  // namespace jounce::fuzz
