#include "intercept/capture/capture.h"

#include "base/background_job.h"
#include "base/clock.h"
#include "base/log.h"
#include "base/processes/rest_detector.h"
#include "gl/objects/shown_frames.h"
#include "intercept/capture/capture_folder.h"
#include "intercept/capture/capture_plan.h"
#include "intercept/control/shown_as_saved.h"
#include "intercept/present/read_back/window_buffers.h"
#include "intercept/session/guarded.h"

#include <sys/resource.h>
#include <sys/time.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace gluray::intercept {
namespace {

using Pixels = CapturedPixels;

constexpr double kQuiet = 1.5;  // seconds without a frame until a window may be at rest

/// That this process has used.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The part of a window, bottom row first.
saved::SavedPicture partOf(const Pixels& window, const glm::ivec4& box) {
  saved::SavedPicture part{box.z, box.w, {}};
  const glm::ivec2 from(box), to = from + glm::ivec2(box.z, box.w);
  if (from.x < 0 || from.y < 0 || to.x > window.size.x || to.y > window.size.y) return {};
  for (int y = from.y; y < to.y; ++y)
    for (int x = from.x; x < to.x; ++x)
      part.pixels.push_back(0xff000000u | window.colors[static_cast<size_t>(y * window.size.x + x)]);
  return part;
}

/// What a frame shows: of the window's place if it is known, otherwise all in one rectangle.
saved::SavedScene sceneOf(const gl::ShownFramePtr& frame, const Pixels& pixels, bool isWindow) {
  const std::vector<glm::ivec4> places = isWindow ? gl::shownFrames().places() : std::vector<glm::ivec4>();
  ShownAsSaved shown = shownAsSaved(frame ? *frame : gl::ShownFrame{}, {pixels.size, places});
  saved::SavedScene& scene = shown.scene;
  const glm::ivec4 all(0, 0, pixels.size);
  if (!isWindow || scene.batches.empty()) {
    for (saved::SavedBatch& batch : scene.batches) batch.place = {0, 0};
    scene.window = pixels.size, shown.box = all;
  }
  if (shown.box) scene.shown = partOf(pixels, *shown.box);
  return std::move(shown.scene);
}

class Capture {
 public:
  explicit Capture(CapturePlan plan) : plan_(std::move(plan)), folder_(plan_.folder) {}

  /// Whether the colours of the frame that ends next are needed. Any thread.
  bool wantsNext() {
    const std::lock_guard lock(mutex_);
    return !ended_ && (plan_.keepsLast() || plan_.wants(frames_ + 1, nowSeconds() - began_));
  }
  /// A window has shown a frame. `pixels`: null if they were not wanted. `seen`: whether the window is on the
  /// screen; swaps of others show nothing, and are followed by reads.
  void shown(std::unique_ptr<Pixels> pixels, bool seen) {
    const std::lock_guard lock(mutex_);
    if (!begin()) return;
    windows_ = windows_ || seen;
    frames_ += seen;
    if (!pixels || (!seen && (frames_ > 0 || !plan_.keepsLast()))) return;
    saved::SavedScene scene = sceneOf(gl::shownFrames().last(), *pixels, true);
    seen ? take(std::move(scene)) : keep(std::move(scene));
  }
  /// Whether a picture that was read, after so many draws of its context, is one of the program's frames.
  bool isFrame(const void* context, uint64_t draws) {
    const std::lock_guard lock(mutex_);
    return !ended_ && !windows_ && std::exchange(lastRead_, {context, draws}) != std::pair(context, draws);
  }
  void read(const gl::ShownFramePtr& frame, std::unique_ptr<Pixels> pixels) {
    const std::lock_guard lock(mutex_);
    if (!begin()) return;
    ++frames_;
    if (pixels) take(sceneOf(frame, *pixels, false));
  }
  /// The program exits: what is shown now is the last frame.
  void exit() {
    thread_.stop();
    const std::lock_guard lock(mutex_);
    if (isOurs_ != true) return;
    if (!ended_ && last_) write();
    folder_.end(frames_);
  }
  bool ended() const { return ended_; }

 private:
  struct Frame {
    uint64_t number;
    saved::SavedScene scene;
  };

  /// Whether this process gives the frames.
  bool begin() {
    if (!isOurs_) isOurs_ = folder_.claim();
    if (!*isOurs_) end();
    return !ended_;
  }
  void take(saved::SavedScene scene) {
    if (plan_.wants(frames_, nowSeconds() - began_)) return last_ = {frames_, std::move(scene)}, write();
    if (plan_.keepsLast()) keep(std::move(scene));
  }
  void keep(saved::SavedScene scene) {
    last_ = {frames_, std::move(scene)};
    if (!thread_.busy())
      thread_.start([this](const std::atomic<bool>& cancelled) { watch(cancelled); },
                    BackgroundJob::Priority::usual);
  }
  /// Takes the last frame at a time at which no other ends.
  void watch(const std::atomic<bool>& cancelled) {
    constexpr std::chrono::milliseconds kPause{50};
    RestDetector rest(kQuiet);
    for (; !cancelled && !ended_; std::this_thread::sleep_for(kPause)) {
      const std::lock_guard lock(mutex_);
      const double now = nowSeconds();
      const bool due = plan_.when == CapturePlan::When::seconds
                           ? now - began_ >= plan_.seconds
                           : windows_ && rest.isAtRest(frames_, now, processorSeconds);
      if (due && last_ && !ended_) write();
    }
  }
  void write() {
    folder_.add(last_->number, last_->scene);
    last_.reset();
    if (plan_.isSingle()) end();
  }
  void end() {
    ended_ = true;
    last_.reset();
    gl::shownFrames().wantAlways(false);
  }

  const CapturePlan plan_;
  CaptureFolder folder_;
  const double began_ = nowSeconds();
  std::atomic<bool> ended_{false};
  std::mutex mutex_;                           // guards the members below
  std::optional<bool> isOurs_;                 // none: no frame has ended
  uint64_t frames_ = 0;                        // that have ended
  bool windows_ = false;                       // of windows
  std::pair<const void*, uint64_t> lastRead_;  // context and number of draws
  std::optional<Frame> last_;
  BackgroundJob thread_;  // last member: it ends before the others are destroyed
};

Capture* g_capture = nullptr;  // never destroyed: programs call OpenGL while they exit

uint64_t drawsOf(const gl::Context& context) {
  const gl::Statistics& statistics = context.counts.statistics;
  return statistics.drawsTraced + statistics.drawsRasterised;
}

/// Reads colours by `read`(context, features, pixels), which says whether they could be read.
template <class Read>
std::unique_ptr<Pixels> pixelsOf(Record& record, glm::ivec2 size, const Read& read) {
  if (size.x <= 0 || size.y <= 0) return nullptr;
  if (!record.features) record.features = present::readFeatures(record.context->real);
  auto pixels = std::make_unique<Pixels>();
  pixels->size = size;
  pixels->colors.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  bool done = false;
  const GLenum pending = read(pixels->colors, done);
  if (pending != GL_NO_ERROR) record.context->errors.set(pending);
  return done ? std::move(pixels) : nullptr;
}

bool mayRead(const Record& record) {
  const gl::Context* const context = record.context.get();
  return context && !record.version.starts_with("OpenGL ES") && !context->lists.compiling() &&
         !context->immediate.insideBegin();
}

/// Whether the user sees what the current context draws into its drawable; true if that cannot be known.
bool drawsIntoSeenWindow() { return !current().shown || current().shown(); }

void finishCapture() {
  guarded("cannot save a scene", [] { g_capture->exit(); });
}

}  // namespace

void planCapture() {
  const char* const text = std::getenv("GLURAY_CAPTURE");
  if (!text) return;
  std::optional<CapturePlan> plan = readCapturePlan(text);
  if (!plan) return log::write(log::Level::warning, "GLURAY_CAPTURE: it is not set by gluray run --shot");
  g_capture = new Capture(std::move(*plan));
  gl::shownFrames().wantAlways(true);
  std::atexit(finishCapture);
}

bool capturing() noexcept { return g_capture && !g_capture->ended(); }

void captureShowing(Record& record, GLenum buffer) noexcept {
  if (!capturing() || !mayRead(record)) return;
  guarded("cannot save a scene", [&] {
    record.captured.reset();
    if (!g_capture->wantsNext()) return;
    const glm::ivec2 size = current().size ? current().size() : glm::ivec2(0);
    record.captured = pixelsOf(record, size, [&](std::vector<uint32_t>& colors, bool& done) {
      return present::readColors(record.context->real, *record.features, size, buffer, colors, done);
    });
  });
}

void captureShown() noexcept {
  if (!capturing() || !current().record || !current().record->context) return;
  guarded("cannot save a scene", [] {
    const bool seen = !current().record->context->info().doubleBuffered || drawsIntoSeenWindow();
    g_capture->shown(std::move(current().record->captured), seen);
  });
}

void captureRead(Record& record, const scene::Region& region) noexcept {
  if (!capturing() || !mayRead(record)) return;
  guarded("cannot save a scene", [&] {
    gl::Context& context = *record.context;
    if (current().shown && current().shown()) return;  // a swap shows the frame
    if (!g_capture->isFrame(&context, drawsOf(context))) return;
    std::unique_ptr<Pixels> pixels;
    const glm::ivec2 size(region.x + region.width, region.y + region.height);
    if (g_capture->wantsNext())
      pixels = pixelsOf(record, size, [&](std::vector<uint32_t>& colors, bool& done) {
        return present::readBoundColors(context.real, *record.features, size, colors, done);
      });
    g_capture->read(context.surfaces.objects.now(), std::move(pixels));
  });
}

}  // namespace gluray::intercept
