#include "saved/layers/cryptomatte.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace gluray::saved {
namespace {

std::string hexOf(uint32_t bits) {
  char text[9];
  std::snprintf(text, sizeof text, "%08x", bits);
  return text;
}

}  // namespace

uint32_t murmurHash3(std::string_view bytes) {
  constexpr uint32_t kFirst = 0xcc9e2d51, kSecond = 0x1b873593;
  uint32_t hash = 0;
  const auto mixed = [&](uint32_t block) { return std::rotl(block * kFirst, 15) * kSecond; };
  size_t at = 0;
  for (; at + 4 <= bytes.size(); at += 4) {
    uint32_t block = 0;
    for (size_t i = 0; i < 4; ++i)
      block |= static_cast<uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    hash = std::rotl(hash ^ mixed(block), 13) * 5 + 0xe6546b64;
  }
  uint32_t rest = 0;
  for (size_t i = bytes.size(); i > at; --i) rest = rest << 8 | static_cast<unsigned char>(bytes[i - 1]);
  hash ^= mixed(rest);
  hash ^= static_cast<uint32_t>(bytes.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6b;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35;
  return hash ^ hash >> 16;
}

uint32_t cryptoBits(std::string_view name) {
  const uint32_t hash = murmurHash3(name), exponent = std::clamp(hash >> 23 & 255u, 1u, 254u);
  return (hash & 0x807fffffu) | exponent << 23;
}

float cryptoId(std::string_view name) { return std::bit_cast<float>(cryptoBits(name)); }

std::vector<std::pair<std::string, std::string>> cryptoTexts(const std::string& layer,
                                                             const std::vector<std::string>& names) {
  nlohmann::json manifest = nlohmann::json::object();
  for (const std::string& name : names) manifest[name] = hexOf(cryptoBits(name));
  const std::string key = "cryptomatte/" + hexOf(murmurHash3(layer)).substr(0, 7) + '/';
  return {{key + "name", layer},
          {key + "hash", "MurmurHash3_32"},
          {key + "conversion", "uint32_to_float32"},
          {key + "manifest", manifest.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)}};
}

void CoverageRanks::add(float id, float weight) {
  all_ += weight;
  if (id == 0) return;
  const auto found =
      std::find_if(covers_.begin(), covers_.end(), [&](const auto& cover) { return cover.first == id; });
  if (found == covers_.end())
    covers_.emplace_back(id, weight);
  else
    found->second += weight;
}

void CoverageRanks::write(int count, float* to) {
  // Ids decide where coverages are equal, so that the order does not depend on that of samples.
  std::sort(covers_.begin(), covers_.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  // Weights of filters may be negative.
  float positive = 0;
  for (const auto& cover : covers_) positive += std::max(cover.second, 0.0f);
  const float whole = std::max(all_, positive);
  for (size_t rank = 0; rank < static_cast<size_t>(count); ++rank) {
    const bool known = rank < covers_.size() && covers_[rank].second > 0;
    to[2 * rank] = known ? covers_[rank].first : 0;
    to[2 * rank + 1] = known ? covers_[rank].second / whole : 0;
  }
}

}  // namespace gluray::saved
