#include "tb/analysis/png_file.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace relievo::tb {
namespace {

using colour = std::array<std::uint8_t, 3>;

struct coded_rows {
  std::vector<png_color> palette;   // empty: RGB
  std::vector<std::uint8_t> bytes;  // rows without padding
  std::size_t row_bytes = 0;
};

coded_rows code(picture const& image) {
  coded_rows rows;
  std::map<colour, std::uint8_t> index;
  for (colour const& c : image.pixels) {
    if (index.size() > 256) break;
    index.try_emplace(c, std::uint8_t{0});
  }
  const auto width = static_cast<std::size_t>(image.width);
  if (index.size() > 256) {
    rows.row_bytes = 3 * width;
    rows.bytes.reserve(rows.row_bytes * static_cast<std::size_t>(image.height));
    for (colour const& c : image.pixels) rows.bytes.insert(rows.bytes.end(), c.begin(), c.end());
    return rows;
  }
  // In order of brightness, so that row filters see small differences between similar colours.
  std::vector<colour> order;
  order.reserve(index.size());
  for (auto const& entry : index) order.push_back(entry.first);
  std::stable_sort(order.begin(), order.end(), [](colour const& a, colour const& b) { return a[0] + a[1] + a[2] < b[0] + b[1] + b[2]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    index[order[i]] = static_cast<std::uint8_t>(i);
    rows.palette.push_back({order[i][0], order[i][1], order[i][2]});
  }
  rows.row_bytes = width;
  rows.bytes.reserve(image.pixels.size());
  for (colour const& c : image.pixels) rows.bytes.push_back(index[c]);
  return rows;
}

void append(png_structp png, png_bytep data, png_size_t length) {
  auto* out = static_cast<std::string*>(png_get_io_ptr(png));
  out->append(reinterpret_cast<char const*>(data), length);
}

[[noreturn]] void fail(png_structp, png_const_charp message) { throw std::runtime_error(std::string("libpng: ") + message); }

std::string encode(picture const& image, coded_rows const& rows, int filters, int strategy) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &fail, nullptr);
  if (png == nullptr) throw std::runtime_error("libpng gave no writer");
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, &append, nullptr);
  png_set_compression_level(png, 9);
  png_set_compression_mem_level(png, 9);
  png_set_compression_strategy(png, strategy);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, filters);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               rows.palette.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!rows.palette.empty()) png_set_PLTE(png, info, rows.palette.data(), static_cast<int>(rows.palette.size()));
  png_write_info(png, info);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) png_write_row(png, rows.bytes.data() + y * rows.row_bytes);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

}  // namespace

std::string encode_png(picture const& image) {
  const coded_rows rows = code(image);
  std::string best;
  for (const int filters : {PNG_FILTER_NONE, PNG_FILTER_SUB, PNG_FILTER_UP, PNG_FILTER_PAETH, PNG_ALL_FILTERS}) {
    for (const int strategy : {Z_DEFAULT_STRATEGY, Z_FILTERED}) {
      std::string bytes = encode(image, rows, filters, strategy);
      if (best.empty() || bytes.size() < best.size()) best = std::move(bytes);
    }
  }
  return best;
}

}  // namespace relievo::tb
