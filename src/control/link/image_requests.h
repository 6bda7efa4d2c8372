// Images of the program's windows, for the calls `shot` and `pixels` and the event `thumbnail`. Control
// thread; times in seconds.
#pragma once
#include "control/link/program/controlled_program.h"
#include "control/link/program/frame_wait.h"
#include "control/link/program/waker.h"
#include "settings/live/settings_source.h"

#include <nlohmann/json.hpp>

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace gluray::control {

/// The hub's subscription to thumbnails.
struct ThumbnailWish {
  static constexpr int kMinSize = 16, kMaxSize = 512, kUsualSize = 256;  // longest side in pixels
  bool on = false;
  int size = kUsualSize;
  double every = 1;
};

class ImageRequests {
 public:
  static constexpr double kPoll = 0.004;      // interval of checks while a shot waits
  static constexpr double kLook = 0.05;       // interval of checks for thumbnails
  static constexpr double kKeepSeconds = 10;  // how long a shot is kept after its last use
  static constexpr double kSettle = 1;        // frames this soon after a request to draw may be its frames
  static constexpr int kMaxDrawRequests =
      3;                                // consecutive requests to draw for thumbnails if no other frames come
  static constexpr double kRarely = 5;  // seconds to the next one after these, or after one in vain
  static constexpr size_t kMaxKept = 4, kMaxWaiting = 16;
  static constexpr int64_t kMaxPixels = 196608;             // of a thumbnail, so that it fits a message
  static constexpr size_t kPieceBytes = size_t{600} << 10;  // of a part of a shot, before base64

  /// Receives the result; it has `why` if the request is refused.
  using Answer = std::function<void(const nlohmann::json& id, nlohmann::json result)>;
  using Send = std::function<void(nlohmann::json event)>;
  ImageRequests(ControlledProgram& program, const SettingsSource& source, Waker& waker, Answer answer,
                Send send)
      : program_(program),
        source_(source),
        waker_(waker),
        answer_(std::move(answer)),
        send_(std::move(send)) {}

  /// Whether startCall() handles the call.
  static bool knows(const std::string& call) { return call == "shot" || call == "pixels"; }
  void startCall(const std::string& call, const nlohmann::json& id, const nlohmann::json& arguments,
                 double now);
  void observe(const ThumbnailWish& wish, double now);
  /// Answers requests and sends thumbnails that are due. `slow`: the hub does not read what was sent;
  /// thumbnails wait.
  void passed(bool slow, double now);
  double nextDue(double now) const;

 private:
  struct Waiting {
    nlohmann::json id;
    FrameWait wait;
  };
  struct Kept {
    uint64_t number;
    RgbImage image;
    double until;
  };
  void shoot(const nlohmann::json& id, double now);
  nlohmann::json piece(const nlohmann::json& arguments, double now);
  void collect(bool slow, double now);
  void sendThumbnail(const KeptImage& image, double now);
  void wakeIfDue(bool slow, double now);
  bool missesFrames(double now);

  ControlledProgram& program_;
  const SettingsSource& source_;
  Waker& waker_;
  const Answer answer_;
  const Send send_;
  std::vector<Waiting> waiting_;
  std::deque<Kept> kept_;
  uint64_t shots_ = 0;
  ThumbnailWish wish_;
  double due_ = 0;             // earliest time of the next thumbnail
  uint64_t shown_ = 0;         // number of the frame in the last thumbnail
  uint64_t asked_ = 0;         // the current frame at the last request to draw a thumbnail
  double askedAt_ = -kSettle;  // time of that request
  int askedInARow_ = 0;        // requests without frames of the program's own in between
  bool asks_ = false;          // no image has come since that request
  uint64_t begun_ = 0;         // the current frame at the last check
};

}  // namespace gluray::control
