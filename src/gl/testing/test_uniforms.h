// Values of uniforms for tests of shader interpretation.
#pragma once
#include "gl/culled/shader_slice/position_slice.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl::test {

class FakeUniforms final : public UniformSource {
 public:
  std::map<std::string, std::vector<double>, std::less<>> values;
  bool read(std::string_view name, std::vector<double>& components) const override {
    const auto found = values.find(name);
    if (found == values.end()) return false;
    components = found->second;
    return true;
  }
  void set(const std::string& name, const glm::dmat4& m) {
    values[name].assign(glm::value_ptr(m), glm::value_ptr(m) + 16);
  }
};

}  // namespace gluray::gl::test
