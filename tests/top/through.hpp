// through: one record through an entry point and back, packed on the way in and out.
//
//   through<Out>(in, [](auto& in, auto& out) { relievo_x(in, ..., out); })
//   An entry point must take the one word, give one word, and leave nothing behind.
#pragma once
#include <gtest/gtest.h>

#include "hls/top/top.hpp"
#include "tests/support/vectors.hpp"

namespace relievo::test {

// The units have their million in their own tests; a port only has to carry every field.
inline std::uint64_t port_vectors() { return vector_count() / 10; }

template <class Out, class In, class Call>
Out through(In const& record, Call call) {
  static hls::port<In> in("in");
  static hls::port<Out> out("out");
  in.write(hls::pack(record));
  call(in, out);
  EXPECT_TRUE(in.empty()) << "one word a call";
  EXPECT_EQ(out.size(), 1) << "one word a call";
  return hls::unpack<Out>(out.read());
}

}  // namespace relievo::test
