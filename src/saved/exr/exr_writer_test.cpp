// OpenEXR files, as OpenEXR's own library reads them.
#include "saved/exr/exr_writer.h"

#include "base/testing/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#ifdef GLURAY_OPENEXR
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

namespace gluray::saved {
namespace {

/// Values that say where they are.
float valueOf(int x, int y, size_t channel) {
  return static_cast<float>(1000 * y + x) + 0.25f * static_cast<float>(channel);
}

ExrPicture numbered(int width, int height, std::vector<ExrChannel> channels) {
  ExrPicture picture{.width = width, .height = height, .channels = std::move(channels)};
  const size_t count = picture.channels.size();
  picture.row = [=](int y, float* values) {
    for (int x = 0; x < width; ++x)
      for (size_t c = 0; c < count; ++c) *values++ = valueOf(x, y, c);
  };
  return picture;
}

TEST(ExrFiles, HaveAllChannelsOfAllRows) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.file("picture.exr");
  constexpr int kWidth = 7, kHeight = 1100;  // more than are compressed together
  ExrPicture picture = numbered(kWidth, kHeight, {{"R", true}, {"depth.Z", false}});
  picture.texts = {{"Command", "gluray render"}, {"cryptomatte/0123456/manifest", "{}"}};
  writeExr(file, picture);
  Imf::InputFile in(file.c_str());
  EXPECT_EQ(in.header().channels().findChannel("R")->type, Imf::HALF);
  EXPECT_EQ(in.header().channels().findChannel("depth.Z")->type, Imf::FLOAT);
  EXPECT_EQ(in.header().findTypedAttribute<Imf::StringAttribute>("Command")->value(), "gluray render");
  EXPECT_TRUE(in.header().findTypedAttribute<Imf::StringAttribute>("cryptomatte/0123456/manifest"));
  ASSERT_TRUE(Imf::hasChromaticities(in.header()));
  EXPECT_FLOAT_EQ(Imf::chromaticities(in.header()).red.x, 0.64f);
  EXPECT_FALSE(Imf::hasOwner(in.header()));
  std::vector<float> red(kWidth * kHeight), depth(red.size());
  Imf::FrameBuffer buffer;
  buffer.insert("R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(red.data()), 4, 4 * kWidth));
  buffer.insert("depth.Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(depth.data()), 4, 4 * kWidth));
  in.setFrameBuffer(buffer);
  in.readPixels(0, kHeight - 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto at = static_cast<size_t>(y * kWidth + x);
      ASSERT_EQ(red[at], float(::half(valueOf(x, y, 0)))) << x << " " << y;
      ASSERT_EQ(depth[at], valueOf(x, y, 1)) << x << " " << y;
    }
}

TEST(ExrFiles, StayWhereNewOnesCannotBeWritten) {
  const gluray::test::TemporaryFolder folder;
  const std::string file = folder.write("picture.exr", "old");
  ExrPicture picture = numbered(4, 40, {{"R", false}});
  picture.row = [](int y, float*) {
    if (y == 20) throw std::runtime_error("a test's failure");
  };
  EXPECT_THROW(writeExr(file, picture), std::runtime_error);
  EXPECT_THROW(writeExr(file, numbered(0, 4, {{"R", false}})), std::runtime_error);
  EXPECT_THROW(writeExr(folder.file("missing/x.exr"), numbered(4, 4, {{"R", false}})), std::runtime_error);
  EXPECT_EQ(gluray::test::textOf(file), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace gluray::saved
#endif
