// held_word: the rule of a valid/ready link on the ports of a Verilated model: while valid and not ready, valid and the word hold.
//   held_word h("name");  h.look(valid, ready, port)   in every clock, before the edge: what rule was broken, or nothing
//   h.forget()  after a reset;  h.waits()  a word was not taken in the last clock
#pragma once
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace relievo::tb {

class held_word {
 public:
  explicit held_word(char const* name) : name_(name) {}

  void forget() { held_ = false; }
  bool waits() const { return held_; }
  char const* name() const { return name_; }

  template <class Port>
  std::string look(bool valid, bool ready, Port const& port) {
    std::string broken;
    if (held_ && !valid) broken = std::string(name_) + ": valid fell before the word was taken";
    if (held_ && valid && words(port) != word_) broken = std::string(name_) + ": the word changed before it was taken";
    held_ = valid && !ready;
    if (held_) word_ = words(port);
    return broken;
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

}  // namespace relievo::tb
