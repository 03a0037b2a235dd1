// relievo_wrong: the command line with models that are wrong on purpose, for the tests of compare:
//   wrong-word    golden, but the last triangle of base triangle 5 has a word of displace off by an LSB, and one of transform behind it
//   wrong-order   the same, and the triangles come last first
//   wrong-split   golden without the last triangle of base triangle 5
//   wrong-rarely  wrong-order where base triangle 4 was there too
#include <algorithm>
#include <memory>
#include <vector>

#include "hls/core/formats.hpp"
#include "tb/model/model.hpp"

namespace relievo::test {
namespace {

using triangles = std::vector<golden::triangle_out>;

class wrong_model : public tb::model {
 public:
  wrong_model(tb::scene const& sc, void (*spoil)(triangles&), bool in_order)
      : golden_(tb::make_model("golden", sc)), spoil_(spoil), in_order_(in_order) {}
  golden::counters run(tb::run_hooks const& hooks) override {
    triangles out;
    tb::run_hooks inner = hooks;
    inner.out = [&](golden::triangle_out const& t) { out.push_back(t); };
    const golden::counters counts = golden_->run(inner);
    spoil_(out);
    for (golden::triangle_out& t : out) {
      // No hardware's record has a path.
      t.path = 1;
      if (hooks.out) hooks.out(t);
    }
    return counts;
  }
  bool in_order() const override { return in_order_; }

 private:
  std::unique_ptr<tb::model> golden_;
  void (*spoil_)(triangles&);
  bool in_order_;
};

constexpr double lsb = 1.0 / (1 << formats::position::fraction);

triangles::iterator last_of(triangles& out, double index) {
  auto found = out.end();
  for (auto t = out.begin(); t != out.end(); ++t)
    if (t->index == index) found = t;
  return found;
}
void word(triangles& out) {
  const auto t = last_of(out, 5);
  if (t == out.end()) return;
  t->v[2].displaced_p.y += lsb;
  t->v[2].screen.x = 0;
}
void order(triangles& out) {
  word(out);
  std::reverse(out.begin(), out.end());
}
void split(triangles& out) {
  if (const auto t = last_of(out, 5); t != out.end()) out.erase(t);
}
void rarely(triangles& out) {
  if (last_of(out, 4) != out.end()) word(out);
}

template <void Spoil(triangles&), bool InOrder>
std::unique_ptr<tb::model> make(tb::scene const& sc) {
  return std::make_unique<wrong_model>(sc, Spoil, InOrder);
}
const bool added = [] {
  tb::add_model("wrong-word", make<word, true>);
  tb::add_model("wrong-order", make<order, false>);
  tb::add_model("wrong-split", make<split, false>);
  tb::add_model("wrong-rarely", make<rarely, false>);
  return true;
}();

}  // namespace
}  // namespace relievo::test
