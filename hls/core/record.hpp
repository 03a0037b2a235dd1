// record: lets a record name its fields once, in order, so that ports, vectors, comparisons and the golden records all
// walk the same list. Names only, no arithmetic: golden/ may include this header too.
//
//   struct displace_in {
//     fixed<formats::position> p[3];
//     RELIEVO_FIELDS(p)
//   };
//   record.each_field(visitor) calls visitor("p", record.p); field_list(visitor), never called, has the type of visitor(p).
#pragma once

// One macro per number of fields keeps this C++14 without a preprocessor library.
#define RELIEVO_FIELD_1(f, a) f(#a, a);
#define RELIEVO_FIELD_2(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_1(f, __VA_ARGS__)
#define RELIEVO_FIELD_3(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_2(f, __VA_ARGS__)
#define RELIEVO_FIELD_4(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_3(f, __VA_ARGS__)
#define RELIEVO_FIELD_5(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_4(f, __VA_ARGS__)
#define RELIEVO_FIELD_6(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_5(f, __VA_ARGS__)
#define RELIEVO_FIELD_7(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_6(f, __VA_ARGS__)
#define RELIEVO_FIELD_8(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_7(f, __VA_ARGS__)
#define RELIEVO_FIELD_9(f, a, ...) \
  f(#a, a);                        \
  RELIEVO_FIELD_8(f, __VA_ARGS__)
#define RELIEVO_FIELD_10(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_9(f, __VA_ARGS__)
#define RELIEVO_FIELD_11(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_10(f, __VA_ARGS__)
#define RELIEVO_FIELD_12(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_11(f, __VA_ARGS__)
#define RELIEVO_FIELD_13(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_12(f, __VA_ARGS__)
#define RELIEVO_FIELD_14(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_13(f, __VA_ARGS__)
#define RELIEVO_FIELD_15(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_14(f, __VA_ARGS__)
#define RELIEVO_FIELD_16(f, a, ...) \
  f(#a, a);                         \
  RELIEVO_FIELD_15(f, __VA_ARGS__)
#define RELIEVO_FIELD_PICK(_1, _2, _3, _4, _5, _6, _7, _8, _9, _10, _11, _12, _13, _14, _15, _16, name, ...) name
#define RELIEVO_EACH_FIELD(f, ...)                                                                                           \
  RELIEVO_FIELD_PICK(__VA_ARGS__, RELIEVO_FIELD_16, RELIEVO_FIELD_15, RELIEVO_FIELD_14, RELIEVO_FIELD_13, RELIEVO_FIELD_12,  \
                     RELIEVO_FIELD_11, RELIEVO_FIELD_10, RELIEVO_FIELD_9, RELIEVO_FIELD_8, RELIEVO_FIELD_7, RELIEVO_FIELD_6, \
                     RELIEVO_FIELD_5, RELIEVO_FIELD_4, RELIEVO_FIELD_3, RELIEVO_FIELD_2, RELIEVO_FIELD_1, 0)                 \
  (f, __VA_ARGS__)

#define RELIEVO_FIELDS(...)                  \
  template <class Visitor>                   \
  void each_field(Visitor&& visitor) {       \
    RELIEVO_EACH_FIELD(visitor, __VA_ARGS__) \
  }                                          \
  template <class Visitor>                   \
  void each_field(Visitor&& visitor) const { \
    RELIEVO_EACH_FIELD(visitor, __VA_ARGS__) \
  }                                          \
  template <class Visitor>                   \
  auto field_list(Visitor visitor) const->decltype(visitor(__VA_ARGS__));
