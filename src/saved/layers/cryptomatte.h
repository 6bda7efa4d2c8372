// Names of surfaces as pixels: Cryptomatte specification 1.1 (J. Friedman and A. C. Jones, Psyop,
// https://github.com/Psyop/Cryptomatte). Any thread.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::saved {

/// MurmurHash3_x86_32 with seed 0 (A. Appleby, public domain).
uint32_t murmurHash3(std::string_view bytes);
/// The hash of a name as the bits of a float that is finite and normal.
uint32_t cryptoBits(std::string_view name);
/// The same as the value of pixels.
float cryptoId(std::string_view name);

/// The attributes of a layer of this name ("CryptoObject"), for a file's header: names of surfaces and their
/// hashes, with the hash and its conversion.
std::vector<std::pair<std::string, std::string>> cryptoTexts(const std::string& layer,
                                                             const std::vector<std::string>& names);

/// How much of a pixel each surface covers.
class CoverageRanks {
 public:
  void clear() { covers_.clear(), all_ = 0; }
  /// A sample of the pixel, with the weight of the pixel filter. `id` 0: no surface.
  void add(float id, float weight);
  /// Writes `count` pairs of id and coverage, the largest first; 0 where there are no more. Coverages are at
  /// least 0, and their sum is at most 1.
  void write(int count, float* to);

 private:
  std::vector<std::pair<float, float>> covers_;  // id, sum of weights
  float all_ = 0;                                // of weights
};

}  // namespace gluray::saved
