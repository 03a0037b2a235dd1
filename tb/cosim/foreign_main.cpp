// The bench around somebody else's circuit of a unit, one program a circuit: docs/foreign_rtl.md; built by relievo_foreign_rtl in tb.
//
//   foreign_UNIT [--vectors N] [--seed N] [--interval N] [--regs-offset N] [FILE.vec]
//     words: every word of the input at its corners before three backgrounds, then N random ones (uniform, of random magnitude, corners,
//     mixed; unit vectors for half of them) over 16 draws of the registers; or the recorded ones of FILE.vec (relievo replay --record)
//     traffic: {no idle, idle} x {no stall, stall}, each from a reset
//   Held against the kernel of hls/, word by word in order; at most --interval clocks a word when nobody waits (1, as hls/top promises).
//   Exit codes as relievo's: 1 a word differs or a check failed, 2 unusable input.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <random>

#include RELIEVO_FOREIGN_HEADER
#include "tb/commands/vectors.hpp"
#include "tb/cosim/coverage.hpp"
#include "tb/cosim/foreign_bench.hpp"
#include "tb/host/files.hpp"
#include "tb/host/input_error.hpp"
#include "tb/model/compare.hpp"

// SystemC's library asks for it when it is linked; this program has its own main.
extern "C" int sc_main(int, char**);
int sc_main(int, char**) { return 0; }

namespace relievo::tb {
namespace {

struct arguments {
  std::uint64_t vectors = 10000, seed = 1;
  double interval = 1;
  int regs_offset = 0x10;
  std::string file;
};

// Words that go in with one setting of the registers.
struct burst {
  unit_words regs;
  std::vector<unit_words> in, out;
};

// Corners and random words of any record.
class drawing {
 public:
  explicit drawing(std::uint64_t seed) : random_(seed) {}

  static std::vector<std::int64_t> corners(field const& f) {
    const std::int64_t one = f.fraction >= 0 && f.fraction < f.width ? std::int64_t(1) << f.fraction : 1;
    std::vector<std::int64_t> list = {0, 1, f.max(), f.max() - 1, f.min(), f.min() + 1, -1, one, one - 1, one + 1};
    for (std::int64_t& x : list) x = std::clamp(x, f.min(), f.max());
    return list;
  }
  unit_words words(std::vector<field> const& fields, int how) {
    unit_words list;
    for (field const& f : fields) list.push_back(word(f, how == 3 ? static_cast<int>(random_() % 3) : how));
    return list;
  }
  // Three words of the unit format in a row become a vector of length 1, rounded.
  void make_unit_vectors(unit_words& w, std::vector<field> const& fields) const {
    for (std::size_t i = 0; i + 2 < w.size(); ++i) {
      field const& f = fields[i];
      const bool three = f.name.size() > 3 && f.name.compare(f.name.size() - 3, 3, "[0]") == 0 && f.width == 16 && f.fraction == 14 &&
                         fields[i + 2].name == f.name.substr(0, f.name.size() - 3) + "[2]";
      if (!three) continue;
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) square += f.value(w[i + k]) * f.value(w[i + k]);
      if (square == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) w[i + k] = std::llround(std::ldexp(f.value(w[i + k]) / std::sqrt(square), f.fraction));
    }
  }

 private:
  std::int64_t word(field const& f, int how) {
    if (how == 2) return corners(f)[random_() % 10];
    const std::uint64_t bits = random_();
    std::int64_t x = f.is_signed ? static_cast<std::int64_t>(bits) >> (64 - f.width) : static_cast<std::int64_t>(bits >> (64 - f.width));
    if (how == 1) x >>= random_() % static_cast<std::uint64_t>(f.width);
    return x;
  }
  std::mt19937_64 random_;
};

std::vector<burst> drawn(pure_unit const& unit, arguments const& a) {
  drawing draw(a.seed);
  std::vector<burst> bursts;
  constexpr int draws = 16;
  for (int i = 0; i < draws; ++i) {
    burst b;
    b.regs = draw.words(unit.regs, i % 4);
    if (i % 2 == 1) draw.make_unit_vectors(b.regs, unit.regs);
    // The corners once.
    for (std::size_t at = 0; i == 0 && at < unit.in.size(); ++at)
      for (std::size_t corner = 0; corner < 10; ++corner)
        for (std::size_t background : {0, 2, 4}) {
          unit_words w;
          for (std::size_t k = 0; k < unit.in.size(); ++k) w.push_back(drawing::corners(unit.in[k])[k == at ? corner : background]);
          b.in.push_back(w);
        }
    for (std::uint64_t n = 0; n < a.vectors / draws; ++n) {
      b.in.push_back(draw.words(unit.in, static_cast<int>(n % 4)));
      if (n % 8 >= 4) draw.make_unit_vectors(b.in.back(), unit.in);
    }
    for (unit_words const& w : b.in) b.out.push_back(unit.hls(w, b.regs));
    bursts.push_back(b);
  }
  return bursts;
}

std::vector<burst> recorded(pure_unit const& unit, std::string const& file) {
  const unit_vectors v = parse_vectors(read_bytes(file), file);
  if (v.unit != unit.name) throw input_error(file + ": holds words of " + v.unit + ", and this circuit is of " + unit.name);
  return {{v.regs, v.in, v.out}};
}

void print_record(char const* what, unit_words const& words, std::vector<field> const& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    std::printf("  %s\n", word_text(what + fields[i].name + " =", words[i], fields[i]).c_str());
}

int bench(pure_unit const& unit, arguments const& a, VerilatedContext& context) {
  const std::vector<burst> bursts = a.file.empty() ? drawn(unit, a) : recorded(unit, a.file);
  foreign_bench<RELIEVO_FOREIGN_MODEL> circuit(unit, context, a.regs_offset);
  const keep_coverage kept(context);
  std::size_t words = 0;
  foreign_run free;
  std::uint64_t seed = a.seed;
  for (int idle : {0, 40})
    for (int stall : {0, 40})
      for (burst const& b : bursts) {
        const foreign_traffic traffic = {idle, stall, ++seed};
        const auto told = [&] {
          return "idle " + std::to_string(idle) + " %, stall " + std::to_string(stall) + " %, seed " + std::to_string(a.seed);
        };
        foreign_run run;
        try {
          run = circuit.run(traffic, b.in, b.regs, b.out);
        } catch (cosim_error const& e) {
          std::printf("%s: %s; %s\n", unit.name.c_str(), e.what(), told().c_str());
          return 1;
        }
        if (run.wrong) {
          const std::size_t i = run.words;
          const auto at = static_cast<std::size_t>(difference(b.out[i], run.last));
          field const& f = unit.out[at];
          std::printf("%s: record %zu, field %s: %s, %s, clock %llu; %s\n", unit.name.c_str(), i, f.name.c_str(),
                      word_text(a.file.empty() ? "hls" : "recorded", b.out[i][at], f).c_str(), word_text("rtl", run.last[at], f).c_str(),
                      static_cast<unsigned long long>(run.clock), told().c_str());
          print_record("", b.in[i], unit.in);
          print_record("regs.", b.regs, unit.regs);
          return 1;
        }
        words += b.out.size();
        if (idle == 0 && stall == 0 && run.interval >= free.interval) free = run;
      }
  std::printf("%s: %zu words, 0 differ; latency %llu clocks, %.3f clocks a word\n", unit.name.c_str(), words,
              static_cast<unsigned long long>(free.latency), free.interval);
  if (free.interval <= a.interval) return 0;
  std::printf("%s: a word takes %.3f clocks, where %g is promised\n", unit.name.c_str(), free.interval, a.interval);
  return 1;
}

int run(int argc, char** argv) {
  pure_unit const* unit = find_unit(RELIEVO_FOREIGN_UNIT);
  if (unit == nullptr) throw input_error("RELIEVO_FOREIGN_UNIT: '" RELIEVO_FOREIGN_UNIT "' is no unit of one word in and one word out");
  arguments a;
  CLI::App app("The bench around a circuit of " RELIEVO_FOREIGN_UNIT);
  app.add_option("--vectors", a.vectors, "random words")->capture_default_str()->check(CLI::Range(16, 100000000));
  app.add_option("--seed", a.seed, "of words, registers and traffic")->capture_default_str();
  app.add_option("--interval", a.interval, "clocks a word at most, when nobody waits")->capture_default_str();
  app.add_option("--regs-offset", a.regs_offset, "address of regs on s_axi_control")->capture_default_str();
  app.add_option("FILE", a.file, "FILE.vec: recorded words instead of drawn ones");
  VerilatedContext context;
  context.randReset(2);
  std::vector<std::string> rest;
  try {
    // +name=value is for the circuit ($value$plusargs).
    context.commandArgs(argc, argv);
    for (int i = argc - 1; i > 0; --i)
      if (argv[i][0] != '+') rest.emplace_back(argv[i]);
    app.parse(rest);
  } catch (CLI::ParseError const& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    throw input_error(e.what());
  }
  context.randSeed(static_cast<int>(a.seed & 0x7fffffff) + 1);
  return bench(*unit, a, context);
}

}  // namespace
}  // namespace relievo::tb

int main(int argc, char** argv) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  try {
    return relievo::tb::run(argc, argv);
  } catch (relievo::tb::input_error const& e) {
    std::fprintf(stderr, "%s: %s\n", RELIEVO_FOREIGN_UNIT, e.what());
    return 2;
  }
}
