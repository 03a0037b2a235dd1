// Numbers: a multiply-accumulate with rounding and saturation in fixed, in int64_t written by hand and in SystemC; divide and normalize;
// and one whole unit, displace, as it is and written with sc_fixed_fast. That unit lives here alone, to be measured against.
#include "hls/core/divide.hpp"
#include "hls/core/normalize.hpp"
#include "hls/surface/displace.hpp"
#include "tests/bench/vectors.hpp"

#define SC_INCLUDE_FX
#include <systemc>

namespace relievo::bench {
namespace {

using formats::direction;
using formats::unit;

struct factors {
  hls::fixed<unit> a, b;
  RELIEVO_FIELDS(a, b)
};

void multiply_accumulate_fixed(benchmark::State& state) {
  const auto list = draw<factors>();
  for (auto _ : state) {
    hls::fixed<direction> sum;
    for (factors const& f : list) sum = hls::round_to<direction>(sum + f.a * f.b);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}
BENCHMARK(multiply_accumulate_fixed);

void multiply_accumulate_int64(benchmark::State& state) {
  std::vector<std::pair<std::int64_t, std::int64_t>> list;
  for (factors const& f : draw<factors>()) list.push_back({raw(f.a), raw(f.b)});
  for (auto _ : state) {
    std::int64_t sum = 0;
    for (auto const& [a, b] : list) {
      sum = (sum * (1 << 14) + a * b + (1 << 13)) >> 14;
      sum = sum > 131071 ? 131071 : sum < -131072 ? -131072 : sum;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}
BENCHMARK(multiply_accumulate_int64);

void multiply_accumulate_sc_fixed_fast(benchmark::State& state) {
  using factor = sc_dt::sc_fixed_fast<16, 2>;
  std::vector<std::pair<factor, factor>> list;
  for (factors const& f : draw<factors>())
    list.push_back({factor(static_cast<double>(raw(f.a)) / 16384), factor(static_cast<double>(raw(f.b)) / 16384)});
  for (auto _ : state) {
    sc_dt::sc_fixed_fast<18, 4, sc_dt::SC_RND, sc_dt::SC_SAT> sum = 0;
    for (auto const& [a, b] : list) sum = sum + a * b;
    benchmark::DoNotOptimize(sum.to_double());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(list.size()));
}
BENCHMARK(multiply_accumulate_sc_fixed_fast);

struct quotient_in {
  hls::fixed<formats::clip> n;
  hls::fixed<formats::depth> d;
  RELIEVO_FIELDS(n, d)
};
void divide(benchmark::State& state) {
  run(state, draw<quotient_in>(), [](quotient_in const& in) {
    bool clipped = false;
    return hls::divide<formats::screen>(in.n, in.d, clipped);
  });
}
BENCHMARK(divide);

void normalize(benchmark::State& state) {
  run(state, draw<hls::normalize_in>(), [](hls::normalize_in const& in) { return hls::normalize(in); });
}
BENCHMARK(normalize);

// ---- displace, twice ----------------------------------------------------------------------------------------------------------------

using sc_position = sc_dt::sc_fixed_fast<24, 4, sc_dt::SC_RND, sc_dt::SC_SAT>;
using sc_height = sc_dt::sc_fixed_fast<24, 4, sc_dt::SC_RND, sc_dt::SC_SAT>;
using sc_unit = sc_dt::sc_fixed_fast<16, 2>;
using sc_sample = sc_dt::sc_ufixed_fast<20, 16>;
using sc_scale = sc_dt::sc_fixed_fast<24, -12>;

struct sc_displace_in {
  sc_position p[3];
  sc_unit n[3];
  sc_sample d;
};
struct sc_displace_regs {
  sc_scale scale;
  sc_height bias;
};
struct sc_displace_out {
  sc_position p[3];
  bool saturated;
};

// The flag: a register that rounds to something else than one a bit wider would.
sc_displace_out displace(sc_displace_in const& in, sc_displace_regs const& regs) {
  using wider = sc_dt::sc_fixed_fast<40, 20, sc_dt::SC_RND, sc_dt::SC_SAT>;
  sc_displace_out out;
  const wider exact_height = regs.scale * in.d + regs.bias;
  const sc_height height = exact_height;
  out.saturated = height != exact_height;
  for (int i = 0; i < 3; ++i) {
    const wider exact = in.p[i] + height * in.n[i];
    out.p[i] = exact;
    out.saturated = out.saturated || out.p[i] != exact;
  }
  return out;
}

const hls::displace_regs regs = {hls::from_raw<formats::scale>(1 << 18), hls::from_raw<formats::height>(-12345)};

template <class F>
double value(hls::fixed<F> x) {
  return std::ldexp(static_cast<double>(raw(x)), -F::fraction);
}
sc_displace_in in_systemc(hls::displace_in const& from) {
  sc_displace_in in;
  for (int i = 0; i < 3; ++i) {
    in.p[i] = value(from.p[i]);
    in.n[i] = value(from.n[i]);
  }
  in.d = value(from.d);
  return in;
}

void displace_fixed(benchmark::State& state) {
  run(state, draw<hls::displace_in>(), [](hls::displace_in const& in) { return hls::displace(in, regs); });
}
BENCHMARK(displace_fixed);

void displace_sc_fixed_fast(benchmark::State& state) {
  const sc_displace_regs sc_regs = {value(regs.scale), value(regs.bias)};
  const auto list = draw<hls::displace_in>();
  std::vector<sc_displace_in> sc_list;
  for (hls::displace_in const& in : list) {
    sc_list.push_back(in_systemc(in));
    const auto a = hls::displace(in, regs);
    const auto b = displace(sc_list.back(), sc_regs);
    for (int i = 0; i < 3; ++i)
      if (value(a.p[i]) != b.p[i].to_double() || a.saturated != b.saturated) return state.SkipWithError("the two are not the same unit");
  }
  run(state, sc_list, [&](sc_displace_in const& in) { return displace(in, sc_regs); });
}
BENCHMARK(displace_sc_fixed_fast);

}  // namespace
}  // namespace relievo::bench
