// Settings that vary over a film, and get back what they had when it ends.
#pragma once
#include "control/images/film_plan.h"
#include "control/one_program.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::launcher {

class FilmSettings {
 public:
  /// Remembers what the settings are. Throws.
  FilmSettings(HubSession& hub, const RunningProgram& program, std::vector<Ramp> ramps);

  /// Whether they vary, and have the same values in this image as in the one before.
  bool same(int image, int of) const;
  /// Gives them the values of this image. Returns the first frame with them; nothing: not known. Throws.
  std::optional<int64_t> set(int image, int of);
  /// Gives them what they had. All changes are one step for undo. Throws.
  void giveBack();

 private:
  nlohmann::json values(int image, int of) const;
  std::optional<int64_t> send(const nlohmann::json& values);

  HubSession& hub_;
  const RunningProgram& program_;
  const std::vector<Ramp> ramps_;
  const std::string gesture_;
  nlohmann::json before_ = nlohmann::json::object();
  bool changed_ = false;
};

}  // namespace gluray::launcher
