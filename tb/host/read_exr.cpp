// read_exr: a displacement map from an .exr, by OpenEXR: the channel Y or the only one. Values 0..1 become 0..65535, or LO..HI when a
// sample range is given; others are refused rather than clipped.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cmath>

#include "tb/host/exr_bytes.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/map.hpp"
#include "tb/host/quantise.hpp"

namespace relievo::tb {

namespace {

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

span_seen decode(std::string_view bytes, sample_range const& range, displacement_map& map) {
  checked_exr_header(bytes, map.name);
  exr_input stream(bytes, map.name.c_str());
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
    throw as_input_error(name, e);
  }
  if (!seen.finite) throw input_error(name + ": holds values that are not finite");
  if (seen.low < std::fmin(span.low, span.high) || seen.high > std::fmax(span.low, span.high))
    throw input_error(name + ": its values run from " + shown(seen.low) + " to " + shown(seen.high) + ", outside " + shown(span.low) +
                      ".." + shown(span.high) + "; give --sample-range " + shown(seen.low) + "," + shown(seen.high) + " or a wider one");
  return map;
}

}  // namespace relievo::tb
