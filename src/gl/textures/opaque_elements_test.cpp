#include "gl/sharing/share_group.h"
#include "gl/textures/texture_cache.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace gluray::gl {
namespace {

/// Two surfaces have their colours in one buffer.
TEST(OpaqueElements, AreThoseThatAreAskedFor) {
  const auto colors = std::make_shared<std::array<uint32_t, 4>>(
      std::array<uint32_t, 4>{0xff0000ffu, 0xff00ff00u, 0x80ff0000u, 0xffffffffu});
  const auto from = [&](size_t first) {
    return scene::Attribute{colors, reinterpret_cast<const std::byte*>(colors->data() + first), 4,
                            scene::Format::unorm8x4};
  };
  ShareGroup group;
  TextureCache cache(group);
  EXPECT_TRUE(cache.isOpaque(from(0), 2));
  EXPECT_FALSE(cache.isOpaque(from(0), 3));
  EXPECT_FALSE(cache.isOpaque(from(2), 2));
  EXPECT_TRUE(cache.isOpaque(from(3), 1));
  EXPECT_TRUE(cache.isOpaque(from(0), 2));
}

}  // namespace
}  // namespace gluray::gl
