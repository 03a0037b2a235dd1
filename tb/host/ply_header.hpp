// ply_header: the header of a .ply file: byte order, elements, properties. Used by read_ply.cpp alone.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::tb {

enum class ply_number { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class ply_encoding { text, little, big };

std::size_t size_of(ply_number t);

struct ply_property {
  std::string name;
  ply_number type = ply_number::f32;
  bool is_list = false;
  ply_number count_type = ply_number::u8;
};

struct ply_element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<ply_property> properties;
};

struct ply_header {
  ply_encoding encoding = ply_encoding::text;
  std::vector<ply_element> elements;
  std::vector<std::string> comments;
};

// Takes the header off the front of `bytes`. input_error, naming `name`, for what is no .ply header.
ply_header read_ply_header(std::string_view& bytes, std::string const& name);

}  // namespace relievo::tb
