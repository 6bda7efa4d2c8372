// Queries and requests of the hub to a program. Implemented by the engine, and by a fake in tests. All
// calls on the control thread, which may have its own descriptor table, except call(), which is on a thread
// with the process's table (control/link/apart.h).
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
  uint64_t scene = 0;                   // draws of its scenes: traced, or not traced because scenes are small
};

/// Which shown frame to keep as an image.
enum class Wanted {
  none,
  any,  // the next one that is shown, even if the program ended it earlier
  next  // the next one that the program ends; its display is not delayed
};

enum class Called : uint8_t {
  done,
  later  // a frame must be drawn first: call again after that
};

class ControlledProgram {
 public:
  virtual ~ControlledProgram() = default;
  /// The members of hello: pid, host, name, rank, ranks, job.
  virtual nlohmann::json identity() = 0;
  virtual Figures figures() = 0;
  /// The members of `state` that figures() does not provide.
  virtual nlohmann::json state() = 0;
  /// Carries out a call. Returns its value in `value`, or a one-line error message in `why`.
  virtual Called call(const std::string& name, const nlohmann::json& arguments, nlohmann::json& value,
                      std::string& why) = 0;
  /// Makes the program draw, if that is possible.
  virtual void wake() noexcept = 0;
  /// Tells the program that its windows are one pixel wider or, if not `wider`, their own size. For programs
  /// that show only a cached image when exposed.
  virtual void tellSize(bool /*wider*/) noexcept {}
  /// Keeps the image of such a frame, once. The last request counts.
  virtual void wantImage(Wanted /*wanted*/) noexcept {}
  /// The image that was kept since the last call; null if there is none.
  virtual std::unique_ptr<KeptImage> takeImage() noexcept { return nullptr; }
  /// Reports that the hub has sent its hello. `here`: it runs on this machine, and its runtime directory is
  /// used.
  virtual void linkBegan(bool /*here*/) noexcept {}
  /// Reports that the connection to the hub has ended: releases what only the link needed.
  virtual void linkEnded() noexcept {}
};

}  // namespace gluray::control
