// clocked_model: the Verilated model of a module with clk_i and rst_ni, one clock after the other, for tests that look at single clocks.
//   clocked_model<Model> m;  m->port   its ports;  m.clock(n)  n rising edges, after each of which outputs stand;  m.settle()  within a
//   clock m.reset(n)       n clocks of reset, with the inputs as they are; registers begin with words of the run's seed
#pragma once
#include <verilated.h>

#include <memory>

#include "tb/cosim/coverage.hpp"
#include "tests/support/random.hpp"

namespace relievo::test {

template <class Model>
class clocked_model {
 public:
  clocked_model() {
    context_.randReset(2);
    context_.randSeed(reset_seed());
    model_ = std::make_unique<Model>(&context_);
    model_->clk_i = 0;
    model_->rst_ni = 0;
  }
  Model* operator->() { return model_.get(); }
  Model& operator*() { return *model_; }

  void settle() { model_->eval(); }
  void clock(int n = 1) {
    for (int i = 0; i < n; ++i) {
      model_->eval();
      model_->clk_i = 1;
      model_->eval();
      model_->clk_i = 0;
      model_->eval();
      kept_.begin();
    }
  }
  void reset(int clocks = 4) {
    model_->rst_ni = 0;
    clock(clocks);
    model_->rst_ni = 1;
    clock();
  }

 private:
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  tb::keep_coverage kept_{context_};
};

}  // namespace relievo::test
