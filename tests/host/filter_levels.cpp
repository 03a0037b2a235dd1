// filter_levels: all levels of a map, to a file and back; every file that is none, is damaged or belongs to another map is refused; how far
// the volume falls on the terrain of tests/data.
#include "tb/host/filter_levels.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfIntAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include "tb/host/exr_bytes.hpp"
#include "tb/host/level_axis.hpp"
#include "tests/support/level_maps.hpp"
#include "tests/support/refuses.hpp"
#include "tests/support/temporary_folder.hpp"

namespace relievo::test {
namespace {

testing::AssertionResult equal(tb::filter_levels const& a, tb::filter_levels const& b) {
  if (a.kind != b.kind || a.levels.size() != b.levels.size()) return testing::AssertionFailure() << "another kind or count";
  for (std::size_t l = 0; l < a.levels.size(); ++l) {
    tb::displacement_map const &x = a.levels[l], &y = b.levels[l];
    if (x.width != y.width || x.height != y.height || x.wrap_u != y.wrap_u || x.wrap_v != y.wrap_v)
      return testing::AssertionFailure() << "level " << l << ": another size or border";
    if (x.texels != y.texels) return testing::AssertionFailure() << "level " << l << ": other words";
  }
  return testing::AssertionSuccess();
}

auto reading(std::string const& bytes) {
  return [bytes] { tb::read_levels(bytes, "a.exr"); };
}

// A file of levels like ours, with something else about it; its texels are 0 and its checksum is right for that only when `checksum` is 0.
struct forged {
  std::string kind = "averaged", wrapmodes = "clamp,clamp", channel = "Y";
  Imf::PixelType type = Imf::FLOAT;
  Imf::TileDescription tiles{64, 64, Imf::MIPMAP_LEVELS, Imf::ROUND_UP};
  int width = 5, height = 3, levels = -1, left = 0;
  bool has_checksum = true, has_wrapmodes = true;
  float value = 0.0f;

  std::string bytes() const {
    Imf::Header header({{left, 0}, {left + width - 1, height - 1}}, {{left, 0}, {left + width - 1, height - 1}});
    header.channels().insert(channel, Imf::Channel(type));
    header.setTileDescription(tiles);
    if (!kind.empty()) header.insert("levelKind", Imf::StringAttribute(kind));
    if (has_checksum) header.insert("levelChecksum", Imf::IntAttribute(0));
    if (has_wrapmodes) Imf::addWrapmodes(header, wrapmodes);
    tb::exr_output out;
    {
      Imf::TiledOutputFile file(out, header, 0);
      const std::vector<float> values(static_cast<std::size_t>(width * height), value);
      const int count = tiles.mode == Imf::RIPMAP_LEVELS ? 0 : levels < 0 ? file.numLevels() : levels;
      for (int l = 0; l < count; ++l) {
        Imf::FrameBuffer frame;
        frame.insert(channel, Imf::Slice(type, reinterpret_cast<char*>(const_cast<float*>(values.data())) - 4 * left, 4, 0));
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles(l) - 1, 0, file.numYTiles(l) - 1, l);
      }
    }
    return out.bytes();
  }
};

TEST(filter_levels, all_levels_down_to_one_texel) {
  for_level_maps("all levels", [](tb::displacement_map const& map) {
    for (const tb::level_kind kind : tb::all_level_kinds) {
      std::vector<tb::level_report> reports;
      int ticks = 0, passes = 0;
      const tb::filter_levels made = tb::make_levels(map, kind, 20, &reports, [&] { ++ticks; });
      ASSERT_EQ(made.levels.size(), static_cast<std::size_t>(tb::levels_of(map.width, map.height)));
      ASSERT_EQ(reports.size(), made.levels.size());
      ASSERT_EQ(made.levels[0].texels, map.texels);
      ASSERT_EQ(made.levels.back().texels.size(), 1u);
      for (std::size_t l = 1; l < made.levels.size(); ++l) {
        const int number = static_cast<int>(l);
        ASSERT_EQ(made.levels[l].width, level_size(map.width, number));
        ASSERT_EQ(made.levels[l].height, level_size(map.height, number));
        ASSERT_EQ(made.levels[l].wrap_u, map.wrap_u);
        const double volume = volume_by_definition(map, number, made.levels[l].texels);
        ASSERT_NEAR(reports[l].volume, volume, 1e-9 * (1.0 + volume));
        if (kind == tb::level_kind::averaged || kind == tb::level_kind::variational) {
          ASSERT_LE(reports[l].volume, reports[l].averaged_volume);
        }
        passes += reports[l].passes;
        ASSERT_LE(reports[l].passes, 20);
      }
      ASSERT_EQ(ticks, passes);
      ASSERT_EQ(passes > 0, kind == tb::level_kind::variational && map.texels.size() > 1);
    }
  });
}

TEST(filter_levels, what_is_written_comes_back_and_is_the_same_bytes) {
  const temporary_folder folder;
  for_level_maps("files", [&](tb::displacement_map const& map) {
    for (const tb::level_kind kind : tb::all_level_kinds) {
      const tb::filter_levels made = tb::make_levels(map, kind, 10);
      tb::write_levels(made, folder.file("a.exr"));
      ASSERT_TRUE(equal(tb::load_levels(folder.file("a.exr"), map), made)) << map.width << " x " << map.height << tb::name_of(kind);
      const std::string bytes = tb::levels_bytes(made);
      ASSERT_EQ(temporary_folder::bytes_of(folder.file("a.exr")), bytes);
      ASSERT_TRUE(tb::has_levels(bytes));
      // It is a map too, of level 0.
      ASSERT_EQ(tb::read_exr(bytes, "a.exr", {}).texels, map.texels);
    }
  });
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(filter_levels, every_word_and_several_tiles_come_back) {
  generator g("words");
  tb::displacement_map map = level_map(300, 219, 2, 16, g);
  for (std::size_t i = 0; i < 65536; ++i) map.texels[i] = static_cast<std::uint16_t>(i);
  const tb::filter_levels made = tb::make_levels(map, tb::level_kind::maximum);
  EXPECT_TRUE(equal(tb::read_levels(tb::levels_bytes(made), "a.exr"), made));
}

TEST(filter_levels, damaged_files_are_refused) {
  generator g("damaged");
  const tb::filter_levels made = tb::make_levels(level_map(21, 9, 1, 16, g), tb::level_kind::averaged);
  const std::string whole = tb::levels_bytes(made);
  for (std::size_t size = 0; size < whole.size(); ++size) ASSERT_TRUE(refuses(reading(whole.substr(0, size)), {"a.exr"})) << size;
  // One bit wrong: refused, or without a meaning for the levels.
  int refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (int bit : {0, 5, 7}) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      try {
        const tb::filter_levels read = tb::read_levels(damaged, "a.exr");
        // The word for one border or kind is none for another, so even these are right.
        ASSERT_TRUE(equal(read, made)) << "byte " << i << " bit " << bit;
      } catch (tb::input_error const& e) {
        ASSERT_EQ(std::string(e.what()).rfind("a.exr", 0), 0u) << e.what();
        ++refused;
      }
    }
  EXPECT_GT(refused, static_cast<int>(2 * whole.size()));
}

TEST(filter_levels, files_that_are_no_levels_are_refused) {
  const std::string good = forged{}.bytes();
  EXPECT_TRUE(refuses(reading(good), {"a.exr", "damaged", "checksum"}));
  EXPECT_TRUE(tb::has_levels(good));
  EXPECT_FALSE(tb::has_levels("no exr"));
  const auto with = [](auto const& change) {
    forged f;
    change(f);
    return reading(f.bytes());
  };
  EXPECT_TRUE(refuses(reading("no exr at all"), {"a.exr", "unusable as .exr"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.kind = ""; }), {"a.exr", "no filter levels", "relievo map levels"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.has_checksum = false; }), {"a.exr", "no filter levels"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.has_wrapmodes = false; }), {"a.exr", "no filter levels"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.kind = "median"; }), {"a.exr", "levelKind", "median", "variational"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.wrapmodes = "mirror"; }), {"a.exr", "wrapmodes", "mirror", "periodic"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.channel = "R"; }), {"a.exr", "channel Y"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.type = Imf::UINT; }), {"a.exr", "floats"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.tiles.xSize = 32; }), {"a.exr", "64 x 64"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.tiles.roundingMode = Imf::ROUND_DOWN; }), {"a.exr", "rounded up"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.tiles.mode = Imf::ONE_LEVEL; }), {"a.exr", "mipmap"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.tiles.mode = Imf::RIPMAP_LEVELS; }), {"a.exr", "mipmap"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.left = 1; }), {"a.exr", "begins beside"}));
  EXPECT_TRUE(refuses(with([](forged& f) { f.levels = 2; }), {"a.exr"}));
  for (float value : {-0.1f, 1.5f, NAN, INFINITY, 0.3f})
    EXPECT_TRUE(refuses(with([&](forged& f) { f.value = value; }), {"a.exr", "no word of 16 bits"})) << value;
}

TEST(filter_levels, levels_of_another_map_are_refused) {
  const temporary_folder folder;
  generator g("other");
  const tb::displacement_map map = level_map(12, 10, 0, 16, g);
  const std::string path = folder.file("a.exr");
  tb::write_levels(tb::make_levels(map, tb::level_kind::minimum), path);
  const auto loading = [&](tb::displacement_map const& m) { return [&path, m] { tb::load_levels(path, m); }; };
  EXPECT_TRUE(refuses(loading(level_map(12, 11, 0, 16, g)), {"a.exr", "12 x 10", "random has 12 x 11"}));
  tb::displacement_map wrapped = map, round = map, changed = map;
  wrapped.wrap_v = true;
  round.wrap_u = true;
  changed.texels[17] = static_cast<std::uint16_t>(changed.texels[17] ^ 1);
  EXPECT_TRUE(refuses(loading(wrapped), {"a.exr", "clamp,clamp", "clamp,periodic"}));
  EXPECT_TRUE(refuses(loading(round), {"a.exr", "clamp,clamp", "periodic,clamp"}));
  EXPECT_TRUE(refuses(loading(changed), {"a.exr", "another map"}));
  EXPECT_TRUE(refuses([&] { tb::load_levels(folder.file("none.exr"), map); }, {"none.exr", "no such file"}));
  EXPECT_TRUE(refuses([&] { tb::write_levels(tb::make_levels(map, tb::level_kind::minimum), folder.file("none/a.exr")); }, {"none/a.exr"}));
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(filter_levels, kinds_have_their_names) {
  for (const tb::level_kind kind : tb::all_level_kinds) EXPECT_EQ(tb::level_kind_of(tb::name_of(kind)), kind);
  EXPECT_FALSE(tb::level_kind_of("mean"));
  EXPECT_FALSE(tb::level_kind_of(""));
}

// What `relievo map levels` prints of the terrain: to 61, 71, 78, 85 % of the averaged levels' volume.
TEST(filter_levels, variational_levels_of_jacksboro) {
  const tb::displacement_map map = tb::read_map(RELIEVO_SOURCE_DIR "/tests/data/jacksboro_403x344.png", {});
  std::vector<tb::level_report> reports;
  tb::make_levels(map, tb::level_kind::variational, 100, &reports);
  constexpr double bounds[] = {0.615, 0.71, 0.782, 0.855, 0.92, 0.93, 0.945, 0.9, 0.998};
  ASSERT_EQ(reports.size(), 1 + std::size(bounds));
  for (std::size_t l = 1; l < reports.size(); ++l)
    EXPECT_LT(reports[l].volume, bounds[l - 1] * reports[l].averaged_volume) << "level " << l;
}

}  // namespace
}  // namespace relievo::test
