// Cryptomatte: hashes against the values that the specification's own tests have, and ranks of coverage.
#include "saved/layers/cryptomatte.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace gluray::saved {
namespace {

TEST(Cryptomatte, HashesNamesAsItsSpecification) {
  // nuke/cryptomatte_utilities_tests.py of the specification's repository.
  EXPECT_EQ(cryptoId("hello"), 6.0705627102400005616e-17f);
  EXPECT_EQ(cryptoId("cube"), -4.08461912519e+15f);
  EXPECT_EQ(cryptoId("sphere"), 2.79018604383e+15f);
  EXPECT_EQ(cryptoId("plane"), 3.66557617593e-11f);
  EXPECT_EQ(cryptoId("\xd1\x80\xd0\xb0\xd0\xb2\xd0\xbd\xd0\xb8\xd0\xbd\xd0\xb0"),
            -1.3192631212399999468e-25f);
  EXPECT_EQ(cryptoId("m\xc3\xa4"
                     "dchen"),
            6.2361298211599995797e+25f);
}

TEST(Cryptomatte, HashesBytesAsMurmurHash3) {
  // Published values of MurmurHash3_x86_32 with seed 0.
  EXPECT_EQ(murmurHash3(""), 0u);
  EXPECT_EQ(murmurHash3("test"), 0xba6bd213u);
  EXPECT_EQ(murmurHash3("Hello, world!"), 0xc0363e43u);
  EXPECT_EQ(murmurHash3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreNormalFloats) {
  for (int i = 0; i < 100000; ++i) ASSERT_TRUE(std::isnormal(cryptoId("object " + std::to_string(i)))) << i;
  EXPECT_EQ(cryptoBits(""), 1u << 23) << "an exponent of 0 becomes 1";
}

TEST(Cryptomatte, HeadersNameTheirSurfaces) {
  const auto texts = cryptoTexts("CryptoObject", {"bunny", "default", "b\"c"});
  ASSERT_EQ(texts.size(), 4u);
  char key[9];
  std::snprintf(key, sizeof key, "%08x", murmurHash3("CryptoObject"));
  EXPECT_EQ(texts[0].first, "cryptomatte/" + std::string(key).substr(0, 7) + "/name");
  EXPECT_EQ(texts[0].second, "CryptoObject");
  EXPECT_EQ(texts[1].second, "MurmurHash3_32");
  EXPECT_EQ(texts[2].second, "uint32_to_float32");
  const auto manifest = nlohmann::json::parse(texts[3].second);
  // The specification's example.
  EXPECT_EQ(manifest["bunny"], "13851a76");
  EXPECT_EQ(manifest["default"], "42c9679f");
  EXPECT_EQ(manifest.size(), 3u);
}

TEST(CoverageRanks, AreSharesOfAllSamples) {
  CoverageRanks ranks;
  ranks.add(3, 1), ranks.add(0, 1), ranks.add(5, 1), ranks.add(5, 1);
  std::array<float, 6> pairs{};
  ranks.write(3, pairs.data());
  EXPECT_EQ(pairs, (std::array<float, 6>{5, 0.5f, 3, 0.25f, 0, 0}));
  ranks.write(1, pairs.data());
  EXPECT_EQ(pairs[1], 0.5f);
  ranks.clear();
  ranks.write(3, pairs.data());
  EXPECT_EQ(pairs, (std::array<float, 6>{}));
}

TEST(CoverageRanks, AreNoMoreThanOneInAll) {
  CoverageRanks ranks;  // weights of a filter that overshoots
  ranks.add(2, 1), ranks.add(3, 1), ranks.add(4, -0.5f), ranks.add(0, -0.25f);
  std::array<float, 6> pairs{};
  ranks.write(3, pairs.data());
  EXPECT_EQ(pairs, (std::array<float, 6>{2, 0.5f, 3, 0.5f, 0, 0}));
}

}  // namespace
}  // namespace gluray::saved
