// summed_area_lookup: the sum of the map over a rectangle.
//   S(Z) = SAT(tr) - SAT(tl) - SAT(br) + SAT(bl)              Doggett & Hirche 2000, eq. 2
//   in    x0, y0, x1, y1   bounds, the rectangle is [x0, x1) x [y0, y1); it may stick out of the map
//   regs  map; memory table words
//   out   s                rectangle_sum
//   wrapped axis: SAT(x + W, y) = SAT(x, y) + SAT(W, y), as many turns as it takes (at most max_turns: rectangles of the summed
//     height test reach 2 texels or half a map beyond the border)
//   clamped axis: the rectangle is clipped to the map, and its sum replaced by round(S/A), a sample, times the full area
//   four reads, up to four times as many where corners lie beyond wrapped borders; initiation interval reads / reads per clock;
//   modulo 2^40 until the difference is taken
#pragma once
#include "hls/core/divide.hpp"
#include "hls/surface/map_regs.hpp"

namespace relievo {
namespace hls {

struct summed_area_lookup_in {
  fixed<formats::bound> x0, y0, x1, y1;
  RELIEVO_FIELDS(x0, y0, x1, y1)
};
struct summed_area_lookup_out {
  fixed<formats::rectangle_sum> s;
  RELIEVO_FIELDS(s)
};

namespace detail {

constexpr int max_turns = 6;

// SAT(x, y) for 0 <= x <= W, 0 <= y <= H.
inline std::uint64_t table_word(std::int64_t x, std::int64_t y, map_regs const& map, table_memory const& memory) {
  return x == 0 || y == 0 ? 0 : memory.words[static_cast<std::uint32_t>((y - 1) * raw(map.width) + x - 1)];
}

// Brings a bound on a wrapped axis into [0, size]; returns the number of turns taken out.
inline std::int64_t unwind(std::int64_t& bound, std::int64_t size) {
  std::int64_t turns = 0;
  for (int i = 0; i < max_turns; ++i) {
    if (bound < 0) {
      bound += size;
      --turns;
    } else if (bound > size) {
      bound -= size;
      ++turns;
    }
  }
  return turns;
}

// SAT(x, y) with whole turns added back, modulo 2^64 (and so modulo 2^40).
inline std::uint64_t table_value(std::int64_t x, std::int64_t y, std::int64_t turns_x, std::int64_t turns_y, map_regs const& map,
                                 table_memory const& memory) {
  std::uint64_t value = table_word(x, y, map, memory);
  const std::int64_t width = raw(map.width), height = raw(map.height);
  if (turns_x != 0) value += static_cast<std::uint64_t>(turns_x) * table_word(width, y, map, memory);
  if (turns_y != 0) value += static_cast<std::uint64_t>(turns_y) * table_word(x, height, map, memory);
  if (turns_x != 0 && turns_y != 0) value += static_cast<std::uint64_t>(turns_x * turns_y) * table_word(width, height, map, memory);
  return value;
}

}  // namespace detail

inline summed_area_lookup_out summed_area_lookup(summed_area_lookup_in const& in, map_regs const& map, table_memory const& memory) {
  std::int64_t low[2] = {raw(in.x0), raw(in.y0)};
  std::int64_t high[2] = {raw(in.x1), raw(in.y1)};
  const std::int64_t full_area = (high[0] - low[0]) * (high[1] - low[1]);
  std::int64_t turns_low[2] = {0, 0};
  std::int64_t turns_high[2] = {0, 0};
  std::int64_t inside[2] = {0, 0};  // extent of what lies on the map; taking out turns does not change it
  bool clipped = false;
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t size = raw(axis == 0 ? map.width : map.height);
    if (axis == 0 ? map.wrap_u : map.wrap_v) {
      inside[axis] = high[axis] - low[axis];
      turns_low[axis] = detail::unwind(low[axis], size);
      turns_high[axis] = detail::unwind(high[axis], size);
    } else {
      clipped |= low[axis] < 0 || high[axis] > size;
      if (low[axis] < 0) low[axis] = 0;
      if (high[axis] > size) high[axis] = size;
      inside[axis] = high[axis] - low[axis];
    }
  }
  const std::uint64_t s0_sum = detail::table_value(high[0], high[1], turns_high[0], turns_high[1], map, memory) -
                               detail::table_value(low[0], high[1], turns_low[0], turns_high[1], map, memory) -
                               detail::table_value(high[0], low[1], turns_high[0], turns_low[1], map, memory) +
                               detail::table_value(low[0], low[1], turns_low[0], turns_low[1], map, memory);
  const auto s1_sum = from_raw<formats::table_sum>(static_cast<std::int64_t>(s0_sum & ((std::uint64_t(1) << 40) - 1)));
  summed_area_lookup_out out;
  out.s = exact_to<formats::rectangle_sum>(s1_sum);
  if (clipped) {
    const auto area = from_raw<formats::area>(inside[0] * inside[1]);
    bool overflow = false;
    const auto s2_mean = divide<formats::sample>(s1_sum, area, overflow);
    out.s = exact_to<formats::rectangle_sum>(s2_mean * from_raw<formats::area>(full_area));
  }
  return out;
}

}  // namespace hls
}  // namespace relievo
