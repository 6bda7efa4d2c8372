#include "view/view_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gluray::panel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kRest = std::chrono::milliseconds(120);  // without a change, before passes begin
// Seconds of a moving frame.
constexpr double kSlow = 0.07, kFast = 0.02;
constexpr int kCoarsest = 8;
constexpr unsigned kFewPasses = 4;  // they show more noise than moving frames

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

/// A wish that the thread works on.
struct ViewThread::Work {
  WantedView view;
  uint64_t number = 0;
  Clock::time_point start;
  std::optional<Point> point;
  std::vector<const char*> settings = {};

  GlurayViewRequest request(const QSize& size, bool moving) {
    settings.clear();
    for (const std::string& setting : view.settings) settings.push_back(setting.c_str());
    return {size.width(),
            size.height(),
            view.camera ? &*view.camera : nullptr,
            settings.data(),
            static_cast<int>(settings.size()),
            moving};
  }
};

ViewThread::ViewThread(std::unique_ptr<EngineView> view, QObject* parent)
    : QThread(parent), view_(std::move(view)) {
  qRegisterMetaType<ShownView>();
}

ViewThread::~ViewThread() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true, ++number_;
  }
  changed_.notify_all();
  wait();
}

uint64_t ViewThread::want(const WantedView& view) {
  const std::lock_guard lock(mutex_);
  wanted_ = view;
  changed_.notify_all();
  return ++number_;
}

uint64_t ViewThread::findPoint(int x, int y) {
  const std::lock_guard lock(mutex_);
  point_ = Point{x, y};
  changed_.notify_all();
  return ++number_;
}

bool ViewThread::isOld(uint64_t number) {
  const std::lock_guard lock(mutex_);
  return number != number_;
}

bool ViewThread::next(Work& work) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return ends_ || number_ != work.number; });
  work = {wanted_, number_, Clock::now(), std::exchange(point_, std::nullopt)};
  return !ends_;
}

void ViewThread::run() {
  Work work;
  while (next(work)) {
    if (work.point) answer(work, *work.point);
    if (work.view.size.isEmpty()) continue;
    if (!work.point) showMoving(work);
    {
      std::unique_lock lock(mutex_);
      if (changed_.wait_for(lock, kRest, [&] { return number_ != work.number; })) continue;
    }
    showResting(work);
  }
}

void ViewThread::answer(const Work& work, const Point& point) {
  Work copy = work;
  double at[3];
  if (view_->point(copy.request(work.view.size, false), point.x, point.y, at))
    emit pointFound(at[0], at[1], at[2]);
}

namespace {

/// What a sink of the library knows.
template <class Taken, class Stop>
struct Sink {
  Taken taken;
  Stop stop;

  GlurayViewSink sink() {
    return {this, [](void* user) { return static_cast<Sink*>(user)->stop() ? 1 : 0; },
            [](void* user, int width, int height, const uint32_t* pixels, unsigned passes, double noise,
               int finished) {
              const QImage image(reinterpret_cast<const uchar*>(pixels), width, height, width * 4,
                                 QImage::Format_RGBA8888_Premultiplied);
              static_cast<Sink*>(user)->taken(image.copy(), passes, noise, finished != 0);
            }};
  }
};

}  // namespace

void ViewThread::showMoving(Work& work) {
  const QSize size = (work.view.size / divisor_).expandedTo({1, 1});
  const Clock::time_point start = Clock::now();
  Sink sink{[&](QImage&& image, unsigned, double, bool) {
              emit shown({std::move(image), work.number, true, false, 0, 0, since(work.start)});
            },
            [] { return false; }};
  std::string why;
  if (!view_->show(work.request(size, true), sink.sink(), why) && !why.empty())
    emit failed(QString::fromStdString(why));
  const double seconds = since(start);
  if (seconds > kSlow) divisor_ = std::min(kCoarsest, divisor_ + (seconds > 4 * kSlow ? 2 : 1));
  if (seconds < kFast) divisor_ = std::max(1, divisor_ - 1);
}

void ViewThread::showResting(Work& work) {
  Sink sink{[&](QImage&& image, unsigned passes, double noise, bool finished) {
              const bool worse = noise > 0 && passes < kFewPasses && !finished && divisor_ <= 2;
              emit shown({worse ? QImage() : std::move(image), work.number, false, finished, passes, noise,
                          since(work.start)});
            },
            [&] { return isOld(work.number); }};
  std::string why;
  if (!view_->show(work.request(work.view.size, false), sink.sink(), why) && !why.empty())
    emit failed(QString::fromStdString(why));
}

}  // namespace gluray::panel
