// records: seeded random records, records as text, and a record through an entry point, over whatever type `fixed` is.
//   random_record<T>()               words of every size and both ends of their formats
//   print_record(name, record)       a line: the name and every word
//   through<Out>(name, record, call) packs the record into a port, calls the entry point, prints what it puts out
#pragma once
#include <cinttypes>
#include <cstdint>
#include <cstdio>

#include "hls/top/top.hpp"

// Inside relievo, where hls is relievo::hls whatever a tool calls its own.
namespace relievo {
namespace {

// splitmix64
std::uint64_t next_random() {
  static std::uint64_t state = 20000821;
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

// Words of every size and both ends of the format.
template <class F>
std::int64_t random_word() {
  const std::uint64_t bits = next_random(), kind = next_random() % 8;
  if (kind == 0) return hls::fixed<F>::max_raw - static_cast<std::int64_t>(bits % 2);
  if (kind == 1) return hls::fixed<F>::min_raw + static_cast<std::int64_t>(bits % 2);
  const int drop = 64 - F::width + (kind < 5 ? 0 : static_cast<int>(next_random() % F::width));
  return F::is_signed ? static_cast<std::int64_t>(bits) >> drop : static_cast<std::int64_t>(bits >> drop);
}

struct drawer {
  template <class T>
  void operator()(char const*, T& x) {
    draw(x);
  }
  void draw(bool& x) { x = next_random() % 2 != 0; }
  template <class F>
  void draw(hls::fixed<F>& x) {
    x = hls::from_raw<F>(random_word<F>());
  }
  template <class T, int N>
  void draw(T (&x)[N]) {
    for (int i = 0; i < N; ++i) draw(x[i]);
  }
  template <class T>
  auto draw(T& x) -> decltype(x.each_field(*this)) {
    x.each_field(*this);
  }
};
template <class T>
T random_record() {
  T record;
  drawer d;
  d.draw(record);
  return record;
}

struct printer {
  template <class T>
  void operator()(char const*, T const& x) {
    print(x);
  }
  void print(bool x) { std::printf(" %d", x ? 1 : 0); }
  template <class F>
  void print(hls::fixed<F> const& x) {
    std::printf(" %" PRId64, hls::raw(x));
  }
  template <class T, int N>
  void print(T const (&x)[N]) {
    for (int i = 0; i < N; ++i) print(x[i]);
  }
  template <class T>
  auto print(T const& x) -> decltype(x.each_field(*this)) {
    x.each_field(*this);
  }
};
template <class T>
void print_record(char const* name, T const& record) {
  std::printf("%s", name);
  printer p;
  p.print(record);
  std::printf("\n");
}

template <class Out, class In, class Call>
void through(char const* name, In const& record, Call call) {
  hls::port<In> in;
  hls::port<Out> out;
  in.write(hls::pack(record));
  call(in, out);
  print_record(name, hls::unpack<Out>(out.read()));
}

}  // namespace
}  // namespace relievo
