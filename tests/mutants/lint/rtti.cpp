// rejected: rtti
// Asks an object what it is.
struct edge_test {
  virtual bool operator()() const = 0;
};
struct view_test final : edge_test {
  bool operator()() const override { return true; }
};

bool is_view_test(edge_test const& test) { return dynamic_cast<view_test const*>(&test) != nullptr; }
