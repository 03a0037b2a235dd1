// held_word: the rule of a valid/ready link on the ports of a Verilated model: while valid and not ready, valid and the word hold.
//   held_word h("name");  h.look(valid, ready, port, clock) in every clock, before the edge; a broken rule is a failure of the test
//   h.forget()  after a reset
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace relievo::test {

class held_word {
 public:
  explicit held_word(char const* name) : name_(name) {}

  void forget() { held_ = false; }

  template <class Port>
  void look(bool valid, bool ready, Port const& port, std::uint64_t clock) {
    if (held_ && !valid) ADD_FAILURE() << name_ << ": valid fell before the word was taken, clock " << clock;
    if (held_ && valid && words(port) != word_) ADD_FAILURE() << name_ << ": the word changed before it was taken, clock " << clock;
    held_ = valid && !ready;
    if (held_) word_ = words(port);
  }

 private:
  template <class Port>
  static std::vector<std::uint64_t> words(Port const& port) {
    std::vector<std::uint64_t> list;
    if constexpr (std::is_integral_v<Port>) {
      list.push_back(port);
    } else {
      for (std::size_t i = 0; i < sizeof(Port) / 4; ++i) list.push_back(port[i]);
    }
    return list;
  }

  char const* name_;
  bool held_ = false;
  std::vector<std::uint64_t> word_;
};

}  // namespace relievo::test
