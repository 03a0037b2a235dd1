#include "tb/model/sweep_model.hpp"

#include <deque>
#include <vector>

#include "golden/core/rounding.hpp"
#include "golden/sweep/engine.hpp"
#include "hls/sweep/engine.hpp"
#include "hls/sweep/z_table.hpp"
#include "tb/host/input_error.hpp"
#include "tb/model/hls_maps.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {

__extension__ typedef __int128 int128;
constexpr std::int64_t one = std::int64_t{1} << 60;

golden::base_triangle base_of(golden::triangle const& t) {
  golden::base_triangle out;
  for (int i = 0; i < 3; ++i) out.v[i] = {t.v[i].p, t.v[i].n, t.v[i].t, t.v[i].u, glm::dvec4(1.0)};
  out.index = t.index;
  out.last = t.last;
  return out;
}

// Hands on what the engine puts out, with the weights of its vertices.
class output {
 public:
  explicit output(run_hooks const& hooks) : hooks_(hooks) {}

  void begin(golden::swept_piece const& piece) {
    pieces_.push_back({begun_++, piece});
    if (hooks_.piece) hooks_.piece(piece);
  }
  void put(golden::swept_triangle const& t) {
    if (hooks_.swept) hooks_.swept(t);
    if (!hooks_.out) return;
    // A triangle leaves after the piece behind it has begun, at the latest.
    while (!t.empty && pieces_.front().number < t.piece) pieces_.pop_front();
    golden::triangle_out out;
    for (int i = 0; i < 3; ++i) {
      golden::swept_vertex const& v = t.v[i];
      out.v[i] = {v.p, v.t, v.u, v.displaced_p, v.displaced_n, v.screen, v.w, v.behind, glm::dvec3(0.0), false, {}};
      if (!t.empty) out.v[i].barycentric = weights_of(t.name[i], pieces_.front().of.p, pieces_.front().of.plane);
    }
    out.index = t.index;
    out.empty = t.empty;
    out.last = t.last;
    hooks_.out(out);
  }

 private:
  struct numbered_piece {
    std::uint64_t number;
    golden::swept_piece of;
  };
  run_hooks const& hooks_;
  std::deque<numbered_piece> pieces_;
  std::uint64_t begun_ = 0;
};

// The counters that the engines share; all of them go to run_hooks::sweep_counts.
golden::counters shared_counters(golden::sweep_counters const& c) {
  golden::counters out;
  out.triangles_in = c.triangles_in;
  out.triangles_out = c.triangles_out;
  out.vertices = c.vertices;
  out.saturations = c.saturations;
  out.screen_saturations = c.screen_saturations;
  out.zero_vectors = c.zero_vectors;
  return out;
}

template <class Rounding>
class golden_sweep : public model {
 public:
  explicit golden_sweep(scene const& sc) : scene_(sc) {}

  golden::counters run(run_hooks const& hooks) override {
    golden::memories memories;
    memories.texels = scene_.map.texels.data();
    memories.normal_map = scene_.normal_map;
    golden::sweep_engine<Rounding> engine(scene_.sweep, memories);
    std::size_t begun = 0;
    const auto next = [&](golden::base_triangle& t) {
      if (begun == scene_.triangles.size()) return false;
      t = base_of(scene_.triangles[begun++]);
      if (hooks.progress) hooks.progress(begun);
      return true;
    };
    output out(hooks);
    const golden::sweep_counters counts = engine.run(
        next, [&](golden::swept_triangle const& t) { out.put(t); }, [&](golden::swept_piece const& piece) { out.begin(piece); });
    if (hooks.sweep_counts) hooks.sweep_counts({counts, std::nullopt});
    return shared_counters(counts);
  }

 private:
  scene const& scene_;
};

class hls_sweep : public model {
 public:
  explicit hls_sweep(scene const& sc) : normals_(build_normal_map(sc).words) {
    texels_ = sc.map.texels.data();
    bool exact = to_hls(sc.sweep, regs_);
    for (int i = 0; i < hls::z_table_words; ++i)
      z_.push_back(hls::raw(hls::z_table({regs_.kappa, hls::from_raw<format<9, 9, false>>(i)}).z));
    for (golden::triangle const& t : sc.triangles) {
      triangles_.emplace_back();
      exact = to_hls(base_of(t), triangles_.back()) && exact;
    }
    if (!exact) throw std::logic_error("a register or a base triangle of the scene is not quantised to its format");
  }

  golden::counters run(run_hooks const& hooks) override {
    hls::stream<hls::base_triangle, 2> in("base triangles");
    hls::stream<hls::swept_triangle, 2> written("swept triangles");
    const hls::sweep_memories memories = {{texels_}, {normals_.data()}, {z_.data()}};
    const bool watched = hooks.out || hooks.swept || hooks.piece;
    output out(hooks);
    std::deque<golden::swept_triangle> named;  // put out by the engine and not read yet
    std::size_t begun = 0;
    engine_.start();
    while (!engine_.done()) {
      if (engine_.wants_input() && in.empty() && begun < triangles_.size()) {
        in.write(triangles_[begun++]);
        if (hooks.progress) hooks.progress(begun);
      }
      engine_.step(in, written, regs_, memories);
      if (watched) follow(out, named);
      while (!written.empty()) {
        const hls::swept_triangle t = written.read();
        if (!watched) continue;
        golden::swept_triangle converted;
        if (!t.empty) {
          converted = named.front();
          named.pop_front();
        }
        to_golden(t, converted);
        out.put(converted);
      }
    }
    golden::sweep_counters counts;
    std::vector<std::uint64_t> words;
    engine_.counts().each_field([&](char const*, std::uint64_t x) { words.push_back(x); });
    std::size_t i = 0;
    counts.each_field([&](char const*, std::uint64_t& x) { x = words.at(i++); });
    if (hooks.sweep_counts) hooks.sweep_counts({counts, engine_.additions()});
    return shared_counters(counts);
  }

 private:
  // What the last step did: the piece that it began, the names of what it put out.
  void follow(output& out, std::deque<golden::swept_triangle>& named) const {
    if (engine_.began_piece()) {
      golden::base_triangle corners;
      to_golden(engine_.piece(), corners);
      golden::swept_piece piece{{corners.v[0], corners.v[1], corners.v[2]}, corners.index, engine_.walks(), {}, {}};
      if (piece.walked) {
        golden::sweep_line_in places;
        to_golden(engine_.places(), places);
        for (int i = 0; i < 3; ++i) piece.p[i] = places.p[i];
        to_golden(engine_.setup().plane, piece.plane);
      }
      out.begin(piece);
    }
    if (!engine_.put_out(0) && !engine_.put_out(1)) return;
    golden::primitive walked;
    to_golden(engine_.walked(), walked);
    const int corner[2][3] = {{0, 1, walked.quad ? 3 : 2}, {1, 2, 3}};
    for (int half = 0; half < 2; ++half)
      if (engine_.put_out(half)) {
        named.emplace_back();
        for (int i = 0; i < 3; ++i) named.back().name[i] = walked.v[corner[half][i]];
        named.back().piece = engine_.counts().pieces - 1;
      }
  }

  std::uint16_t const* texels_;
  std::vector<std::uint64_t> normals_;
  std::vector<std::int64_t> z_;
  hls::sweep_regs regs_;
  std::vector<hls::base_triangle> triangles_;
  hls::sweep_engine engine_;
};

}  // namespace

std::array<std::int64_t, 3> weights_of(golden::remeshed_vertex const& name, glm::dvec3 const (&p)[3],
                                       golden::remeshing_plane_out const& plane) {
  std::array<std::int64_t, 3> w{};
  const auto at = [&w](int corner) -> std::int64_t& { return w[static_cast<std::size_t>(corner)]; };
  if (name.kind == golden::kind_corner) {
    at(name.number) = one;
  } else if (name.kind == golden::kind_edge) {
    const int e = name.number, next = (e + 1) % 3;
    const golden::main_direction_out main = golden::main_direction({{p[e], p[next]}});
    const bool rising = p[e][main.axis] <= p[next][main.axis];
    const int canonical = rising ? e : next, other = rising ? next : e;
    at(other) = static_cast<std::int64_t>(static_cast<int128>(one) * static_cast<std::int64_t>(name.i) / static_cast<std::int64_t>(main.n));
    at(canonical) = one - at(other);
  } else {
    const auto difference = [&](int corner, int axis) { return static_cast<std::int64_t>(p[corner][axis] - p[plane.a][axis]); };
    const auto s = static_cast<std::int64_t>(name.s - p[plane.a][plane.s]), t = static_cast<std::int64_t>(name.t - p[plane.a][plane.t]);
    const int128 of_b = static_cast<int128>(one) * (s * difference(plane.c, plane.t) - t * difference(plane.c, plane.s));
    const int128 of_c = static_cast<int128>(one) * (t * difference(plane.b, plane.s) - s * difference(plane.b, plane.t));
    const auto det = static_cast<std::int64_t>(plane.det);
    at(plane.b) = static_cast<std::int64_t>(of_b / det);
    at(plane.c) = static_cast<std::int64_t>(of_c / det);
    at(plane.a) = one - at(plane.b) - at(plane.c);
  }
  return w;
}

std::unique_ptr<model> make_sweep_model(std::string const& name, scene const& sc) {
  if (name == "ideal") return std::make_unique<golden_sweep<golden::exact>>(sc);
  if (name == "golden") return std::make_unique<golden_sweep<golden::rounded>>(sc);
  if (name == "hls") return std::make_unique<hls_sweep>(sc);
  throw input_error("--model: " + name + ": the sweep engine has no circuit yet; known are ideal, golden, hls");
}

}  // namespace relievo::tb
