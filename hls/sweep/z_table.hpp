// z_table: builds the table that grid_transform interpolates: cells from w = 2^e to 2^e (1 + i/256). Rebuilt when the camera changes.
//   T[i] = kappa ln(1 + i/256), i = 0..256;  kappa = 1 / ln(1 + 2 g tan(alpha/2) / H)      Gumhold & Huettner 1999, equation (4)
//   in    kappa    kappa
//         i        0..256
//   out   z        depth_cells; T[256], the cells of an octave, is also grid_transform's register `octave`
//   registers: the logarithms (30 fractional bits, correctly rounded, constants), z: their exact product with kappa, rounded
//   |z - kappa ln(1 + i/256)| <= 1/2 LSB + kappa 2^-31
//   nothing saturates; initiation interval 1
#pragma once
#include "hls/sweep/world_data.hpp"

namespace relievo {
namespace hls {

namespace detail {

using logarithm_format = format<30, 0, false>;
struct logarithm_table {
  std::uint32_t word[z_table_words];
};

// ln(1 + i/256) = 2 artanh q, q = i / (512 + i) <= 1/3: q + q^3/3 + q^5/5 ..., each power from the last with 52 fractional bits. All that
// is cut off adds up to less than 2^-45, and no logarithm is nearer than 2^-38 to half an LSB (tests/sweep/z_table.cpp).
constexpr std::uint32_t logarithm_word(std::uint64_t i) {
  constexpr int places = 52;
  std::uint64_t power = (i << places) / (512 + i), sum = 0;
  for (std::uint64_t k = 1; k <= 33; k += 2) {
    sum += power / k;
    power = power * i / (512 + i) * i / (512 + i);
  }
  constexpr int cut = places - logarithm_format::fraction;
  return static_cast<std::uint32_t>((2 * sum + (std::uint64_t(1) << (cut - 1))) >> cut);
}
constexpr logarithm_table make_logarithm_table() {
  logarithm_table table{};
  for (int i = 0; i < z_table_words; ++i) table.word[i] = logarithm_word(static_cast<std::uint64_t>(i));
  return table;
}
static constexpr logarithm_table logarithms = make_logarithm_table();

}  // namespace detail

inline z_table_out z_table(z_table_in const& in) {
  const auto logarithm = from_raw<detail::logarithm_format>(detail::logarithms.word[raw(in.i)]);
  z_table_out out;
  out.z = round_to<formats::depth_cells>(in.kappa * logarithm);
  return out;
}

}  // namespace hls
}  // namespace relievo
