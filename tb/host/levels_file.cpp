// levels_file: filter levels to and from a tiled .exr with mipmap levels (filter_levels.hpp has the format).
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfIntAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledInputFile.h>
#include <ImfTiledOutputFile.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "tb/host/exr_bytes.hpp"
#include "tb/host/files.hpp"
#include "tb/host/filter_levels.hpp"
#include "tb/host/input_error.hpp"
#include "tb/host/level_axis.hpp"

namespace relievo::tb {

namespace {

constexpr char channel[] = "Y", kind_attribute[] = "levelKind", checksum_attribute[] = "levelChecksum";
constexpr int tile = 64;

float value_of(std::uint16_t word) { return static_cast<float>(word / 65535.0); }

int checksum(std::vector<displacement_map> const& levels) {
  uLong sum = ::crc32(0, nullptr, 0);
  for (displacement_map const& level : levels)
    for (const std::uint16_t word : level.texels) {
      const Bytef bytes[2] = {static_cast<Bytef>(word & 0xff), static_cast<Bytef>(word >> 8)};
      sum = ::crc32(sum, bytes, 2);
    }
  return static_cast<int>(static_cast<std::uint32_t>(sum));
}

std::string address_of(displacement_map const& map) {
  const auto name = [](bool wrap) { return wrap ? "periodic" : "clamp"; };
  return std::string(name(map.wrap_u)) + "," + name(map.wrap_v);
}

// Rows y0 .. y1 of a picture `width` wide, counted from its top, as one buffer for the library.
Imf::FrameBuffer frame_of(std::vector<float>& values, int width, int y0, int y1) {
  Imf::FrameBuffer frame;
  const Imath::Box2i slab({0, y0}, {width - 1, y1});
  frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), slab, sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
  return frame;
}

void write_level(Imf::TiledOutputFile& file, displacement_map const& level, int number) {
  for (int dy = 0; dy < file.numYTiles(number); ++dy) {
    const int first = dy * tile, last = std::min(first + tile, level.height) - 1;
    std::vector<float> values;
    for (int y = first; y <= last; ++y)
      for (int x = 0; x < level.width; ++x) values.push_back(value_of(level.at(x, level.height - 1 - y)));
    file.setFrameBuffer(frame_of(values, level.width, first, last));
    file.writeTiles(0, file.numXTiles(number) - 1, dy, dy, number);
  }
}

// A few rows at a time, so that a damaged file is found out before memory for all of it is taken.
void read_level(Imf::TiledInputFile& file, displacement_map& level, int number) {
  for (int dy = file.numYTiles(number) - 1; dy >= 0; --dy) {
    const int first = dy * tile, last = std::min(first + tile, level.height) - 1;
    std::vector<float> values(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(last - first + 1));
    file.setFrameBuffer(frame_of(values, level.width, first, last));
    file.readTiles(0, file.numXTiles(number) - 1, dy, dy, number);
    for (int y = last; y >= first; --y)
      for (int x = 0; x < level.width; ++x) {
        const float value =
            values[static_cast<std::size_t>(y - first) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x)];
        const double word = std::floor(static_cast<double>(value) * 65535.0 + 0.5);
        if (!(word >= 0.0 && word <= 65535.0) || value_of(static_cast<std::uint16_t>(word)) != value)
          throw std::runtime_error("level " + std::to_string(number) + " holds a value that is no word of 16 bits");
        level.texels.push_back(static_cast<std::uint16_t>(word));
      }
  }
}

// What the header says of the levels; none of their texels yet. What a file of levels always has and this one hasn't makes it none.
filter_levels described(Imf::Header const& header, std::string const& name) {
  const auto* kind = header.findTypedAttribute<Imf::StringAttribute>(kind_attribute);
  if (kind == nullptr || header.findTypedAttribute<Imf::IntAttribute>(checksum_attribute) == nullptr || !header.hasTileDescription() ||
      !Imf::hasWrapmodes(header))
    throw input_error(name + ": holds no filter levels; a file that `relievo map levels` wrote is needed");
  const std::optional<level_kind> known = level_kind_of(kind->value());
  if (!known) throw input_error(name + ": levelKind is '" + kind->value() + "'; averaged, maximum, minimum or variational is needed");
  displacement_map map;
  map.name = name;
  bool found = false;
  for (const bool wrap_u : {false, true})
    for (const bool wrap_v : {false, true}) {
      displacement_map tried;
      tried.wrap_u = wrap_u;
      tried.wrap_v = wrap_v;
      if (Imf::wrapmodes(header) != address_of(tried)) continue;
      found = true;
      map.wrap_u = wrap_u;
      map.wrap_v = wrap_v;
    }
  if (!found) throw input_error(name + ": wrapmodes is '" + Imf::wrapmodes(header) + "'; clamp or periodic for u and v is needed");
  Imf::TileDescription const& tiles = header.tileDescription();
  if (tiles.mode != Imf::MIPMAP_LEVELS || tiles.roundingMode != Imf::ROUND_UP || tiles.xSize != tile || tiles.ySize != tile)
    throw input_error(name + ": mipmap levels with sizes rounded up in tiles of 64 x 64 are needed");
  auto const& channels = header.channels();
  const Imf::Channel* only = channels.findChannel(channel);
  if (only == nullptr || ++channels.begin() != channels.end() || only->type != Imf::FLOAT || only->xSampling != 1 || only->ySampling != 1)
    throw input_error(name + ": one channel Y of floats, with every pixel, is needed");
  auto const& window = header.dataWindow();
  if (window.min.x != 0 || window.min.y != 0) throw input_error(name + ": its data window begins beside 0, 0");
  map.width = window.max.x + 1;
  map.height = window.max.y + 1;
  return {*known, {map}};
}

filter_levels decode(std::string_view bytes, std::string const& name) {
  const Imf::Header header = checked_exr_header(bytes, name);
  filter_levels made = described(header, name);
  exr_input stream(bytes, name.c_str());
  Imf::TiledInputFile file(stream, 0);
  const displacement_map map = made.levels[0];
  const int count = levels_of(map.width, map.height);
  if (file.numLevels() != count)
    throw std::runtime_error(std::to_string(file.numLevels()) + " levels where " + std::to_string(count) + " are due");
  for (int l = 0; l < count; ++l) {
    if (l > 0) made.levels.push_back(map);
    displacement_map& level = made.levels.back();
    level.width = level_axis{map.width, l, map.wrap_u}.texels();
    level.height = level_axis{map.height, l, map.wrap_v}.texels();
    if (level.width != file.levelWidth(l) || level.height != file.levelHeight(l))
      throw std::runtime_error("level " + std::to_string(l) + " has another size");
    read_level(file, level, l);
  }
  if (header.findTypedAttribute<Imf::IntAttribute>(checksum_attribute)->value() != checksum(made.levels))
    throw input_error(name + ": damaged: its words do not have its checksum");
  return made;
}

}  // namespace

std::string levels_bytes(filter_levels const& made) {
  displacement_map const& map = made.levels.at(0);
  Imf::Header header(map.width, map.height);
  header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  header.compression() = Imf::ZIP_COMPRESSION;
  header.setTileDescription(Imf::TileDescription(tile, tile, Imf::MIPMAP_LEVELS, Imf::ROUND_UP));
  header.insert(kind_attribute, Imf::StringAttribute(name_of(made.kind)));
  header.insert(checksum_attribute, Imf::IntAttribute(checksum(made.levels)));
  Imf::addWrapmodes(header, address_of(map));
  exr_output bytes;
  {
    Imf::TiledOutputFile file(bytes, header, 0);
    for (std::size_t l = 0; l < made.levels.size(); ++l) write_level(file, made.levels[l], static_cast<int>(l));
  }
  return bytes.bytes();
}

void write_levels(filter_levels const& made, std::string const& path) { write_bytes(path, levels_bytes(made)); }

bool has_levels(std::string_view bytes) {
  try {
    return checked_exr_header(bytes, "").findTypedAttribute<Imf::StringAttribute>(kind_attribute) != nullptr;
  } catch (std::exception const&) {
    return false;
  }
}

filter_levels read_levels(std::string_view bytes, std::string const& name) {
  try {
    return decode(bytes, name);
  } catch (input_error const&) {
    throw;
  } catch (std::bad_alloc const&) {
    throw;
  } catch (std::exception const& e) {
    throw as_input_error(name, e);
  }
}

filter_levels load_levels(std::string const& path, displacement_map const& map) {
  filter_levels made = read_levels(read_bytes(path), path);
  displacement_map const& own = made.levels[0];
  const auto size = [](displacement_map const& m) { return std::to_string(m.width) + " x " + std::to_string(m.height); };
  if (own.width != map.width || own.height != map.height)
    throw input_error(path + ": levels of a map of " + size(own) + " samples; " + map.name + " has " + size(map));
  if (own.wrap_u != map.wrap_u || own.wrap_v != map.wrap_v)
    throw input_error(path + ": made for the borders " + address_of(own) + "; " + address_of(map) + " is needed");
  if (own.texels != map.texels) throw input_error(path + ": levels of another map than " + map.name);
  for (displacement_map& level : made.levels) {
    level.name = map.name;
    level.range = map.range;
  }
  return made;
}

}  // namespace relievo::tb
