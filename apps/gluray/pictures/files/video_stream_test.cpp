// Films for encoders, and what pictures say of how they were made.
#include "pictures/files/video_stream.h"

#include "base/testing/temporary_folder.h"
#include "pictures/files/png_writer.h"
#include "pictures/picture_texts.h"
#include "shell_word.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gluray::launcher {
namespace {

TEST(FrameRates, AreFractions) {
  const auto read = [](const std::string& text) {
    FrameRate rate{0, 0};
    return readFrameRate(text, rate).empty()
               ? std::to_string(rate.number) + ':' + std::to_string(rate.divisor)
               : std::string("wrong");
  };
  EXPECT_EQ(read("25"), "25:1");
  EXPECT_EQ(read("12.5"), "25:2");
  EXPECT_EQ(read("23.976"), "2997:125");
  EXPECT_EQ(read("24000/1001"), "24000:1001");
  for (const char* wrong : {"", "0", "-5", "x", "25x", "5/0", "5/", "1001", "25.9999", "99999999999"})
    EXPECT_EQ(read(wrong), "wrong") << wrong;
}

std::vector<int> bytesOfFrame(const std::vector<uint32_t>& pixels, int width, int height) {
  std::string text;
  addVideoFrame(pixels, width, height, text);
  EXPECT_TRUE(text.starts_with("FRAME\n"));
  std::vector<int> bytes;
  for (const char byte : text.substr(6)) bytes.push_back(static_cast<uint8_t>(byte));
  return bytes;
}

TEST(VideoFrames, HaveTheColoursOfBt709) {
  // White, black, and BT.709's values of the primaries in 8 bits.
  const std::vector<uint32_t> white(4, 0xffffffff), black(4, 0xff000000), red(4, 0xff0000ff),
      green(4, 0xff00ff00), blue(4, 0xffff0000);
  const auto with = [](int y, int u, int v) { return std::vector<int>{y, y, y, y, u, v}; };
  EXPECT_EQ(bytesOfFrame(white, 2, 2), with(235, 128, 128));
  EXPECT_EQ(bytesOfFrame(black, 2, 2), with(16, 128, 128));
  EXPECT_EQ(bytesOfFrame(red, 2, 2), with(63, 102, 240));
  EXPECT_EQ(bytesOfFrame(green, 2, 2), with(173, 42, 26));
  EXPECT_EQ(bytesOfFrame(blue, 2, 2), with(32, 240, 118));
}

TEST(VideoFrames, RepeatTheLastColumnAndRow) {
  const std::vector<uint32_t> pixels = {0xff000000, 0xff000000, 0xffffffff, 0xff000000, 0xff000000,
                                        0xffffffff, 0xffffffff, 0xffffffff, 0xff000000};
  const std::vector<int> wanted = {16,  16,  235, 235, 16,  16,  235, 235, 235, 235, 16,  16,
                                   235, 235, 16,  16,  128, 128, 128, 128, 128, 128, 128, 128};
  EXPECT_EQ(bytesOfFrame(pixels, 3, 3), wanted);
}

TEST(PictureTexts, AreReadBack) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.file("a.png"), command = "gluray render 'ü x' a.png";
  writePng(file, {.width = 1,
                  .height = 1,
                  .texts = {{"Software", "x"}, {"Command", command}},
                  .row = [](int, std::vector<uint32_t>& row) { row.assign(1, 0); }});
  EXPECT_EQ(textsOf(file).at("Command"), command);
  EXPECT_EQ(textsOf(file).at("Software"), "x");
  EXPECT_THROW(textsOf(folder.write("b.png", "no PNG")), std::runtime_error);
  EXPECT_THROW(textsOf(folder.file("missing.png")), std::runtime_error);
  const std::string whole = gluray::test::textOf(file);
  for (size_t size = 8; size < whole.size(); size += 7) textsOf(folder.write("c.png", whole.substr(0, size)));
}

TEST(PictureTexts, HaveWordsWithoutAShell) {
  for (const std::string word :
       {"plain", "two words", "it's", "$(rm -rf x)", "a\nb", "ü", "`x`", "\\", ";"}) {
    const auto words = wordsOf("gluray " + shellWord(word) + " x");
    ASSERT_TRUE(words);
    EXPECT_EQ(*words, (std::vector<std::string>{"gluray", word, "x"}));
  }
  for (const char* wrong :
       {"a; b", "a && b", "a | b", "$(x)", "`x`", "a > b", "'a", "a\nb", "\"a\"", "a*", "~", "#"})
    EXPECT_FALSE(wordsOf(wrong)) << wrong;
}

}  // namespace
}  // namespace gluray::launcher
