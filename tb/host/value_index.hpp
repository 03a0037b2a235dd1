// value_index: numbers distinct tuples of doubles in the order they come, so that equal ones share a number. Negative zero counts as zero.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace relievo::tb {

template <std::size_t N>
class value_index {
 public:
  using key = std::array<double, N>;

  explicit value_index(std::size_t expected = 0) { numbers_.reserve(expected); }

  std::uint32_t operator()(key values) {
    for (double& value : values) value += 0.0;
    return numbers_.emplace(values, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  struct hash {
    std::size_t operator()(key const& values) const {
      std::uint64_t h = 0x9e3779b97f4a7c15u;
      for (double value : values) {
        std::uint64_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        h = (h ^ (word ^ (word >> 29))) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 32;
      }
      return static_cast<std::size_t>(h);
    }
  };
  std::unordered_map<key, std::uint32_t, hash> numbers_;
};

}  // namespace relievo::tb
