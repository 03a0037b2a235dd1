// near_clip: a base triangle cut by the near and far plane and by the guard band, before anything is divided by w. Ours: the paper is
// silent. Sutherland & Hodgman's way, plane after plane.                                     Gumhold & Huettner 1999, section 3.3
//   distances   near w - near, far far - w, left x + G w, right G w - x, top y + G w, bottom G w - y,  G = 8190 pixels;  inside: >= 0
//               x = row_x . P + offset_x, y and w likewise, of the words of P: those of a cut are computed again at the next plane
//   a cut       of an edge from a to b: r = |da| / (|da| + |db|), every attribute a + (b - a) r
//
//   in    vertex[3]   base_vertex
//   regs  transform   rows and offsets (w_min takes no part);  near, far depth;  guard: the last four planes too
//   out   vertex[9]   base_vertex   the polygon, as triangles a fan about its first vertex; what is beyond `count` is all 0
//         inside      no plane cut: the three words as they came;  empty: no vertex is left
//         overflow    a plane made a tenth vertex, which was left out
//   near is the view volume's less the largest displacement, where w allows it, and far is so much beyond: what a displacement carries
//   into the volume is not cut. w_min lies 6 LSB below near, or a cut vertex might count as behind the eye.
//   registers: clip, clip_depth, ratio (correctly rounded, of distances cut to 25 bits), position, coordinate, colour, direction, unit
//
// What an edge becomes depends on its two ends alone, and is the same from b to a, so neighbours have the same words without an order:
// the other r is 1 - r, as r is never a tie. A tie would be an odd number of halves, |da| 2^26 / (|da| + |db|) odd, which takes a sum of
// 2^26 at least; with 25 bits each it is less. An edge of the polygon that lies along a plane may be cut more than once by rounding: a
// plane may then add more than one vertex.
//
// A cut vertex lies on its plane but for, in LSB of 2^-20, with |row| the sum of the row's magnitudes and S = |da| + |db|:
//   near, far      1 + |row_w| / 2 + S 2^-26 + [S >= 2^25] S 2^-24
//   the others     8191 + |row_x + G row_w| / 2 + S 2^-26 + [S >= 2^25] S 2^-24                  docs/error_budget.md, "Cut triangles"
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <type_traits>
#include <vector>

#include "golden/core/normalize.hpp"
#include "golden/core/quotient.hpp"
#include "golden/core/rounding.hpp"
#include "golden/sweep/world_data.hpp"

namespace relievo {
namespace golden {

enum class clip_plane { near, far, left, right, top, bottom };
constexpr clip_plane all_clip_planes[] = {clip_plane::near,  clip_plane::far, clip_plane::left,
                                          clip_plane::right, clip_plane::top, clip_plane::bottom};
constexpr double guard_pixels = 8190;

inline bool is_used(clip_plane plane, near_clip_regs const& regs) {
  return plane == clip_plane::near || plane == clip_plane::far || regs.guard;
}

template <class Rounding = rounded>
double clip_distance(clip_plane plane, glm::dvec3 const& p, near_clip_regs const& regs) {
  using namespace formats;
  static_assert(fits_double(dot3(bits_of<matrix_xy>(), bits_of<position>()) + bits_of<offset_xy>()), "clip");
  static_assert(fits_double(dot3(bits_of<matrix_w>(), bits_of<position>()) + bits_of<formats::offset_w>()), "clip_depth");
  static_assert(fits_double(bits_of<clip>() + bits_of<clip_depth>() * bits{14, 0}), "the distance to the guard band");
  const transform_regs& t = regs.transform;
  const double w = Rounding::template at<clip_depth>(glm::dot(t.row_w, p) + t.offset_w);
  const auto x = [&] { return Rounding::template at<clip>(glm::dot(t.row_x, p) + t.offset_x); };
  const auto y = [&] { return Rounding::template at<clip>(glm::dot(t.row_y, p) + t.offset_y); };
  switch (plane) {
    case clip_plane::near:
      return w - regs.near;
    case clip_plane::far:
      return regs.far - w;
    case clip_plane::left:
      return x() + guard_pixels * w;
    case clip_plane::right:
      return guard_pixels * w - x();
    case clip_plane::top:
      return y() + guard_pixels * w;
    case clip_plane::bottom:
      return guard_pixels * w - y();
  }
  return 0;
}

// The place of the plane on the edge from a to b.
template <class Rounding>
double clip_ratio(double da, double db) {
  da = std::abs(da);
  db = std::abs(db);
  if constexpr (Rounding::is_exact) {
    return da / (da + db);
  } else {
    constexpr int kept = 25;
    double scale = power_of_two(formats::clip::fraction);
    while (std::max(da, db) * scale >= power_of_two(kept)) scale /= 2;
    da = std::floor(da * scale);
    db = std::floor(db * scale);
    bool clipped = false;
    return quotient<Rounding, formats::ratio, kept + 1>(da, da + db, clipped);
  }
}

// Where the plane cuts the edge between two vertices at distances of different signs.
template <class Rounding = rounded>
base_vertex cut_vertex(base_vertex const& a, base_vertex const& b, double da, double db) {
  const double r = clip_ratio<Rounding>(da, db);
  base_vertex out;
  each_attribute(
      [r](auto f, double const& x, double const& y, double& cut) {
        using given = typename decltype(f)::given;
        static_assert(fits_double((bits_of<given>() + bits_of<given>()) * bits_of<formats::ratio>() + bits_of<given>()), "a + (b - a) r");
        using target = std::conditional_t<std::is_same_v<given, formats::unit>, formats::direction, given>;
        cut = Rounding::template at<target>(x + (y - x) * r);
      },
      a, b, out);
  out.n = normalize<Rounding>({out.n, false}).n;
  out.t = normalize<Rounding>({out.t, true}).n;
  return out;
}

template <class Rounding = rounded>
near_clip_out near_clip(near_clip_in const& in, near_clip_regs const& regs) {
  near_clip_out out;
  out.inside = true;
  std::vector<base_vertex> polygon(in.vertex, in.vertex + 3);
  for (const clip_plane plane : all_clip_planes) {
    if (!is_used(plane, regs)) continue;
    std::vector<double> d;
    d.reserve(polygon.size());
    for (base_vertex const& v : polygon) d.push_back(clip_distance<Rounding>(plane, v.p, regs));
    std::vector<base_vertex> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t next = (i + 1) % polygon.size();
      if (d[i] >= 0) left.push_back(polygon[i]);
      if ((d[i] >= 0) != (d[next] >= 0)) left.push_back(cut_vertex<Rounding>(polygon[i], polygon[next], d[i], d[next]));
      out.inside &= d[i] >= 0;
    }
    if (left.size() > clipped_vertices_max) {
      left.resize(clipped_vertices_max);
      out.overflow = true;
    }
    polygon = left;
  }
  std::copy(polygon.begin(), polygon.end(), out.vertex);
  out.count = static_cast<int>(polygon.size());
  out.empty = polygon.empty();
  return out;
}

}  // namespace golden
}  // namespace relievo
