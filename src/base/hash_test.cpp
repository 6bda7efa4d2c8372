#include "base/hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace gluray {
namespace {

TEST(HashStream, EqualsTheHashOfAllBytes) {
  std::vector<unsigned char> bytes(100'000);
  std::iota(bytes.begin(), bytes.end(), static_cast<unsigned char>(1));
  HashStream stream;
  for (const size_t piece : {1, 12, 768, 4096, 100'000}) {
    for (size_t first = 0; first < bytes.size(); first += piece)
      stream.add(bytes.data() + first, std::min(piece, bytes.size() - first));
    EXPECT_EQ(stream.finishHash(), hashBytes(bytes.data(), bytes.size())) << piece;
  }
  EXPECT_EQ(stream.finishHash(), hashBytes(nullptr, 0));
}

}  // namespace
}  // namespace gluray
