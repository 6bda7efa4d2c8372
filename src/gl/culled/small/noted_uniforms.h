// Records the uniforms that an interpretation of a shader has read, with their values. While the values stay
// equal, the result stays valid. GL thread, context current.
#pragma once
#include "gl/culled/small/current_uniforms.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray::gl {

/// A uniform that an interpretation has read.
struct ReadUniform {
  CurrentUniforms::Place place;
  CurrentUniforms::Numbers numbers;
};

/// Whether all have unchanged values.
inline bool haveSameValues(const std::vector<ReadUniform>& all, const CurrentUniforms& uniforms) {
  return std::ranges::all_of(all, [&](const ReadUniform& was) {
    CurrentUniforms::Numbers now;
    return uniforms.read(was.place, now) && now == was.numbers;
  });
}

/// Records the uniforms that are read.
class NotingUniforms : public UniformSource {
 public:
  NotingUniforms(const CurrentUniforms& uniforms, std::vector<ReadUniform>& noted)
      : uniforms_(uniforms), noted_(noted) {}
  bool read(std::string_view name, std::vector<double>& components) const override {
    ReadUniform read;
    if (!uniforms_.find(name, read.place) || !uniforms_.read(read.place, read.numbers)) return false;
    components.assign(read.numbers.values.begin(),
                      read.numbers.values.begin() + static_cast<std::ptrdiff_t>(read.numbers.count));
    noted_.push_back(std::move(read));
    return true;
  }

 private:
  const CurrentUniforms& uniforms_;
  std::vector<ReadUniform>& noted_;
};

}  // namespace gluray::gl
