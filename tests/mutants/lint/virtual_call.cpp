// rejected: virtual call, indirect call
// The tests of an edge as classes.
#include <cstdint>

namespace {
struct edge_test {
  virtual bool operator()(std::int32_t measure) const = 0;
};
struct normal_test final : edge_test {
  bool operator()(std::int32_t measure) const override { return measure > 3; }
};
struct view_test final : edge_test {
  bool operator()(std::int32_t measure) const override { return measure > 100; }
};
bool ask(edge_test const& test, std::int32_t measure) { return test(measure); }
}  // namespace

bool edge_test_virtual(bool view, std::int32_t measure) { return view ? ask(view_test(), measure) : ask(normal_test(), measure); }
