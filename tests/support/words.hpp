// words: compares what hls put out with what golden says, raw word by raw word, and shows records.
//
//   stimulus<In, Regs>       one input vector: in and regs of a unit, as one record
//   as_golden<G>(h)          the hls record h as the golden record G
//   equal_words(h, g)        success, or which field differs, both words in hex and as numbers. A golden double that is no word of
//                            its field, or an hls word outside its format, is a difference.
//   describe(h)              every field of a record, a line each
// The usual case, equality, touches no heap: a million comparisons are a fraction of a second.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "hls/core/record.hpp"
#include "tb/model/words.hpp"

namespace relievo::test {

template <class In, class Regs>
struct stimulus {
  In in;
  Regs regs;
  RELIEVO_FIELDS(in, regs)
};

// The raw words of an hls record; every word takes at least one byte of the record, so its size bounds their number.
template <class H>
struct word_list {
  std::array<std::int64_t, sizeof(H)> word;
  std::size_t count;
};

template <class H>
inline void words_of(H const& record, word_list<H>& list) {
  std::size_t n = 0;
  tb::detail::walk(record, [&](std::string const&, auto& x) { list.word[n++] = tb::detail::leaf_word(x); });
  list.count = n;
}

// 2^fraction and the range of every word of H.
struct word_range {
  double scale;
  std::int64_t min, max;
};
template <class H>
std::vector<word_range> const& word_ranges() {
  static const std::vector<word_range> ranges = [] {
    std::vector<word_range> list;
    for (tb::field const& f : tb::layout<H>()) list.push_back({std::ldexp(1.0, f.fraction), f.min(), f.max()});
    return list;
  }();
  return ranges;
}

template <class G, class H>
G as_golden(H const& record) {
  word_list<H> list;
  words_of(record, list);
  std::vector<word_range> const& ranges = word_ranges<H>();
  G golden;
  std::size_t n = 0;
  tb::detail::walk(golden, [&](std::string const&, auto& x) {
    using T = std::remove_reference_t<decltype(x)>;
    x = static_cast<T>(static_cast<double>(list.word[n]) / ranges[n].scale);
    ++n;
  });
  return golden;
}

inline std::string word_text(tb::field const& f, std::int64_t word) {
  const int digits = (f.width + 3) / 4;
  const std::uint64_t bits = static_cast<std::uint64_t>(word) & (~std::uint64_t(0) >> (64 - f.width));
  char text[80];
  std::snprintf(text, sizeof text, "0x%0*" PRIx64 " (%" PRId64 ", %.17g)", digits, bits, word, f.value(word));
  return text;
}

template <class H>
std::string describe(H const& record) {
  word_list<H> list;
  words_of(record, list);
  std::string text;
  for (std::size_t i = 0; i < list.count; ++i) {
    tb::field const& f = tb::layout<H>()[i];
    text += "  " + f.name + " = " + word_text(f, list.word[i]) + "\n";
  }
  return text;
}

template <class H, class G>
testing::AssertionResult equal_words(H const& hls, G const& golden) {
  word_list<H> list;
  words_of(hls, list);
  std::vector<word_range> const& ranges = word_ranges<H>();
  std::size_t n = 0, wrong = list.count;
  double right = 0;
  tb::detail::walk(golden, [&](std::string const&, auto& x) {
    const std::size_t i = n++;
    if (i >= list.count) return;
    const double value = static_cast<double>(x) * ranges[i].scale;
    const bool within = list.word[i] >= ranges[i].min && list.word[i] <= ranges[i].max;
    if (wrong == list.count && !(within && static_cast<double>(list.word[i]) == value)) {
      wrong = i;
      right = value;
    }
  });
  if (n != list.count) return testing::AssertionFailure() << "golden has " << n << " words, hls " << list.count;
  if (wrong == list.count) return testing::AssertionSuccess();
  tb::field const& f = tb::layout<H>()[wrong];
  auto failure = testing::AssertionFailure() << f.name << ": hls " << word_text(f, list.word[wrong]) << ", golden ";
  if (std::nearbyint(right) != right) return failure << right << " LSB, no word at all";
  return failure << word_text(f, static_cast<std::int64_t>(right));
}

// The same between two hls records.
template <class H>
testing::AssertionResult same_words(H const& a, H const& b) {
  word_list<H> left, right;
  words_of(a, left);
  words_of(b, right);
  for (std::size_t i = 0; i < left.count; ++i)
    if (left.word[i] != right.word[i]) {
      tb::field const& f = tb::layout<H>()[i];
      return testing::AssertionFailure() << f.name << ": " << word_text(f, left.word[i]) << " against " << word_text(f, right.word[i]);
    }
  return testing::AssertionSuccess();
}

}  // namespace relievo::test
