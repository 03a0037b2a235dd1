// z_table: the table of the logarithmic z grid over one octave of w, rebuilt when the camera changes.
//   T[i] = kappa ln(1 + i/256), i = 0..256                                         Gumhold & Huettner 1999, section 3.1.1, Figure 8, (4)
//
//   in   kappa   kappa          1 / ln(1 + 2 g tan(alpha/2) / H)
//        i       0..256
//   out  z       depth_cells    z_table_of(kappa): all of them; the last is the octave, kappa ln 2
//   registers: ln(1 + i/256) with 30 fractional bits, depth_cells
//
// The product has 62 bits, so golden multiplies words in int64. Nothing saturates: kappa ln 2 is below 2^18.
// Error of a word: half an LSB and kappa 2^-31 cells.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "golden/core/rounding.hpp"
#include "golden/sweep/world_data.hpp"

namespace relievo {
namespace golden {

using logarithm = format<30, 0, false>;

template <class Rounding = rounded>
z_table_out z_table(z_table_in const& in) {
  const double l = Rounding::template at<logarithm>(std::log1p(in.i / 256.0));
  if constexpr (Rounding::is_exact) {
    return {in.kappa * l};
  } else {
    static_assert(logarithm::width + formats::kappa::width <= 62, "the product and half an LSB fit int64");
    constexpr int cut = logarithm::fraction + formats::kappa::fraction - formats::depth_cells::fraction;
    const auto product = static_cast<std::int64_t>(l * power_of_two(logarithm::fraction)) *
                         static_cast<std::int64_t>(in.kappa * power_of_two(formats::kappa::fraction));
    // Words of both are at least 0.
    const std::int64_t word = (product + (std::int64_t{1} << (cut - 1))) >> cut;
    return {static_cast<double>(word) * range_of<formats::depth_cells>::lsb};
  }
}

template <class Rounding = rounded>
std::vector<double> z_table_of(double kappa) {
  std::vector<double> words;
  words.reserve(z_table_words);
  for (int i = 0; i < z_table_words; ++i) words.push_back(z_table<Rounding>({kappa, i}).z);
  return words;
}

}  // namespace golden
}  // namespace relievo
