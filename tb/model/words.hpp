// words: records as flat lists of raw words, with names and formats, in the order of their fields.
//
//   The hls record is the measure: it knows every field's format. A golden record has the same fields in the same order as doubles.
//   layout<H>()        name, width, fraction and sign of every word of the hls record H
//   raw_words(h)       its words; set_raw_words(h, words) back
//   to_golden(h, g)    the same values as doubles; to_hls(g, h) back, and false where a double is no word of its format
//   difference(a, b)   where two lists of words of a layout first differ
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "hls/core/fixed.hpp"

namespace relievo::tb {

struct field {
  std::string name;
  int width, fraction;
  bool is_signed;

  double value(std::int64_t word) const { return std::ldexp(static_cast<double>(word), -fraction); }
  std::int64_t min() const { return is_signed ? -(std::int64_t(1) << (width - 1)) : 0; }
  std::int64_t max() const { return static_cast<std::int64_t>((std::uint64_t(1) << (width - (is_signed ? 1 : 0))) - 1); }
};

namespace detail {

// Leaves of either kind of record, in order. Const and mutable walks share the code.
template <class Leaf>
struct walker {
  Leaf leaf;
  std::string path{};
  bool named = false;

  template <class T>
  void operator()(char const* name, T& x) {
    const std::size_t length = path.size();
    if (named) path += (path.empty() ? "" : ".") + std::string(name);
    visit(x);
    path.resize(length);
  }

  template <class F>
  void visit(hls::fixed<F>& x) {
    leaf(path, x);
  }
  template <class F>
  void visit(hls::fixed<F> const& x) {
    leaf(path, x);
  }
  void visit(bool& x) { leaf(path, x); }
  void visit(bool const& x) { leaf(path, x); }
  void visit(double& x) { leaf(path, x); }
  void visit(double const& x) { leaf(path, x); }
  void visit(int& x) { leaf(path, x); }
  void visit(int const& x) { leaf(path, x); }
  template <int N>
  void visit(glm::vec<N, double>& x) {
    for (int i = 0; i < N; ++i) leaf(path, x[i]);
  }
  template <int N>
  void visit(glm::vec<N, double> const& x) {
    for (int i = 0; i < N; ++i) leaf(path, x[i]);
  }
  template <class T, std::size_t N>
  void visit(T (&x)[N]) {
    const std::size_t length = path.size();
    for (std::size_t i = 0; i < N; ++i) {
      if (named) path += "[" + std::to_string(i) + "]";
      visit(x[i]);
      path.resize(length);
    }
  }
  template <class T, std::size_t N>
  void visit(std::array<T, N>& x) {
    for (T& e : x) visit(e);
  }
  template <class T, std::size_t N>
  void visit(std::array<T, N> const& x) {
    for (T const& e : x) visit(e);
  }
  template <class T, class = std::enable_if_t<std::is_class_v<T>>>
  auto visit(T& x) -> decltype(x.each_field(*this)) {
    x.each_field(*this);
  }
};

template <class Record, class Leaf>
void walk(Record& record, Leaf leaf, bool named = false) {
  walker<Leaf> w{leaf, {}, named};
  record.each_field(w);
}

template <class T>
struct leaf_format {  // bool
  using type = format<1, 1, false>;
};
template <class F>
struct leaf_format<hls::fixed<F>> {
  using type = F;
};

inline std::int64_t leaf_word(bool x) { return x ? 1 : 0; }
template <class F>
std::int64_t leaf_word(hls::fixed<F> x) {
  return hls::raw(x);
}
inline void set_leaf(bool& x, std::int64_t word) { x = word != 0; }
template <class F>
void set_leaf(hls::fixed<F>& x, std::int64_t word) {
  x = hls::from_raw<F>(word);
}

}  // namespace detail

template <class H>
std::vector<field> const& layout() {
  static const std::vector<field> fields = [] {
    std::vector<field> list;
    H record{};
    detail::walk(
        record,
        [&](std::string const& path, auto& x) {
          using F = typename detail::leaf_format<std::remove_cv_t<std::remove_reference_t<decltype(x)>>>::type;
          list.push_back({path, F::width, F::fraction, F::is_signed});
        },
        true);
    return list;
  }();
  return fields;
}

template <class H>
std::vector<std::int64_t> raw_words(H const& record) {
  std::vector<std::int64_t> words;
  words.reserve(layout<H>().size());
  detail::walk(record, [&](std::string const&, auto& x) { words.push_back(detail::leaf_word(x)); });
  return words;
}

template <class H>
void set_raw_words(H& record, std::vector<std::int64_t> const& words) {
  std::size_t i = 0;
  detail::walk(record, [&](std::string const&, auto& x) { detail::set_leaf(x, words[i++]); });
}

template <class H, class G>
void to_golden(H const& from, G& to) {
  const std::vector<std::int64_t> words = raw_words(from);
  std::size_t i = 0;
  detail::walk(to, [&](std::string const&, auto& x) {
    using T = std::remove_reference_t<decltype(x)>;
    x = static_cast<T>(layout<H>()[i].value(words[i]));
    ++i;
  });
}

// The words of a golden record in the formats of H. `exact` says whether every double was one; a double that is none counts as
// its nearest word and is reported, never hidden.
template <class H, class G>
std::vector<std::int64_t> golden_words(G const& from, bool& exact) {
  std::vector<std::int64_t> words;
  words.reserve(layout<H>().size());
  detail::walk(from, [&](std::string const&, auto& x) {
    field const& f = layout<H>()[words.size()];
    const double scaled = std::ldexp(static_cast<double>(x), f.fraction);
    const double nearest = std::nearbyint(scaled);
    exact = exact && nearest == scaled && nearest >= static_cast<double>(f.min()) && nearest <= static_cast<double>(f.max());
    words.push_back(static_cast<std::int64_t>(nearest));
  });
  return words;
}

template <class G, class H>
bool to_hls(G const& from, H& to) {
  bool exact = true;
  set_raw_words(to, golden_words<H>(from, exact));
  return exact;
}

// Index of the first word that differs, or -1.
inline int difference(std::vector<std::int64_t> const& a, std::vector<std::int64_t> const& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) return static_cast<int>(i);
  return -1;
}

}  // namespace relievo::tb
