// normal_map: builds the map of normals from a stream of texels, one texel a clock, for one scale of the displacement.
//   n = normalize(-dD/du s, -dD/dv s, 1)                      Doggett & Hirche 2000, 2.1 and 5.1 (rebuilt for each s)
//   in    texels row by row from v = 0, x fastest; then flush_rows() * width steps without one
//   regs  gradient_u = s/(2 du), gradient_v = s/(2 dv), both times 2^-normal_shift; normal_shift e keeps steep maps in range
//   out   x, y       address of the texel: when v wraps, rows 0 and H-1 need each other and come last (H-1, then 0)
//         n          unit[3]
//         saturated  a slope beyond the direction format;  zero  never (the third component is not 0)
//   Central differences, indices modulo W or H on a wrapped axis; at a clamped border one-sided, twice the difference; a clamped
//   axis of one texel has slope 0.
//   registers: s1_direction (direction), n (unit)
//   state two lines and two that keep rows 0 and 1 for a wrapped v, each read and written at most once a clock, and a window of
//   three texels with the ends of each row; initiation interval 1
#pragma once
#include "hls/core/normalize.hpp"
#include "hls/surface/map_regs.hpp"

namespace relievo {
namespace hls {

struct normal_map_regs {
  fixed<formats::gradient> gradient_u;
  fixed<formats::gradient> gradient_v;
  fixed<formats::shift> normal_shift;
  RELIEVO_FIELDS(gradient_u, gradient_v, normal_shift)
};
struct normal_map_out {
  fixed<formats::map_size> x, y;
  fixed<formats::unit> n[3];
  bool saturated;
  bool zero;
  RELIEVO_FIELDS(x, y, n, saturated, zero)
};

template <int MaxWidth = 8192>
class normal_map {
 public:
  // Rows that come out after the last texel went in.
  static int flush_rows(map_regs const& map) { return map.wrap_v && raw(map.height) > 1 ? 2 : 1; }

  // One clock. Returns whether out is valid. While the map is read, texel is the next one; afterwards it is ignored.
  bool step(fixed<formats::texel> texel, map_regs const& map, normal_map_regs const& regs, normal_map_out& out) {
    const std::int32_t width = static_cast<std::int32_t>(raw(map.width)), height = static_cast<std::int32_t>(raw(map.height));
    const std::int32_t next = x_ < width - 1 ? x_ + 1 : x_;
    const bool reading = y_ < height;
    const bool row_zero = y_ > height;  // row 0 of a wrapped axis, after the last row
    // Row y-1 lies complete in the newer line; the older holds row y-2 from here on and row y up to here.
    const bool even_is_older = (y_ & 1) == 0;
    const texel_type from_even = even_[even_is_older ? x_ : next];
    const texel_type from_odd = odd_[even_is_older ? next : x_];
    const texel_type below = even_is_older ? from_even : from_odd;
    const texel_type from_zero = zero_[row_zero ? next : x_];
    const texel_type from_one = one_[x_];

    // The window: the row that comes out is row 0 at the very end, the newer line else.
    row_ends const& ends = row_zero ? zero_ends_ : newer_ends_;
    if (x_ == 0) {
      here_ = ends.first;
      west_ = map.wrap_u ? ends.last : ends.first;
    }
    const texel_type ahead = row_zero ? from_zero : even_is_older ? from_odd : from_even;
    const texel_type east = x_ < width - 1 ? ahead : map.wrap_u ? ends.first : here_;

    bool valid = true;
    if (reading) {
      valid = y_ >= 1 && !(map.wrap_v && y_ == 1);
      if (valid) out = texel_normal(east, below, texel, y_ == 1, false, y_ - 1, map, regs);
      keep(texel, even_is_older, width);
    } else if (row_zero) {
      out = texel_normal(east, below, from_one, false, false, 0, map, regs);
    } else {
      // The last row: beyond it lies nothing, or row 0.
      out = texel_normal(east, below, from_zero, false, !map.wrap_v, height - 1, map, regs);
    }
    west_ = here_;
    here_ = east;
    advance(width, height, map);
    return valid;
  }

 private:
  using texel_type = fixed<formats::texel>;
  using delta_type = format<18, 18, true>;

  // What a difference of neighbours counts: twice at a clamped border, where it is one-sided.
  static fixed<delta_type> delta(texel_type ahead, texel_type behind, bool one_sided) {
    const auto d = ahead - behind;
    return one_sided ? exact_to<delta_type>(times_two_to<1>(d)) : exact_to<delta_type>(d);
  }

  normal_map_out texel_normal(texel_type east, texel_type below, texel_type above, bool first, bool last, std::int32_t y,
                              map_regs const& map, normal_map_regs const& regs) const {
    const texel_type here = here_;
    const bool border = !map.wrap_u && (x_ == 0 || x_ == raw(map.width) - 1);
    const bool single = raw(map.height) == 1;
    const texel_type south = first || single ? here : below;
    const texel_type north = last || single ? here : above;
    const auto s0_delta_u = delta(east, west_, border);
    const auto s0_delta_v = delta(north, south, first || last);

    normal_map_out out;
    out.x = from_raw<formats::map_size>(x_);
    out.y = from_raw<formats::map_size>(y);
    out.saturated = false;
    normalize_in s1_direction;
    s1_direction.tangent = false;
    s1_direction.v[0] = round_to<formats::direction>(-(regs.gradient_u * s0_delta_u), out.saturated);
    s1_direction.v[1] = round_to<formats::direction>(-(regs.gradient_v * s0_delta_v), out.saturated);
    // 2^-normal_shift, rounded like every register.
    s1_direction.v[2] =
        from_raw<formats::direction>((((std::int64_t(2) << formats::direction::fraction) >> raw(regs.normal_shift)) + 1) >> 1);
    const normalize_out s2_unit = normalize(s1_direction);
    for (int i = 0; i < 3; ++i) out.n[i] = s2_unit.n[i];
    out.zero = s2_unit.zero;
    return out;
  }

  // Stores a texel of the map, and the ends of its row.
  void keep(texel_type texel, bool even_is_older, std::int32_t width) {
    if (even_is_older)
      even_[x_] = texel;
    else
      odd_[x_] = texel;
    if (y_ == 0) zero_[x_] = texel;
    if (y_ == 1) one_[x_] = texel;
    if (x_ == 0) reading_ends_.first = texel;
    if (x_ == width - 1) {
      reading_ends_.last = texel;
      newer_ends_ = reading_ends_;
      if (y_ == 0) zero_ends_ = reading_ends_;
    }
  }

  void advance(std::int32_t width, std::int32_t height, map_regs const& map) {
    ++x_;
    if (x_ == width) {
      x_ = 0;
      ++y_;
      if (y_ == height + flush_rows(map)) y_ = 0;
    }
  }

  struct row_ends {
    texel_type first, last;
  };

  // Four memories, each read and written at most once a clock.
  texel_type even_[MaxWidth], odd_[MaxWidth];
  texel_type zero_[MaxWidth], one_[MaxWidth];
  row_ends reading_ends_, newer_ends_, zero_ends_;
  texel_type west_, here_;
  std::int32_t x_ = 0;
  std::int32_t y_ = 0;
};

}  // namespace hls
}  // namespace relievo
