// What a program tells the hub about itself and what the hub may ask of it: implemented by the engine, and by
// a fake one in tests. All calls on the control thread, which may have a descriptor table of its own; call()
// on a thread with that of the process (control/link/apart.h).
#pragma once
#include "control/link/program/kept_image.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace gluray::control {

/// Counts since the process began.
struct Figures {
  uint64_t triangles = 0;               // traced
  uint64_t traced = 0, rasterised = 0;  // draws
  uint64_t scene = 0;  // draws of its scenes: those that were traced, or left out because scenes are small
};

/// Which shown frame is to be kept as an image.
enum class Wanted {
  none,
  any,  // the next one that is shown, whenever the program ended it
  next  // the next one that the program ends; it is not delayed
};

enum class Called : uint8_t {
  done,
  later  // a frame must be drawn first: call again then
};

class ControlledProgram {
 public:
  virtual ~ControlledProgram() = default;
  /// The members of hello: pid, host, name, rank, ranks, job.
  virtual nlohmann::json identity() = 0;
  virtual Figures figures() = 0;
  /// The members of `state` that figures() does not give.
  virtual nlohmann::json state() = 0;
  /// Carries out a call: gives its value, or in `why` one line that says why it is not carried out.
  virtual Called call(const std::string& name, const nlohmann::json& arguments, nlohmann::json& value,
                      std::string& why) = 0;
  /// Makes the program draw, if that is possible.
  virtual void wake() noexcept = 0;
  /// For programs that then show again what they drew: tells them that their windows are one pixel wider, or
  /// as wide as they are.
  virtual void tellSize(bool /*wider*/) noexcept {}
  /// Keeps such a frame, once; the newest wish counts.
  virtual void wantImage(Wanted /*wanted*/) noexcept {}
  /// The image that was kept since the last call; null: none was.
  virtual std::unique_ptr<KeptImage> takeImage() noexcept { return nullptr; }
  /// The hub has said hello. `here`: it runs on this machine, and its runtime directory is used.
  virtual void linkBegan(bool /*here*/) noexcept {}
  /// The connection to the hub has ended: lets go of what is needed only for that.
  virtual void linkEnded() noexcept {}
};

}  // namespace gluray::control
