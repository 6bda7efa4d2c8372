// Maps of colours that shader programs compute in functions, as tables. A part of VolumeDraws, GL thread.
#pragma once
#include "gl/programs/program_functions.h"
#include "gl/programs/uniforms.h"
#include "gl/shadow/shadow_state.h"
#include "scene/volumes/transfer_function.h"

#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

class VolumeMaps {
 public:
  /// Sets `table` to what the function returns for numbers from 0 to 1, as four channels, the first and the
  /// last entry at the ends. Keeps the tables of functions whose textures have not changed. False, with the
  /// reason in `why`, if the function cannot be evaluated.
  bool read(ShadowState& shadow, const UniformReader& uniforms, const NamedFunction& function,
            scene::VolumeTable& table, std::string& why);

 private:
  /// A texture that the function reads.
  struct Sampled {
    std::string sampler;
    scene::Texture texture;
  };
  struct Known {
    std::weak_ptr<const glsl::ShaderFunctions> shader;
    std::string name;
    std::vector<Sampled> textures;
    scene::VolumeTable table;
  };
  static bool isCurrent(ShadowState& shadow, const UniformReader& uniforms, const Known& known);

  std::vector<Known> known_;
};

}  // namespace gluray::gl
