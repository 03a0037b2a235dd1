// read_exr: a displacement map from an .exr, by OpenEXR: the channel Y or the only one. Values 0..1 become 0..65535, or LO..HI when a
// sample range is given; others are refused rather than clipped.
#include <ImfArray.h>
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

struct grey_picture {
  int width = 0, height = 0;
  std::vector<float> values;  // rows from the top
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

grey_picture decode(std::string_view bytes, std::string const& name) {
  memory_stream stream(bytes, name.c_str());
  Imf::InputFile file(stream, 0);
  const auto window = file.header().dataWindow();
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > max_map_size || height > max_map_size)
    throw input_error(name + ": " + std::to_string(width) + " x " + std::to_string(height) + " samples; from 1 to " +
                      std::to_string(max_map_size) + " along an axis are possible");
  const std::string channel = channel_of(file.header().channels(), name);
  Imf::Channel const& kind = *file.header().channels().findChannel(channel.c_str());
  if (kind.xSampling != 1 || kind.ySampling != 1)
    throw input_error(name + ": the channel " + channel + " is subsampled; every pixel is needed");
  if (kind.type == Imf::UINT) throw input_error(name + ": the channel " + channel + " holds integers; half or float is needed");
  grey_picture picture;
  picture.width = static_cast<int>(width);
  picture.height = static_cast<int>(height);
  picture.values.resize(static_cast<std::size_t>(width * height));
  // The slice's base is where the pixel (0, 0) would lie; reckoned as a number, since it may lie outside the array.
  const std::size_t row = static_cast<std::size_t>(width) * sizeof(float);
  const std::int64_t origin = window.min.x * std::int64_t(sizeof(float)) + window.min.y * static_cast<std::int64_t>(row);
  char* base = reinterpret_cast<char*>(reinterpret_cast<std::uintptr_t>(picture.values.data()) - static_cast<std::uintptr_t>(origin));
  Imf::FrameBuffer frame;
  frame.insert(channel, Imf::Slice(Imf::FLOAT, base, sizeof(float), row));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return picture;
}

}  // namespace

displacement_map read_exr(std::string_view bytes, std::string const& name, std::optional<sample_range> range) {
  grey_picture picture;
  try {
    picture = decode(bytes, name);
  } catch (input_error const&) {
    throw;
  } catch (std::exception const& e) {
    std::string why = e.what();
    std::replace(why.begin(), why.end(), '\n', ' ');
    throw input_error(name + ": unusable as .exr: " + why.substr(0, 200));
  }
  double low = INFINITY, high = -INFINITY;
  for (float value : picture.values) {
    if (!std::isfinite(value)) throw input_error(name + ": holds values that are not finite");
    low = std::fmin(low, static_cast<double>(value));
    high = std::fmax(high, static_cast<double>(value));
  }
  const sample_range span = range.value_or(sample_range{0.0, 1.0});
  if (low < std::fmin(span.low, span.high) || high > std::fmax(span.low, span.high))
    throw input_error(name + ": its values run from " + shown(low) + " to " + shown(high) + ", outside " + shown(span.low) + ".." +
                      shown(span.high) + "; give --sample-range " + shown(low) + "," + shown(high) + " or a wider one");
  displacement_map map;
  map.name = name;
  map.width = picture.width;
  map.height = picture.height;
  const auto width = static_cast<std::size_t>(map.width);
  for (int y = map.height - 1; y >= 0; --y)
    for (std::size_t x = 0; x < width; ++x) {
      const double part =
          (static_cast<double>(picture.values[static_cast<std::size_t>(y) * width + x]) - span.low) / (span.high - span.low);
      map.texels.push_back(static_cast<std::uint16_t>(std::lround(part * 65535.0)));
    }
  return map;
}

}  // namespace relievo::tb
