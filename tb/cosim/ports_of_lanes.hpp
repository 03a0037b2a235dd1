// ports_of_lanes: packed words on a part of a Verilated port: the lanes of the engine share each port, lane 0 at bit 0.
//   put_bits(port, at, word, width)   width bits of word to bit `at` of an input
//   get_bits<N>(port, at, width)      width bits from bit `at` of an output as bits<N>
#pragma once
#include <cstdint>
#include <type_traits>

#include "hls/core/packed.hpp"

namespace relievo::tb {

namespace detail {
template <class Port>
std::uint64_t read_word(Port const& port, int word) {
  if constexpr (std::is_integral_v<Port>)
    return (static_cast<std::uint64_t>(port) >> (32 * word)) & 0xffffffffu;
  else
    return port[static_cast<std::size_t>(word)];
}
template <class Port>
void write_word(Port& port, int word, std::uint64_t mask, std::uint64_t value) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>((static_cast<std::uint64_t>(port) & ~(mask << (32 * word))) | (value << (32 * word)));
  } else {
    auto& w = port[static_cast<std::size_t>(word)];
    w = static_cast<std::uint32_t>((w & ~mask) | value);
  }
}
}  // namespace detail

template <class Port, int N>
void put_bits(Port& port, int at, hls::bits<N> const& word, int width) {
  // Word by word of the port: the bits of the source that fall into it.
  for (int w = at / 32; w * 32 < at + width; ++w) {
    const int low = w * 32 > at ? w * 32 : at;                             // first bit of the port written here
    const int high = w * 32 + 32 < at + width ? w * 32 + 32 : at + width;  // one past the last
    const int from = low - at;                                             // bit of the source
    std::uint64_t value = word.limb[from / 64] >> (from % 64);
    if (from % 64 + (high - low) > 64) value |= word.limb[from / 64 + 1] << (64 - from % 64);
    const std::uint64_t mask = high - low == 32 ? 0xffffffffu : (std::uint64_t(1) << (high - low)) - 1;
    detail::write_word(port, w, mask << (low % 32), (value & mask) << (low % 32));
  }
}

template <int N, class Port>
hls::bits<N> get_bits(Port const& port, int at, int width) {
  hls::bits<N> word{};
  for (int w = at / 32; w * 32 < at + width; ++w) {
    const int low = w * 32 > at ? w * 32 : at;
    const int high = w * 32 + 32 < at + width ? w * 32 + 32 : at + width;
    const int to = low - at;
    const std::uint64_t mask = high - low == 32 ? 0xffffffffu : (std::uint64_t(1) << (high - low)) - 1;
    const std::uint64_t value = (detail::read_word(port, w) >> (low % 32)) & mask;
    word.limb[to / 64] |= value << (to % 64);
    if (to % 64 + (high - low) > 64) word.limb[to / 64 + 1] |= value >> (64 - to % 64);
  }
  return word;
}

}  // namespace relievo::tb
