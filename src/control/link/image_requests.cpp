#include "control/link/image_requests.h"

#include "control/messages/base64.h"
#include "control/messages/members.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gluray::control {

using nlohmann::json;

void ImageRequests::startCall(const std::string& call, const json& id, const json& arguments, double now) {
  if (call == "pixels") return answer_(id, piece(arguments, now));
  for (const char* name : {"width", "height"})
    if (arguments.contains(name))
      return answer_(id, {{"why", std::string(name) + ": a shot has the size of its window; leave it out"}});
  if (waiting_.size() >= kMaxWaiting) return answer_(id, {{"why", "too many shots wait for a frame"}});
  shoot(id, now);
}

void ImageRequests::shoot(const json& id, double now) {
  collect(/*slow=*/true, now);  // images kept before this request do not answer it
  waiting_.push_back({id, FrameWait(source_, now)});
}

/// Rows of a kept shot as JSON.
json ImageRequests::piece(const json& arguments, double now) {
  const auto number = wholeNumber(member(arguments, "shot"), 0, kMaxFrame);
  const auto kept = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    return number && k.number == static_cast<uint64_t>(*number);
  });
  if (kept == kept_.end()) return {{"why", "this shot is not kept any more; take another"}};
  const RgbImage& image = kept->image;
  const auto asked = wholeNumber(member(arguments, "row"), 0, image.height - 1);
  if (!asked) return {{"why", "row: use a number from 0 to " + std::to_string(image.height - 1)}};
  kept->until = now + kKeepSeconds;
  const auto row = static_cast<size_t>(*asked);
  const size_t rowBytes = 3 * static_cast<size_t>(image.width);
  const size_t rows =
      std::min(std::max<size_t>(kPieceBytes / rowBytes, 1), static_cast<size_t>(image.height) - row);
  const std::string_view bytes(image.bytes);
  return {
      {"value",
       {{"row", row}, {"rows", rows}, {"pixels", toBase64(bytes.substr(row * rowBytes, rows * rowBytes))}}}};
}

void ImageRequests::observe(const ThumbnailWish& wish, double now) {
  wish_ = wish;
  due_ = now;
  shown_ = asked_ = 0;  // the first thumbnail is always sent
  askedInARow_ = 0, asks_ = false;
}

void ImageRequests::passed(bool slow, double now) {
  collect(slow, now);
  std::erase_if(waiting_, [&](const Waiting& waiting) {
    if (!waiting.wait.isOver(now)) return false;
    answer_(waiting.id,
            {{"why", "its windows have shown no frame for 8 seconds; draw in one, and try again"}});
    return true;
  });
  std::erase_if(kept_, [&](const Kept& kept) { return now >= kept.until; });
  wakeIfDue(slow, now);
  const bool thumbnail = wish_.on && !slow && now >= due_;
  program_.wantImage(waker_.widens()                             ? Wanted::none
                     : !waiting_.empty() || (thumbnail && asks_) ? Wanted::next
                     : thumbnail                                 ? Wanted::any
                                                                 : Wanted::none);
}

/// Passes the image that the program has kept to the requests that wait for it.
void ImageRequests::collect(bool slow, double now) {
  const std::unique_ptr<KeptImage> image = program_.takeImage();
  if (!image) return;
  if (image->next && !waiting_.empty()) {
    if (kept_.size() >= kMaxKept) kept_.pop_front();
    kept_.push_back({++shots_, rgbOf(*image), now + kKeepSeconds});
    const RgbImage& shot = kept_.back().image;
    const json value{{"shot", shots_},
                     {"width", shot.width},
                     {"height", shot.height},
                     {"frame", image->frame != 0 ? json(image->frame) : json()}};
    for (const Waiting& waiting : std::exchange(waiting_, {})) answer_(waiting.id, {{"value", value}});
  }
  if (wish_.on && !slow && now >= due_) sendThumbnail(*image, now);
}

void ImageRequests::sendThumbnail(const KeptImage& image, double now) {
  const RgbImage small = scaledDown(image, wish_.size, kMaxPixels);
  due_ = now + wish_.every;
  shown_ = image.frame;
  asks_ = false;
  if (small.width > 0)
    send_({{"type", "event"},
           {"what", "thumbnail"},
           {"width", small.width},
           {"height", small.height},
           {"pixels", toBase64(small.bytes)}});
}

/// Whether the program has shown a frame after that of the last thumbnail, and then became idle.
bool ImageRequests::missesFrames(double now) {
  const SettingsSource::Begun begun = source_.begun();
  if (std::exchange(begun_, begun.frame) != begun.frame && now - askedAt_ > kSettle) askedInARow_ = 0;
  const bool asksSoon = begun.frame != asked_ && askedInARow_ < kMaxDrawRequests;
  return begun.frame != shown_ && (asksSoon || now - askedAt_ >= kRarely) &&
         now - begun.active >= FrameWait::kQuiet;
}

void ImageRequests::wakeIfDue(bool slow, double now) {
  bool wake = false;
  for (Waiting& waiting : waiting_) wake |= waiting.wait.wakes(now);
  if (wish_.on && !slow && now >= due_ && missesFrames(now)) {
    wake = asks_ = true;
    asked_ = begun_, askedAt_ = now, ++askedInARow_;
  }
  if (wake) waker_.wake();
}

double ImageRequests::nextDue(double now) const {
  double next = std::numeric_limits<double>::infinity();
  if (!waiting_.empty()) next = now + kPoll;
  if (wish_.on) next = std::min(next, std::max(due_, now + kLook));
  for (const Kept& kept : kept_) next = std::min(next, kept.until);
  return next;
}

}  // namespace gluray::control
