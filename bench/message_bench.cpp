// SPDX-License-Identifier: Apache-2.0
// What a message of the stream costs: encoding and decoding a full chunk, with and without a key, and
// its two checks alone.
#include <numeric>
#include <optional>

#include <benchmark/benchmark.h>

#include "jounce/stream/message/wire.hpp"

namespace {

using namespace jounce;

wire::Message full_chunk() {
  std::vector<double> values(4096);
  std::iota(values.begin(), values.end(), 0.5);
  return {"feeder", 1, wire::Chunk{0, 0, 0, 1024, 4, std::move(values)}, 1};
}

std::optional<wire::Key> key_of(const benchmark::State& state) {
  if (state.range(0) == 0) return std::nullopt;
  return wire::Key{1, 2, 3};
}

void count(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
  state.SetLabel(state.range(0) == 0 ? "no key" : "key");
}

void Encode(benchmark::State& state) {
  const wire::Message message = full_chunk();
  const auto key = key_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(wire::encode(message, key));
  count(state, wire::encode(message).size());
}
BENCHMARK(Encode)->Arg(0)->Arg(1);

void Decode(benchmark::State& state) {
  const auto key = key_of(state);
  const wire::Bytes bytes = wire::encode(full_chunk(), key);
  for (auto _ : state) benchmark::DoNotOptimize(wire::decode(bytes, key));
  count(state, bytes.size());
}
BENCHMARK(Decode)->Arg(0)->Arg(1);

/// The cost of one forged message of a flood to the executor.
void Refuse(benchmark::State& state) {
  const auto key = key_of(state);
  const wire::Bytes bytes = wire::encode(full_chunk(), wire::Key{9});
  for (auto _ : state) benchmark::DoNotOptimize(wire::decode(bytes, key));
  count(state, bytes.size());
}
BENCHMARK(Refuse)->Arg(0)->Arg(1);

}  // namespace
