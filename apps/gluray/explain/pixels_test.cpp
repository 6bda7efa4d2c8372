#include "explain/pixels.h"

#include "explain/html_page.h"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace gluray::launcher {
namespace {

Pixels filled(int width, int height, uint8_t value, int channels = 3) {
  Pixels pixels{width, height, channels, {}};
  pixels.bytes.assign(pixels.count() * static_cast<size_t>(channels), value);
  return pixels;
}

void set(Pixels& pixels, int x, int y, uint8_t value) {
  const size_t at = static_cast<size_t>(y * pixels.width + x) * static_cast<size_t>(pixels.channels);
  std::fill_n(pixels.bytes.begin() + static_cast<ptrdiff_t>(at), pixels.channels, value);
}

TEST(Pixels, EqualImagesDoNotDiffer) {
  const Pixels a = filled(8, 4, 100), origin = filled(8, 4, 0, 1);
  const Comparison c = compare(a, a, origin);
  EXPECT_TRUE(c.sameSize && c.sameFrame());
  EXPECT_EQ(c.pixels, 32u);
  EXPECT_EQ(c.differingAtAll, 0u);
  EXPECT_EQ(c.outside, 32u);
}

TEST(Pixels, DifferencesAreCountedByTheirSize) {
  Pixels a = filled(20, 20, 100), b = a, origin = filled(20, 20, 0, 1);
  for (int x = 0; x < 6; ++x) set(origin, x, 0, 255);
  set(origin, 0, 0, 128);
  set(b, 1, 0, 108), set(b, 2, 0, 109), set(b, 3, 0, 60);
  const Comparison c = compare(a, b, origin);
  EXPECT_EQ(c.traced, 5u);
  EXPECT_EQ(c.drawnOver, 1u);
  EXPECT_EQ(c.differingAtAll, 3u);
  EXPECT_EQ(c.differing, 2u);
  EXPECT_EQ(c.largest, 40);
  EXPECT_EQ(c.outside, 400u - 3 * 8);  // rows 0 to 2, columns 0 to 7 are near a traced pixel
  EXPECT_EQ(c.outsideDiffering, 0u);
  EXPECT_TRUE(c.sameFrame());
}

TEST(Pixels, UntracedPixelsTellWhetherFramesAreTheSame) {
  Pixels a = filled(20, 20, 100), b = a, origin = filled(20, 20, 0, 1);
  set(b, 15, 15, 200);
  EXPECT_FALSE(compare(a, b, origin).sameFrame());
  EXPECT_FALSE(compare(a, filled(20, 19, 100), origin).sameSize);
  EXPECT_FALSE(compare(a, filled(20, 19, 100), origin).sameFrame());
}

TEST(Pixels, DifferencesAreMadeBrighter) {
  Pixels a = filled(2, 1, 100), b = a;
  set(b, 0, 0, 97), set(b, 1, 0, 0);
  EXPECT_EQ(difference(a, b, 8).bytes, (std::vector<uint8_t>{24, 24, 24, 255, 255, 255}));
}

TEST(Pixels, OriginsAreTinted) {
  Pixels origin = filled(3, 1, 0, 1);
  set(origin, 1, 0, 128), set(origin, 2, 0, 255);
  const Pixels t = tinted(filled(3, 1, 0), origin);
  EXPECT_EQ(t.bytes, (std::vector<uint8_t>{0, 0, 0, 128, 80, 0, 0, 112, 0}));
}

TEST(Pixels, PngHoldsTheImage) {
  Pixels shown = filled(5, 3, 10);
  set(shown, 4, 2, 77);
  const std::string bytes = pngOf(shown);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  std::vector<uint8_t> back(PNG_IMAGE_SIZE(image));
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, back.data(), 0, nullptr));
  EXPECT_EQ(back, shown.bytes);
}

TEST(Pixels, NetpbmFilesAreRead) {
  const std::string path = testing::TempDir() + "/pixels_test" + std::to_string(getpid()) + ".ppm";
  const auto write = [&](const std::string& text) { std::ofstream(path, std::ios::binary) << text; };
  write(std::string("P6\n2 1\n255\n") + "abc\n\n\n");
  const auto shown = readNetpbm(path);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->width, 2);
  EXPECT_EQ(shown->bytes, (std::vector<uint8_t>{'a', 'b', 'c', '\n', '\n', '\n'}));
  write("P6\n2 1\n255\nabc");
  EXPECT_FALSE(readNetpbm(path));
  write("P6\n99999999 99999999\n255\nabc");
  EXPECT_FALSE(readNetpbm(path));
  write("hello");
  EXPECT_FALSE(readNetpbm(path));
  std::filesystem::remove(path);
  EXPECT_FALSE(readNetpbm(path));
}

FrameImages images() {
  FrameImages p;
  p.with = filled(20, 20, 100), p.origin = filled(20, 20, 255, 1), p.frame = p.frameWithout = 7;
  return p;
}

TEST(HtmlPage, HoldsAllImagesAndTheNumbers) {
  FrameImages p = images();
  p.without = filled(20, 20, 110);
  const std::string page = htmlPage("viewer <a> & \"b\"", "table <x>", p);
  for (const char* id : {"with", "without", "difference", "traced"})
    EXPECT_NE(page.find("<img id=\"" + std::string(id) + "\""), page.npos) << id;
  EXPECT_NE(page.find("viewer &lt;a&gt; &amp; &quot;b&quot;"), page.npos);
  EXPECT_NE(page.find("table &lt;x&gt;"), page.npos);
  EXPECT_NE(page.find("<b>100.000 %</b> of the 400 pixels differ by more than 8"), page.npos);
  EXPECT_EQ(page.find("src=\"http"), page.npos);  // self-contained
  const nlohmann::json facts = imageFacts(p);
  EXPECT_EQ(facts["differing"], 400);
  EXPECT_EQ(facts["traced"], 400);
  EXPECT_EQ(facts["largest"], 10);
}

TEST(HtmlPage, SaysIfTheFramesAreNotTheSame) {
  FrameImages p = images();
  p.origin = filled(20, 20, 0, 1);
  p.without = filled(20, 20, 200);
  EXPECT_NE(htmlPage("v", "", p).find("did not show the same frame"), std::string::npos);
  p.without = p.with;
  EXPECT_EQ(htmlPage("v", "", p).find("did not show the same frame"), std::string::npos);
}

TEST(HtmlPage, MayLackTheSecondImage) {
  const std::string page = htmlPage("v", "", images());
  EXPECT_NE(page.find("no image without GLuRay"), page.npos);
  EXPECT_EQ(page.find("<img id=\"difference\""), page.npos);
  EXPECT_FALSE(imageFacts(images()).contains("differing"));
}

}  // namespace
}  // namespace gluray::launcher
