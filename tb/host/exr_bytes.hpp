// exr_bytes: what the readers of .exr files share: bytes in memory as OpenEXR's streams, and a look at the header before the library takes
// memory for whatever it claims.
//
//   exr_input(bytes, name)            the bytes as a stream; exr_output collects what is written
//   checked_exr_header(bytes, name)   the header of a flat picture of one part with at most 8192 pixels along an axis
//   as_input_error(name, e)           one line of what the library says
//   Errors: input_error for sizes; whatever else is wrong leaves as std::exception, for as_input_error.
#pragma once
#include <ImfHeader.h>
#include <ImfIO.h>

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

class exr_input : public Imf::IStream {
 public:
  exr_input(std::string_view bytes, char const* name) : Imf::IStream(name), bytes_(bytes) {}
  bool read(char to[], int count) override;
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override { at_ = to; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

class exr_output : public Imf::OStream {
 public:
  exr_output() : Imf::OStream("memory") {}
  void write(char const from[], int count) override;
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t to) override { at_ = to; }
  std::string const& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

Imf::Header checked_exr_header(std::string_view bytes, std::string const& name);
input_error as_input_error(std::string const& name, std::exception const& e);

}  // namespace relievo::tb
