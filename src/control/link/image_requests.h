// Images of the program's windows: the calls `shot` and `pixels`, and the event `thumbnail`. Control
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

/// What is observed of thumbnails.
struct ThumbnailWish {
  static constexpr int kMinSize = 16, kMaxSize = 512, kUsualSize = 256;  // longest side in pixels
  bool on = false;
  int size = kUsualSize;
  double every = 1;
};

class ImageRequests {
 public:
  static constexpr double kPoll = 0.004;      // between two looks while a shot waits
  static constexpr double kLook = 0.05;       // the same for thumbnails
  static constexpr double kKeepSeconds = 10;  // a shot after its last use
  static constexpr double kSettle = 1;  // frames within this time of a request to draw may be its frames
  static constexpr int kMaxDrawRequests =
      3;                                // requests to draw for thumbnails, if only their frames are drawn,
  static constexpr double kRarely = 5;  // and none or those alone come: until the next one
  static constexpr size_t kMaxKept = 4, kMaxWaiting = 16;
  static constexpr int64_t kMaxPixels = 196608;             // of a thumbnail: its message has room
  static constexpr size_t kPieceBytes = size_t{600} << 10;  // of pixels, before base64

  /// `result` has `why` if the request is refused.
  using Answer = std::function<void(const nlohmann::json& id, nlohmann::json result)>;
  using Send = std::function<void(nlohmann::json event)>;
  ImageRequests(ControlledProgram& program, const SettingsSource& source, Waker& waker, Answer answer,
                Send send)
      : program_(program),
        source_(source),
        waker_(waker),
        answer_(std::move(answer)),
        send_(std::move(send)) {}

  /// Whether startCall() carries out the call.
  static bool knows(const std::string& call) { return call == "shot" || call == "pixels"; }
  void startCall(const std::string& call, const nlohmann::json& id, const nlohmann::json& arguments,
                 double now);
  void observe(const ThumbnailWish& wish, double now);
  /// Answers and sends what is due. `slow`: the hub does not read what was sent; thumbnails wait.
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
  double due_ = 0;             // the next thumbnail, not before
  uint64_t shown_ = 0;         // number of the frame in the last thumbnail
  uint64_t asked_ = 0;         // the last frame when the program was asked to draw for a thumbnail
  double askedAt_ = -kSettle;  // when
  int askedInARow_ = 0;        // without frames of its own between
  bool asks_ = false;          // no image has come since
  uint64_t begun_ = 0;         // the last frame when it was looked at last
};

}  // namespace gluray::control
