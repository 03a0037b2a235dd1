#include "tb/host/exr_bytes.hpp"

#include <ImathBox.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "tb/host/map.hpp"

namespace relievo::tb {

namespace {

// A number of four bytes, the lowest first.
std::int64_t number_at(std::string_view bytes, std::size_t at) {
  if (at + 4 > bytes.size()) throw std::runtime_error("the file ends early");
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return static_cast<std::int32_t>(value);
}

// Walks over the header's attributes (name, type, size, data): the library takes memory for whatever size one claims, however short the
// file is.
void check_attributes(std::string_view bytes) {
  std::size_t at = 8;
  while (at < bytes.size() && bytes[at] != '\0') {
    for (int word = 0; word < 2; ++word) {
      at = bytes.find('\0', at);
      if (at == std::string_view::npos) throw std::runtime_error("the file ends early");
      ++at;
    }
    const std::int64_t size = number_at(bytes, at);
    at += 4;
    if (size < 0 || static_cast<std::size_t>(size) > bytes.size() - at) throw std::runtime_error("an attribute reaches beyond the file");
    at += static_cast<std::size_t>(size);
  }
}

}  // namespace

bool exr_input::read(char to[], int count) {
  if (count < 0 || at_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - at_)
    throw std::runtime_error("the file ends early");
  std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
  at_ += static_cast<std::size_t>(count);
  return at_ < bytes_.size();
}

void exr_output::write(char const from[], int count) {
  const auto size = static_cast<std::size_t>(count);
  if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
  std::memcpy(bytes_.data() + at_, from, size);
  at_ += size;
}

// The same for the table of rows or tiles that the library makes.
Imf::Header checked_exr_header(std::string_view bytes, std::string const& name) {
  constexpr unsigned char magic[] = {0x76, 0x2f, 0x31, 0x01};
  if (bytes.size() < 8 || std::memcmp(bytes.data(), magic, sizeof magic) != 0)
    throw std::runtime_error("its first bytes are not an .exr's");
  int version = static_cast<int>(number_at(bytes, 4));
  constexpr int deep = 0x800, several_parts = 0x1000;
  if ((version & (deep | several_parts)) != 0) throw std::runtime_error("a flat picture of one part is needed");
  check_attributes(bytes);
  exr_input stream(bytes, name.c_str());
  stream.seekg(8);
  Imf::Header header;
  header.readFrom(stream, version);
  const auto window = header.dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > max_map_size || height > max_map_size)
    throw input_error(name + ": " + std::to_string(width) + " x " + std::to_string(height) + " samples; from 1 to " +
                      std::to_string(max_map_size) + " along an axis are possible");
  return header;
}

input_error as_input_error(std::string const& name, std::exception const& e) {
  std::string why = e.what();
  std::replace(why.begin(), why.end(), '\n', ' ');
  return input_error(name + ": unusable as .exr: " + why.substr(0, 200));
}

}  // namespace relievo::tb
