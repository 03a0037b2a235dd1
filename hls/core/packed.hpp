// packed: a record as one wide word, for the ports of an entry point.
//
//   The fields follow each other from bit 0, in the order of RELIEVO_FIELDS, arrays from element 0, records inside records in
//   place; a bool is one bit. The word is padded with zeros to a multiple of 8 bits: Bambu cuts a stream of 33 or 36 bits to 32
//   without a word, and a struct on a port too.
//
//   bits<N>              N bits, a multiple of 8: ap_uint<N> or ac_int<N, false> under the tools, words of 64 bits in simulation
//   field_width<T>       bits of a field or record, without the padding
//   port_word<T>         bits<field_width<T>, padded>
//   pack(record)         -> port_word<T>;  unpack<T>(word) -> T
#pragma once
#include "hls/core/fixed.hpp"

#if defined(RELIEVO_AP_FIXED)
#include <ap_int.h>
#elif defined(RELIEVO_AC_FIXED)
#include <ac_int.h>
#endif

namespace relievo {
namespace hls {

#if defined(RELIEVO_AP_FIXED)
template <int N>
using bits = ap_uint<N>;
#elif defined(RELIEVO_AC_FIXED)
template <int N>
using bits = ac_int<N, false>;
#else
template <int N>
struct bits {
  static constexpr int limbs = (N + 63) / 64;
  std::uint64_t limb[limbs];
  friend bool operator==(bits const& a, bits const& b) {
    bool equal = true;
    for (int i = 0; i < limbs; ++i) equal &= a.limb[i] == b.limb[i];
    return equal;
  }
  friend bool operator!=(bits const& a, bits const& b) { return !(a == b); }
};
#endif

// ---- widths ------------------------------------------------------------------------------------------------------------

namespace detail {
template <class T>
T const& any();  // for unevaluated operands
template <int N>
struct width_constant {
  static constexpr int value = N;
};
struct width_of_fields {
  template <class... Fields>
  auto operator()(Fields const&...) const;
};
}  // namespace detail

template <class Record>
struct field_width {
  static constexpr int value = decltype(detail::any<Record>().field_list(detail::width_of_fields()))::value;
};
template <>
struct field_width<bool> {
  static constexpr int value = 1;
};
template <class F>
struct field_width<fixed<F>> {
  static constexpr int value = F::width;
};
template <class T, int N>
struct field_width<T[N]> {
  static constexpr int value = N * field_width<T>::value;
};

namespace detail {
template <class... Fields>
struct width_sum;
template <>
struct width_sum<> {
  static constexpr int value = 0;
};
template <class First, class... Rest>
struct width_sum<First, Rest...> {
  static constexpr int value = field_width<First>::value + width_sum<Rest...>::value;
};
template <class... Fields>
auto width_of_fields::operator()(Fields const&...) const {
  return width_constant<width_sum<Fields...>::value>();
}
}  // namespace detail

template <class T>
using port_word = bits<(field_width<T>::value + 7) / 8 * 8>;

// ---- up to 64 bits of a word --------------------------------------------------------------------------------------------

namespace detail {

template <int Width, int N>
inline void put(bits<N>& word, int at, std::uint64_t value) {
#if defined(RELIEVO_AP_FIXED)
  word.range(at + Width - 1, at) = ap_uint<Width>(value);
#elif defined(RELIEVO_AC_FIXED)
  word.set_slc(at, ac_int<Width, false>(value));
#else
  const std::uint64_t kept = Width == 64 ? value : value & ((std::uint64_t(1) << (Width % 64)) - 1);
  const int low = at % 64;
  word.limb[at / 64] |= kept << low;
  if (low + Width > 64 && at / 64 + 1 < bits<N>::limbs) word.limb[at / 64 + 1] |= kept >> (64 - low);
#endif
}

template <int Width, int N>
inline std::uint64_t get(bits<N> const& word, int at) {
#if defined(RELIEVO_AP_FIXED)
  return ap_uint<Width>(word.range(at + Width - 1, at)).to_uint64();
#elif defined(RELIEVO_AC_FIXED)
  return word.template slc<Width>(at).to_uint64();
#else
  const int low = at % 64;
  std::uint64_t value = word.limb[at / 64] >> low;
  if (low + Width > 64 && at / 64 + 1 < bits<N>::limbs) value |= word.limb[at / 64 + 1] << (64 - low);
  return Width == 64 ? value : value & ((std::uint64_t(1) << (Width % 64)) - 1);
#endif
}

template <int N>
struct packer {
  bits<N>& word;
  int at;

  template <class T>
  void operator()(char const*, T const& field) {
    add(field);
  }
  void add(bool field) {
    put<1>(word, at, field ? 1 : 0);
    ++at;
  }
  template <class F>
  void add(fixed<F> const& field) {
    put<F::width>(word, at, static_cast<std::uint64_t>(raw(field)));
    at += F::width;
  }
  template <class T, int Count>
  void add(T const (&field)[Count]) {
    for (int i = 0; i < Count; ++i) add(field[i]);
  }
  template <class Record>
  auto add(Record const& field) -> decltype(field.each_field(*this)) {
    field.each_field(*this);
  }
};

template <int N>
struct unpacker {
  bits<N> const& word;
  int at;

  template <class T>
  void operator()(char const*, T& field) {
    take(field);
  }
  void take(bool& field) {
    field = get<1>(word, at) != 0;
    ++at;
  }
  template <class F>
  void take(fixed<F>& field) {
    // The sign bit is carried to bit 63, where the language's signed shift brings it back.
    const std::uint64_t high = get<F::width>(word, at) << (64 - F::width);
    field =
        from_raw<F>(F::is_signed ? static_cast<std::int64_t>(high) >> (64 - F::width) : static_cast<std::int64_t>(high >> (64 - F::width)));
    at += F::width;
  }
  template <class T, int Count>
  void take(T (&field)[Count]) {
    for (int i = 0; i < Count; ++i) take(field[i]);
  }
  template <class Record>
  auto take(Record& field) -> decltype(field.each_field(*this)) {
    field.each_field(*this);
  }
};

}  // namespace detail

template <class T>
inline port_word<T> pack(T const& record) {
  port_word<T> word = port_word<T>();
  detail::packer<(field_width<T>::value + 7) / 8 * 8> packer = {word, 0};
  packer.add(record);
  return word;
}

template <class T>
inline T unpack(port_word<T> const& word) {
  T record;
  detail::unpacker<(field_width<T>::value + 7) / 8 * 8> unpacker = {word, 0};
  unpacker.take(record);
  return record;
}

}  // namespace hls
}  // namespace relievo
