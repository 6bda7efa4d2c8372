// Reads the current values of a shader program's uniforms one by one. GL thread, context current.
#pragma once
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/glsl/program.h"
#include "gl/real/real.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::gl {

class CurrentUniforms final : public UniformSource {
 public:
  /// `program` must outlive it.
  CurrentUniforms(const RealGl& real, const Program& program, bool core)
      : real_(real), program_(program), core_(core) {}

  /// Location of a value: an active uniform, or built-in state.
  struct Place {
    const ProgramUniform* uniform = nullptr;  // null: built-in state
    int element = 0;
    std::string name;
  };
  /// Components column by column.
  struct Numbers {
    std::array<double, 16> values{};
    size_t count = 0;
    bool operator==(const Numbers&) const = default;
  };
  /// Returns false if there is none of this name.
  bool find(std::string_view name, Place& place) const;
  bool read(const Place& place, Numbers& numbers) const;
  bool read(std::string_view name, std::vector<double>& components) const override;

 private:
  bool readBuiltIn(std::string_view name, Numbers& numbers) const;

  const RealGl& real_;
  const Program& program_;
  const bool core_;
};

}  // namespace gluray::gl
