#include "tb/cosim/rtl_model.hpp"

#include "tb/cosim/base_words.hpp"
#include "tb/model/hls_words.hpp"
#include "tb/model/words.hpp"

namespace relievo::tb {

namespace {

cosim_settings& settings() {
  static cosim_settings s;
  return s;
}
std::uint64_t& abort_after() {
  static std::uint64_t clocks = 0;
  return clocks;
}
bool& reset_between() {
  static bool reset = true;
  return reset;
}
cosim_result& last_result() {
  static cosim_result r;
  return r;
}

class rtl_model : public model {
 public:
  explicit rtl_model(scene const& sc) : words_(sc), base_(base_words(words_.triangles())) {}

  golden::counters run(run_hooks const& hooks) override {
    const cosim_scene circuit = {words_.regs(), &base_, words_.memories()};
    golden::triangle_out converted;
    last_result() = the_engine_bench(settings())
                        .run(
                            circuit,
                            [&](hls::triangle_out const& t) {
                              if (!hooks.out) return;
                              to_golden(t, converted);
                              hooks.out(converted);
                            },
                            reset_between(), abort_after());
    return words_.counters(last_result().counters);
  }
  bool in_order() const override { return false; }

 private:
  hls_words words_;
  std::vector<hls::port_word<hls::top::base_triangle>> base_;
};

}  // namespace

void add_rtl_model() {
  add_default_engine();
  add_model("rtl", [](scene const& sc) -> std::unique_ptr<model> { return std::make_unique<rtl_model>(sc); });
}
void set_cosim_settings(cosim_settings const& s) { settings() = s; }
void set_cosim_abort(std::uint64_t clocks) { abort_after() = clocks; }
void set_cosim_reset_between(bool reset) { reset_between() = reset; }
cosim_result const& last_cosim_result() { return last_result(); }

}  // namespace relievo::tb
