// vectors: what the benchmarks feed to a unit: a thousand records, drawn once, with the same seed on every machine.
#pragma once
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tb/model/words.hpp"

namespace relievo::bench {

constexpr std::size_t batch = 1024;

// Uniform words of every field, the lowest `calm` bits of range unused where a scene would not use them either.
template <class Record>
std::vector<Record> draw(int calm = 0) {
  std::mt19937_64 g(1);
  std::vector<Record> list(batch);
  for (Record& r : list)
    tb::detail::walk(r, [&](std::string const&, auto& x) {
      using F = typename tb::detail::leaf_format<std::remove_reference_t<decltype(x)>>::type;
      const int shift = 64 - F::width + (F::width > 8 ? calm : 0);
      const std::uint64_t bits = g();
      tb::detail::set_leaf(x, F::is_signed ? static_cast<std::int64_t>(bits) >> shift : static_cast<std::int64_t>(bits >> shift));
    });
  return list;
}

// Runs unit(record) over the batch, and counts records a second.
template <class Record, class Unit>
void run(benchmark::State& state, std::vector<Record> const& records, Unit unit) {
  for (auto _ : state)
    for (Record const& r : records) benchmark::DoNotOptimize(unit(r));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(records.size()));
}

}  // namespace relievo::bench
