#include "cluster/program/worker_link.h"

#include "base/clock.h"
#include "cluster/messages/version.h"
#include "scene/box_corner.h"
#include "scene/effects.h"
#include "scene/secondary_scene.h"

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kFirstWelcomeMs = 2000, kWelcomeMs = 20;
constexpr int kSendMs = 5000;
constexpr double kTryAgain = 1, kSilence = 1.5, kWelcomePatience = 5;  // seconds

/// Whether light is smoothed across tiles, with what is known of earlier frames.
bool isMoving(const scene::Snapshot& snapshot) {
  return snapshot.lightSampling.mode == scene::LightSampling::Mode::moving &&
         scene::wantsLight(snapshot.settings);
}

/// Whether light falls on the image that surfaces of other ranks may block.
bool fallsOnSurfaces(const scene::Snapshot& snapshot) {
  using Mode = scene::LightSampling::Mode;
  const Mode mode = snapshot.lightSampling.mode;
  return (mode == Mode::full || mode == Mode::moving) &&
         (scene::wantsOcclusion(snapshot.settings) || scene::wantsShadows(snapshot.settings));
}

bool hasBlended(const scene::Snapshot& snapshot) {
  return snapshot.layers || snapshot.catches ||
         (snapshot.secondaryScene && !snapshot.secondaryScene->captures.empty()) ||
         (snapshot.secondaryScene &&
          std::ranges::any_of(snapshot.secondaryScene->blended, [](uint8_t b) { return b; }));
}

/// Whether the parts of other ranks belong to the image. Without light, parts are as good.
bool isGathering(const scene::Snapshot& snapshot) {
  const Settings& settings = snapshot.settings;
  return settings.gather && (scene::needsSecondaryScene(settings) || scene::wantsBackdrop(settings));
}

/// Encloses the surfaces, in eye space.
void setBox(PartView& view, const scene::Snapshot& s) {
  glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper(-lower);
  for (const scene::Instance& instance : s.instances) {
    if (instance.ground) continue;
    for (int i = 0; i < 8; ++i) {
      const glm::vec3 corner = scene::boxCorner(instance.mesh->lower, instance.mesh->upper, i);
      const glm::dvec3 eye = instance.eyeFromObject * glm::dvec4(corner, 1);
      lower = glm::min(lower, eye), upper = glm::max(upper, eye);
    }
  }
  if (lower.x <= upper.x) view.lower = lower, view.upper = upper;
}

PartView partViewOf(const scene::Snapshot& s) {
  WriteMessage all;
  all(s.camera.depthNear, s.camera.depthFar, s.camera.rowsFromTop, s.region, s.samples, s.samplePositions,
      s.polygonOffset, s.depthSteps, s.wideColors, s.encodes, s.colorWrites, s.laterWins,
      s.camera.largestWins);
  const std::vector<std::byte> bytes = all.out().takeBytes();
  PartView view;
  view.frame = s.frame, view.viewport = s.camera.viewport;
  view.clipFromEye = s.camera.clipFromEye, view.eyeFromWorld = s.eyeFromWorld;
  setBox(view, s);
  view.likeness = hashBytes(bytes.data(), bytes.size());
  view.blends = hasBlended(s);
  return view;
}

}  // namespace

WorkerLink::WorkerLink(std::string directory, std::string job, MpiPlace place)
    : directory_(std::move(directory)), job_(std::move(job)), place_(std::move(place)) {}

template <class M>
bool WorkerLink::send(const M& message, int attached) {
  return line_->send(M::kType, encoded(message), attached, kSendMs);
}

void WorkerLink::disconnect(std::string why, double now) {
  line_.reset();
  welcome_ = false;
  sent_.clear();
  memory_.reset();
  why_ = std::move(why);
  isAway_ = false;
  nextTry_ = now + kTryAgain;
}

void WorkerLink::lose(std::string why, double now) {
  disconnect(std::move(why), now);
  isAway_ = true;
}

bool WorkerLink::isReady(double now) {
  if (!line_ && (now < nextTry_ || !connect(now))) return false;
  if (!welcome_) greet(everTried_ ? kWelcomeMs : kFirstWelcomeMs, now);
  everTried_ = true;
  return welcome_;
}

bool WorkerLink::connect(double now) {
  nextTry_ = now + kTryAgain;
  if (std::optional<Line> line = lineToWorker(directory_, job_, place_.onMachine, why_, &isAway_))
    line_.emplace(*std::move(line));
  else
    return false;
  const Hello hello{
      version(),   program_invocation_short_name, static_cast<int32_t>(getpid()), place_.job, place_.rank,
      place_.ranks};
  if (!send(hello)) return lose("the worker is gone", now), false;
  helloAt_ = now;
  return true;
}

bool WorkerLink::greet(int timeoutMs, double now) {
  try {
    const std::optional<Message> message = line_->receive(timeoutMs);
    if (!message && line_->isBroken()) return lose("the worker is gone", now), false;
    if (!message) {
      why_ = "the worker does not answer";
      isAway_ = true;
      if (now - helloAt_ > kWelcomePatience) lose(why_, now);
      return false;
    }
    if (message->type != Welcome::kType) throw Malformed("it is no welcome");
    const auto welcome = decoded<Welcome>(message->body);
    if (!welcome.refusal.empty()) {
      disconnect(welcome.refusal, now);
      nextTry_ = now + 60;
      return false;
    }
    ranks_ = welcome.ranks;
    why_.clear();
    return welcome_ = true;
  } catch (const std::exception& error) { disconnect(error.what(), now); }
  return false;
}

bool WorkerLink::sendArrays(const EncodedSnapshot& encoded) {
  for (const ArraySource& source : encoded.arrays) {
    const auto [known, isNew] = sent_.try_emplace(source.name);
    known->second = source.owner;
    if (!isNew) continue;
    const Descriptor memory = sealedMemory(source.bytes(), [&](std::byte* to) { source.copyTo(to); });
    if (!send(ArrayComes{source.name, source.bytes()}, memory.get())) return false;
  }
  return true;
}

void WorkerLink::forgetGone() {
  if (sent_.size() <= sentAfterForgetting_ + sentAfterForgetting_ / 8 + 16) return;
  ArraysGo gone;
  for (const auto& [name, owner] : sent_)
    if (owner.expired()) gone.names.push_back(name);
  for (const Hash128& name : gone.names) sent_.erase(name);
  sentAfterForgetting_ = sent_.size();
  if (!gone.names.empty()) send(gone);
}

bool WorkerLink::standsAlone(const scene::Snapshot& snapshot) const {
  return place_.ranks == 1 || !(isGathering(snapshot) || fallsOnSurfaces(snapshot));
}

bool WorkerLink::isGathered(const scene::Snapshot& snapshot) const {
  return snapshot.number != 0 && gathered_ == snapshot.number;
}

bool WorkerLink::ask(const scene::Snapshot& snapshot, uint32_t missColor) {
  EncodedSnapshot encoded = encoder_.encode(snapshot);
  if (!sendArrays(encoded)) return false;
  forgetGone();
  TraceRequest request;
  request.id = ++lastId_, request.view = snapshot.view;
  request.width = snapshot.region.width, request.height = snapshot.region.height;
  request.moving = isMoving(snapshot), request.fps = static_cast<float>(snapshot.settings.fps);
  request.layered = snapshot.layers != nullptr;
  request.meetsPeers = place_.ranks > 1 && fallsOnSurfaces(snapshot);
  request.shown = {frameOf(snapshot), snapshot.camera.viewport};
  request.number = asked_ = snapshot.number;
  if (place_.ranks > 1 && isGathering(snapshot)) {
    request.gathers = true;
    request.part = partViewOf(snapshot);
    for (const ArraySource& source : encoded.arrays) request.arrays.push_back(source.name);
  }
  request.missColor = missColor;
  if (snapshot.lightSampling.tiles) request.wanted = *snapshot.lightSampling.tiles;
  request.snapshot = std::move(encoded.message);
  lastSign_ = nowSeconds();
  return send(request);
}

WorkerLink::Came WorkerLink::wait(int timeoutMs, double now) {
  const std::optional<Message> message = line_->receive(timeoutMs);
  if (!message) return line_->isBroken() || now - lastSign_ > kSilence ? Came::failure : Came::nothing;
  lastSign_ = now;
  switch (message->type) {
    case AtWork::kType: return Came::sign;
    case ImageMemory::kType: {
      memoryBytes_ = decoded<ImageMemory>(message->body).bytes;
      memory_ = mapWritten(message->attached, memoryBytes_);
      return Came::sign;
    }
    case ImageDone::kType: {
      auto image = decoded<ImageDone>(message->body);
      if (image.id != lastId_) return Came::sign;  // of an earlier request
      if (image.whole && bytesOf(image.shape) > memoryBytes_) throw Malformed("its pixels are missing");
      done_ = std::move(image);
      if (done_.gathered) gathered_ = asked_;
      if (done_.cost.elsewhere) elsewhere_ = asked_;
      return Came::image;
    }
    case FiguresKnown::kType: {
      figures_ = decoded<FiguresKnown>(message->body).ranks;
      hasFigures_ = true;
      return Came::sign;
    }
    default: throw Malformed("its kind is not known");
  }
}

bool WorkerLink::askFigures(int timeoutMs) {
  if (!welcome_) return false;
  const double end = nowSeconds() + 1e-3 * timeoutMs;
  hasFigures_ = false;
  ++lastId_;  // images of earlier requests, which were cancelled, do not count
  if (!line_->send(FiguresQuestion::kType, {}, -1, timeoutMs)) return false;
  lastSign_ = nowSeconds();
  for (double now = lastSign_; now < end && !hasFigures_; now = nowSeconds())
    if (wait(1 + static_cast<int>(1e3 * (end - now)), now) == Came::failure) return false;
  return hasFigures_;
}

void WorkerLink::sayEnd(int timeoutMs) noexcept {
  if (welcome_) line_->send(ProgramEnds::kType, {}, -1, timeoutMs);
}

bool WorkerLink::show(const scene::Snapshot& snapshot, const Image& image, bool finished) {
  ImageShown shown{snapshot.number, finished, image.missColor, shapeOf(image), image.layers};
  const PlanePointers from = planesOf(const_cast<Image&>(image));
  const Descriptor memory = sealedMemory(bytesOf(shown.shape), [&](std::byte* at) {
    const PlanePointers to = planesIn(at, shown.shape);
    copyTile(from, to, shown.shape, {0, 0, shown.shape.width, shown.shape.height});
  });
  return send(shown, memory.get());
}

void WorkerLink::cancel() { send(Cancel{lastId_}); }

}  // namespace gluray::cluster
