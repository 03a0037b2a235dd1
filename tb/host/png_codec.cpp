#include "tb/host/png_codec.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include "tb/host/input_error.hpp"

namespace relievo::tb {

namespace {

// libpng leaves by longjmp. So everything that has a destructor lives in these two structs, made before setjmp, and the functions between
// setjmp and the last call of libpng hold plain values alone.
struct decoding {
  std::string_view rest;
  std::string message;
  decoded_png picture;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;
  int largest = 0;
};

struct encoding {
  std::string bytes;
  std::string message;
  std::vector<png_const_bytep> rows;
};

template <class State>
void remember_error(png_structp png, png_const_charp message) {
  static_cast<State*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void no_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto* state = static_cast<decoding*>(png_get_io_ptr(png));
  if (count > state->rest.size()) png_error(png, "the file ends early");
  std::memcpy(to, state->rest.data(), count);
  state->rest.remove_prefix(count);
}

void give_bytes(png_structp png, png_bytep from, png_size_t count) {
  static_cast<encoding*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char const*>(from), count);
}

void nothing_to_flush(png_structp) {}

bool machine_is_little() {
  const std::uint16_t one = 1;
  return *reinterpret_cast<unsigned char const*>(&one) == 1;
}

// False when libpng gave up; state.message says why.
bool run_decoder(png_structp png, png_infop info, decoding& state) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_read_fn(png, &state, take_bytes);
  png_set_user_limits(png, static_cast<png_uint_32>(state.largest), static_cast<png_uint_32>(state.largest));
  png_set_chunk_malloc_max(png, 64u << 20);
  png_read_info(png, info);
  if (png_get_bit_depth(png, info) < 8) png_set_expand(png);
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
  if (png_get_valid(png, info, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png);
  if (machine_is_little()) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  state.picture.width = static_cast<int>(png_get_image_width(png, info));
  state.picture.height = static_cast<int>(png_get_image_height(png, info));
  state.picture.channels = png_get_channels(png, info);
  state.picture.bits = png_get_bit_depth(png, info);
  const std::size_t row = png_get_rowbytes(png, info), height = static_cast<std::size_t>(state.picture.height);
  state.rows.resize(height);
  if (state.picture.bits == 16) {
    // Straight into the samples: a map of 8192 x 8192 is held once.
    state.picture.samples.resize(row / 2 * height);
    for (std::size_t y = 0; y < height; ++y) state.rows[y] = reinterpret_cast<png_bytep>(state.picture.samples.data() + y * (row / 2));
  } else {
    state.bytes.resize(row * height);
    for (std::size_t y = 0; y < height; ++y) state.rows[y] = state.bytes.data() + y * row;
  }
  png_read_image(png, state.rows.data());
  png_read_end(png, nullptr);
  return true;
}

bool run_encoder(png_structp png, png_infop info, encoding& state, int width, int height, int channels, int bits) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &state, give_bytes, nothing_to_flush);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  for (std::size_t y = 0; y < state.rows.size(); ++y) png_write_row(png, state.rows[y]);
  png_write_end(png, info);
  return true;
}

// `bytes` as PNG has them: rows from the top, 16-bit samples with the high byte first.
std::string encode(int width, int height, int channels, int bits, std::vector<png_byte> const& bytes) {
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * static_cast<std::size_t>(bits / 8);
  if (width < 1 || height < 1 || (channels != 1 && channels != 3) || bytes.size() != row * static_cast<std::size_t>(height))
    throw std::logic_error("encode_png: the pixels do not match the size");
  encoding state;
  for (int y = 0; y < height; ++y) state.rows.push_back(bytes.data() + static_cast<std::size_t>(y) * row);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state, remember_error<encoding>, no_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && run_encoder(png, info, state, width, height, channels, bits);
  png_destroy_write_struct(&png, &info);
  if (!done) throw std::runtime_error("PNG encoder: " + state.message);
  return std::move(state.bytes);
}

}  // namespace

std::string encode_png8(int width, int height, int channels, std::vector<std::uint8_t> const& pixels) {
  return encode(width, height, channels, 8, pixels);
}

std::string encode_png16(int width, int height, int channels, std::vector<std::uint16_t> const& pixels) {
  std::vector<png_byte> bytes;
  bytes.reserve(pixels.size() * 2);
  for (std::uint16_t p : pixels) {
    bytes.push_back(static_cast<png_byte>(p >> 8));
    bytes.push_back(static_cast<png_byte>(p & 0xff));
  }
  return encode(width, height, channels, 16, bytes);
}

decoded_png decode_png(std::string_view bytes, std::string const& name, int largest) {
  if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0)
    throw input_error(name + ": no PNG, its first bytes are not a PNG's");
  decoding state;
  state.rest = bytes;
  state.largest = largest;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, remember_error<decoding>, no_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && run_decoder(png, info, state);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!done) {
    if (state.message.find("exceeds user limit") != std::string::npos || state.message.find("Invalid IHDR") != std::string::npos)
      state.message = "from 1 to " + std::to_string(largest) + " samples along an axis are possible (" + state.message + ")";
    throw input_error(name + ": unusable as PNG: " + state.message);
  }
  decoded_png& picture = state.picture;
  if (picture.bits != 16) picture.samples.assign(state.bytes.begin(), state.bytes.end());
  return std::move(picture);
}

}  // namespace relievo::tb
