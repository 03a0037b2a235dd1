// vectors: draws input vectors for any record and runs a check on each.
//
//   for_vectors<V>(shape, check)             corner vectors, then vector_count() random ones
//   for_vectors<V>(shape, check, count)      the same with another count (units that split the million across cases)
//     shape(v, g)   brings a drawn vector into the unit's domain (coordinates within a map, unit vectors ...); any_word leaves it alone
//     check(v)      testing::AssertionResult; the first failure is reported with the whole vector, its number and the seed
//
//   Corners of a word: zero, one LSB either way, both ends of its format and their neighbours, 1.0 and its neighbours. Corner vectors:
//   every word alone at each corner with all others at zero, at the top, at the bottom; and all words at the same corner.
//   Random vectors take turns: uniform words; words of random magnitude; corners alone; each word by one of the three.
#pragma once
#include "tests/support/random.hpp"
#include "tests/support/words.hpp"

namespace relievo::test {

constexpr int corner_count = 10;

template <class F>
constexpr std::int64_t corner_word(int corner) {
  constexpr std::int64_t low = hls::fixed<F>::min_raw, high = hls::fixed<F>::max_raw;
  constexpr bool has_one = F::integer_bits >= (F::is_signed ? 2 : 1) && F::fraction >= 0;
  constexpr std::int64_t one = has_one ? std::int64_t(1) << (has_one ? F::fraction : 0) : high / 2;
  constexpr std::int64_t words[corner_count] = {0, 1, high, high - 1, low, low + 1, F::is_signed ? -1 : high / 2, one, one - 1, one + 1};
  return words[corner] > high ? high : words[corner] < low ? low : words[corner];
}

enum class draw { uniform, magnitude, corner, mixed };

template <class F>
std::int64_t random_word(draw how, generator& g) {
  if (how == draw::mixed) how = static_cast<draw>(g.below(3));
  if (how == draw::corner) return corner_word<F>(static_cast<int>(g.below(corner_count)));
  const std::uint64_t bits = g();
  std::int64_t word =
      F::is_signed ? static_cast<std::int64_t>(bits) >> (64 - F::width) : static_cast<std::int64_t>(bits >> (64 - F::width));
  // As many bits as it likes, up to all; the sign stays.
  if (how == draw::magnitude) word >>= g.below(static_cast<std::uint64_t>(F::width));
  return word;
}

template <class V>
void draw_vector(V& v, draw how, generator& g) {
  tb::detail::walk(v, [&](std::string const&, auto& x) {
    using T = std::remove_reference_t<decltype(x)>;
    using F = typename tb::detail::leaf_format<T>::type;
    if constexpr (std::is_same_v<T, bool>)
      x = (g() >> 63) != 0;
    else
      x = hls::from_raw<F>(random_word<F>(how, g));
  });
}

// Word number `at` at a corner, all others at corner `others`.
template <class V>
void corner_vector(V& v, std::size_t at, int corner, int others) {
  std::size_t n = 0;
  tb::detail::walk(v, [&](std::string const&, auto& x) {
    using T = std::remove_reference_t<decltype(x)>;
    using F = typename tb::detail::leaf_format<T>::type;
    const int which = n++ == at ? corner : others;
    if constexpr (std::is_same_v<T, bool>)
      x = which % 2 != 0;
    else
      x = hls::from_raw<F>(corner_word<F>(which));
  });
}

struct any_word {
  template <class V>
  void operator()(V&, generator&) const {}
};

// A sequence of its own for every test, and for every round of vectors within it; outside a test (a benchmark) always the same one.
inline generator next_generator() {
  static testing::TestInfo const* last = nullptr;
  static int round = 0;
  testing::TestInfo const* current = testing::UnitTest::GetInstance()->current_test_info();
  if (current == nullptr) return generator("no test");
  round = current == last ? round + 1 : 0;
  last = current;
  return generator(std::string(current->test_suite_name()) + "." + current->name() + " " + std::to_string(round));
}

template <class V, class Shape, class Check>
void for_vectors(Shape shape, Check check, std::uint64_t count) {
  generator g = next_generator();
  V v{};
  std::uint64_t number = 0;
  const auto holds = [&](char const* kind) {
    shape(v, g);
    testing::AssertionResult result = check(v);
    if (result) return true;
    ADD_FAILURE() << result.message() << "\n" << kind << " vector " << number << ", seed " << seed() << ":\n" << describe(v);
    return false;
  };
  const std::size_t words = tb::layout<V>().size();
  constexpr int backgrounds[] = {0, 2, 4};
  for (std::size_t at = 0; at < words; ++at)
    for (int corner = 0; corner < corner_count; ++corner)
      for (const int others : backgrounds) {
        corner_vector(v, at, corner, others);
        if (!holds("corner")) return;
        ++number;
      }
  for (int corner = 0; corner < corner_count; ++corner) {
    corner_vector(v, words, corner, corner);
    if (!holds("corner")) return;
    ++number;
  }
  for (number = 0; number < count; ++number) {
    draw_vector(v, static_cast<draw>(number % 4), g);
    if (!holds("random")) return;
  }
}

template <class V, class Shape, class Check>
void for_vectors(Shape shape, Check check) {
  for_vectors<V>(shape, check, vector_count());
}

}  // namespace relievo::test
