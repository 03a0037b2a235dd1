// read_exr: a displacement map from an .exr, by OpenEXR: the channel Y or the only one. Values 0..1 become 0..65535, or LO..HI when a
// sample range is given; others are refused rather than clipped.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tb/host/input_error.hpp"
#include "tb/host/map.hpp"
#include "tb/host/quantise.hpp"

namespace relievo::tb {

namespace {

class memory_stream : public Imf::IStream {
 public:
  memory_stream(std::string_view bytes, char const* name) : Imf::IStream(name), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (count < 0 || at_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - at_)
      throw std::runtime_error("the file ends early");
    std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override { at_ = to; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::string channel_of(Imf::ChannelList const& channels, std::string const& name) {
  if (channels.findChannel("Y") != nullptr) return "Y";
  int count = 0;
  std::string only;
  for (auto c = channels.begin(); c != channels.end(); ++c) {
    ++count;
    only = c.name();
  }
  if (count != 1) throw input_error(name + ": has " + std::to_string(count) + " channels; one, or one called Y, is needed");
  return only;
}

// Which values came out, beside the samples made of them.
struct span_seen {
  double low = INFINITY, high = -INFINITY;
  bool finite = true;
};

// A few rows at a time, from the bottom up: a damaged file is found out before memory for all of it is taken.
constexpr int rows_at_a_time = 64;

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

// The same for the table of rows that InputFile makes.
void check_header(std::string_view bytes, std::string const& name) {
  constexpr unsigned char magic[] = {0x76, 0x2f, 0x31, 0x01};
  if (bytes.size() < 8 || std::memcmp(bytes.data(), magic, sizeof magic) != 0)
    throw std::runtime_error("its first bytes are not an .exr's");
  int version = static_cast<int>(number_at(bytes, 4));
  constexpr int deep = 0x800, several_parts = 0x1000;
  if ((version & (deep | several_parts)) != 0) throw std::runtime_error("a flat picture of one part is needed");
  check_attributes(bytes);
  memory_stream stream(bytes, name.c_str());
  stream.seekg(8);
  Imf::Header header;
  header.readFrom(stream, version);
  const auto window = header.dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > max_map_size || height > max_map_size)
    throw input_error(name + ": " + std::to_string(width) + " x " + std::to_string(height) + " samples; from 1 to " +
                      std::to_string(max_map_size) + " along an axis are possible");
}

span_seen decode(std::string_view bytes, sample_range const& range, displacement_map& map) {
  check_header(bytes, map.name);
  memory_stream stream(bytes, map.name.c_str());
  Imf::InputFile file(stream, 0);
  const auto window = file.header().dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
  const std::string channel = channel_of(file.header().channels(), map.name);
  Imf::Channel const& kind = *file.header().channels().findChannel(channel.c_str());
  if (kind.xSampling != 1 || kind.ySampling != 1)
    throw input_error(map.name + ": the channel " + channel + " is subsampled; every pixel is needed");
  if (kind.type == Imf::UINT) throw input_error(map.name + ": the channel " + channel + " holds integers; half or float is needed");
  map.width = static_cast<int>(width);
  map.height = static_cast<int>(height);
  const std::size_t row = static_cast<std::size_t>(width) * sizeof(float);
  std::vector<float> values(static_cast<std::size_t>(width) * rows_at_a_time);
  span_seen seen;
  for (std::int64_t last = window.max.y; last >= window.min.y; last -= rows_at_a_time) {
    const std::int64_t first = std::max<std::int64_t>(window.min.y, last - rows_at_a_time + 1);
    const Imath::Box2i slab({window.min.x, static_cast<int>(first)}, {window.max.x, static_cast<int>(last)});
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), slab, sizeof(float), row));
    file.setFrameBuffer(frame);
    file.readPixels(static_cast<int>(first), static_cast<int>(last));
    for (std::int64_t y = last; y >= first; --y) {
      for (std::int64_t x = 0; x < width; ++x) {
        const double value = static_cast<double>(values[static_cast<std::size_t>((y - first) * width + x)]);
        seen.finite = seen.finite && std::isfinite(value);
        seen.low = std::fmin(seen.low, value);
        seen.high = std::fmax(seen.high, value);
        const double part = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
        map.texels.push_back(seen.finite ? static_cast<std::uint16_t>(std::lround(part * 65535.0)) : std::uint16_t(0));
      }
    }
  }
  return seen;
}

}  // namespace

displacement_map read_exr(std::string_view bytes, std::string const& name, std::optional<sample_range> range) {
  const sample_range span = range.value_or(sample_range{0.0, 1.0});
  displacement_map map;
  map.name = name;
  span_seen seen;
  try {
    seen = decode(bytes, span, map);
  } catch (input_error const&) {
    throw;
  } catch (std::exception const& e) {
    std::string why = e.what();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw input_error(name + ": unusable as .exr: " + why.substr(0, 200));
  }
  if (!seen.finite) throw input_error(name + ": holds values that are not finite");
  if (seen.low < std::fmin(span.low, span.high) || seen.high > std::fmax(span.low, span.high))
    throw input_error(name + ": its values run from " + shown(seen.low) + " to " + shown(seen.high) + ", outside " + shown(span.low) +
                      ".." + shown(span.high) + "; give --sample-range " + shown(seen.low) + "," + shown(seen.high) + " or a wider one");
  return map;
}

}  // namespace relievo::tb
