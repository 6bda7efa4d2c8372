// Bands, PNG files and options of pictures.
#include "base/testing/temporary_folder.h"
#include "pictures/files/band_file.h"
#include "pictures/files/png_writer.h"
#include "pictures/picture_options.h"
#include "pictures/wanted_settings.h"
#include "shell_word.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace gluray::launcher {
namespace {

TEST(Pictures, SizesAreTwoNumbers) {
  int width = 0, height = 0;
  EXPECT_EQ(readSize("3840x2160", width, height), "");
  EXPECT_EQ(width, 3840);
  EXPECT_EQ(height, 2160);
  EXPECT_EQ(readSize("1X32768", width, height), "");
  for (const char* wrong :
       {"", "x", "12", "12x", "x12", "12x13x", "12x13 ", "-1x5", "0x5", "5x0", "32769x5", "5x99999999999"})
    EXPECT_NE(readSize(wrong, width, height), "") << wrong;
}

TEST(Pictures, CommandsMakeThemAgain) {
  PictureOptions options;
  options.scene = "my scene.gluray", options.file = "-x.png";
  EXPECT_EQ(commandOf(options, {}), "gluray render 'my scene.gluray' './-x.png'");
  options.size = "5x6", options.fit = "crop", options.background = "transparent", options.overlays = false;
  EXPECT_EQ(commandOf(options, {{"spp", "4"}, {"lights.file", "it's"}}),
            "gluray render 'my scene.gluray' './-x.png' --size 5x6 --fit crop --background transparent "
            "--no-overlays "
            "--set spp=4 --set 'lights.file=it'\\''s'");
  PictureOptions deep;
  deep.scene = "s.gluray", deep.file = "x.png", deep.depth = 16;
  EXPECT_EQ(commandOf(deep, {}), "gluray render s.gluray x.png --depth 16");
}

TEST(Pictures, LayersAreThoseOfOpenExr) {
  PictureOptions options;
  options.scene = "s.gluray", options.file = "a.exr", options.layers = "depth,albedo";
  EXPECT_EQ(whyNotOf(options), "");
  EXPECT_EQ(commandOf(options, {}), "gluray render s.gluray a.exr --layers 'depth,albedo'");
  options.file = "a.png";
  EXPECT_NE(whyNotOf(options), "");
}

TEST(Pictures, DepthsAreThoseOfTheForm) {
  const auto refuses = [](const char* file, int depth) {
    PictureOptions options;
    options.file = file, options.depth = depth;
    return !whyNotOf(options).empty();
  };
  EXPECT_FALSE(refuses("a.png", 0) || refuses("a.png", 8) || refuses("a.png", 16));
  EXPECT_FALSE(refuses("a.exr", 0) || refuses("a.exr", 16) || refuses("a.exr", 32));
  EXPECT_TRUE(refuses("a.png", 32));
  EXPECT_TRUE(refuses("a.exr", 8));
}

TEST(Pictures, PresetsBecomeTheirValues) {
  CommandLine line;
  line.settings.set("spp", "9"), line.settings.set("preset", "honest"), line.settings.set("quality", "good");
  const NamedValues values = wantedSettings(line);
  const auto valueOf = [&](const char* name) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
    return found == values.end() ? "none" : found->second;
  };
  EXPECT_EQ(valueOf("look"), "honest");
  EXPECT_EQ(valueOf("spp"), "9") << "what is given stands over the quality";
  EXPECT_EQ(valueOf("noise"), "0.01");
  EXPECT_EQ(valueOf("preset"), "none");
}

struct Bands : testing::Test {
  gluray::test::TemporaryFolder folder;
  const std::string path = folder.file("picture.unfinished");
  const BandPlan plan{1, 2, 3, 5, 2};
};

TEST_F(Bands, GoOnWhereTheyEnded) {
  const std::vector<uint32_t> first = {1, 2, 3, 4, 5, 6}, second = {7, 8, 9, 10, 11, 12}, last = {13, 14, 15};
  EXPECT_EQ(BandFile::finishedBands(path, 1, 2), 0);
  {
    BandFile file(path, plan);
    file.add(0, 2, first.data());
  }
  EXPECT_EQ(BandFile::finishedBands(path, 1, 2), 1);
  EXPECT_EQ(BandFile::finishedBands(path, 1, 3), 0) << "other work";
  BandFile file(path, plan);
  file.add(1, 2, second.data()), file.add(2, 1, last.data());
  std::vector<uint32_t> row;
  file.row(1, row);
  EXPECT_EQ(row, (std::vector<uint32_t>{4, 5, 6}));
  file.row(4, row);
  EXPECT_EQ(row, last);
  EXPECT_THROW(file.row(5, row), std::runtime_error);
  file.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Bands, HavePixelsOfAnySize) {
  BandPlan wide = plan;
  wide.pixelBytes = 8;
  const std::vector<float> pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  { BandFile(path, plan).add(0, 2, std::vector<uint32_t>(6).data()); }
  BandFile file(path, wide);
  EXPECT_EQ(BandFile::finishedBands(path, 1, 2), 0) << "pixels of another size";
  file.add(0, 2, pixels.data());
  std::vector<float> row;
  file.row(1, row);
  EXPECT_EQ(row, (std::vector<float>{7, 8, 9, 10, 11, 12}));
}

TEST_F(Bands, OfThisWorkAreKnownBeforeTheFirst) {
  EXPECT_FALSE(BandFile::isOf(path, 1, 2));
  { const BandFile begun(path, plan); }
  EXPECT_TRUE(BandFile::isOf(path, 1, 2));
  EXPECT_FALSE(BandFile::isOf(path, 1, 3));
  EXPECT_EQ(BandFile::finishedBands(path, 1, 2), 0);
}

TEST_F(Bands, OfOtherWorkAreDropped) {
  const std::vector<uint32_t> pixels(6, 1);
  BandFile(path, plan).add(0, 2, pixels.data());
  BandPlan other = plan;
  other.low = 9;
  const BandFile file(path, other);
  EXPECT_EQ(BandFile::finishedBands(path, 1, 2), 0);
  EXPECT_EQ(BandFile::finishedBands(path, 9, 2), 0);
  EXPECT_THROW(BandFile(folder.file("missing/x"), plan), std::runtime_error);
}

PngPicture pictureOf(const std::vector<uint32_t>& pixels, int width, bool alpha) {
  return {.width = width,
          .height = static_cast<int>(pixels.size()) / width,
          .alpha = alpha,
          .row = [=](int y, std::vector<uint32_t>& row) {
            row.assign(pixels.begin() + y * width, pixels.begin() + (y + 1) * width);
          }};
}

/// RGBA of a PNG file.
std::vector<uint8_t> read(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_file(&image, file.c_str())) << image.message;
  image.format = PNG_FORMAT_RGBA;
  std::vector<uint8_t> bytes(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr)) << image.message;
  return bytes;
}

TEST(PngFiles, HaveStraightAlphaOrNone) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  const std::vector<uint32_t> pixels = {0xff0000ff, 0x80004080, 0, 0xffffffff};
  writePng(file, pictureOf(pixels, 2, true));
  EXPECT_EQ(read(file),
            (std::vector<uint8_t>{255, 0, 0, 255, 255, 128, 0, 128, 0, 0, 0, 0, 255, 255, 255, 255}));
  writePng(file, pictureOf(pixels, 4, false));
  EXPECT_EQ(read(file),
            (std::vector<uint8_t>{255, 0, 0, 255, 128, 64, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255}));
}

/// RGBA words of a PNG file, and its bits a channel.
std::vector<uint16_t> readWords(const std::string& file, int& depth) {
  FILE* const in = std::fopen(file.c_str(), "rb");
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, in);
  png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
  depth = png_get_bit_depth(png, info);
  std::vector<uint16_t> words;
  for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y) {
    const auto* const row = reinterpret_cast<const uint16_t*>(png_get_rows(png, info)[y]);
    words.insert(words.end(), row, row + png_get_rowbytes(png, info) / 2);
  }
  EXPECT_TRUE(png_get_valid(png, info, PNG_INFO_sRGB));
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(in);
  return words;
}

TEST(PngFiles, HaveSixteenBits) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  const std::vector<float> pixels = {1, 0, 0.5f, 1, 0.25f, 2, -1, 0.5f};
  PngPicture picture{.width = 1, .height = 2, .alpha = true, .depth = 16};
  picture.wideRow = [&](int y, std::vector<float>& row) {
    row.assign(pixels.begin() + 4 * y, pixels.begin() + 4 * y + 4);
  };
  int depth = 0;
  writePng(file, picture);
  EXPECT_EQ(readWords(file, depth), (std::vector<uint16_t>{65535, 0, 32768, 65535, 32768, 65535, 0, 32768}));
  EXPECT_EQ(depth, 16);
  picture.alpha = false;
  writePng(file, picture);
  EXPECT_EQ(readWords(file, depth), (std::vector<uint16_t>{65535, 0, 32768, 16384, 65535, 0}));
}

TEST(PngFiles, StayWhereNewOnesCannotBeWritten) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.write("picture.png", "old");
  PngPicture picture = pictureOf({1, 2, 3, 4}, 2, false);
  picture.row = [](int y, std::vector<uint32_t>& row) {
    if (y == 1) throw std::runtime_error("a test's failure");
    row.assign(2, 0);
  };
  EXPECT_THROW(writePng(file, picture), std::runtime_error);
  picture.width = 0;
  EXPECT_THROW(writePng(file, picture), std::runtime_error);
  EXPECT_THROW(writePng(folder.file("missing/x.png"), pictureOf({1}, 1, false)), std::runtime_error);
  EXPECT_EQ(gluray::test::textOf(file), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace gluray::launcher
