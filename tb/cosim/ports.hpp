// ports: records on the ports of a Verilated model, the one place that knows how Verilator lays them out.
//   put(port, record)        the record's packed bits onto an input
//   get<Record>(port)        an output as a record, signs extended
//   A port of up to 64 bits is an unsigned integer, a wider one an array of 32-bit words; bit 0 is the first field's in both.
#pragma once
#include <verilated.h>

#include <cstdint>
#include <type_traits>

#include "hls/core/packed.hpp"

namespace relievo::tb {

namespace detail {
template <class Port>
constexpr int port_bits() {
  return 8 * static_cast<int>(sizeof(Port));
}
}  // namespace detail

template <class Port, class Record>
void put(Port& port, Record const& record) {
  constexpr int width = hls::field_width<Record>::value;
  static_assert(width <= detail::port_bits<Port>(), "the record is wider than the port");
  const auto word = hls::pack(record);
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(word.limb[0]);
  } else {
    for (int i = 0; i < (width + 31) / 32; ++i)
      port[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(word.limb[i / 2] >> (32 * (i % 2)));
  }
}

template <class Record, class Port>
Record get(Port const& port) {
  constexpr int width = hls::field_width<Record>::value;
  static_assert(width <= detail::port_bits<Port>(), "the record is wider than the port");
  hls::port_word<Record> word{};
  if constexpr (std::is_integral_v<Port>) {
    word.limb[0] = port;
  } else {
    for (int i = 0; i < (width + 31) / 32; ++i)
      word.limb[i / 2] |= static_cast<std::uint64_t>(port[static_cast<std::size_t>(i)]) << (32 * (i % 2));
  }
  return hls::unpack<Record>(word);
}

}  // namespace relievo::tb
