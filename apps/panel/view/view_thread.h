// The thread that traces what the window shows: frames while the view moves, passes while it rests. Objects
// belong to the GUI thread; signals arrive there.
#pragma once
#include "view/engine_view.h"

#include <QImage>
#include <QSize>
#include <QThread>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace gluray::panel {

/// What the window wants to see.
struct WantedView {
  QSize size;                          // pixels of the picture
  std::optional<GlurayCamera> camera;  // none: the saved view
  std::vector<std::string> settings;   // "name=value" each
};

/// A picture, and how far it is.
struct ShownView {
  QImage image;         // smaller than the picture while the view moves
  uint64_t number = 0;  // of the wish
  bool moving = false, finished = false;
  unsigned passes = 0;
  double noise = 0;    // infinite: not known yet; 0: none
  double seconds = 0;  // since the wish
};

class ViewThread : public QThread {
  Q_OBJECT

 public:
  explicit ViewThread(std::unique_ptr<EngineView> view, QObject* parent = nullptr);
  ~ViewThread() override;

  const GlurayViewFacts& facts() const { return view_->facts(); }
  /// Leaves what is being traced. Returns the wish's number.
  uint64_t want(const WantedView& view);
  /// Finds the point of the first surface at a pixel of the picture that is wanted: pointFound() follows if
  /// there is one. Returns the number under which the picture is then shown.
  uint64_t findPoint(int x, int y);

 signals:
  void shown(const gluray::panel::ShownView& view);
  void failed(const QString& why);
  void pointFound(double x, double y, double z);

 protected:
  void run() override;

 private:
  struct Work;
  struct Point {
    int x, y;
  };
  /// False: the thread shall end.
  bool next(Work& work);
  void showMoving(Work& work);
  void showResting(Work& work);
  void answer(const Work& work, const Point& point);
  bool isOld(uint64_t number);

  std::unique_ptr<EngineView> view_;
  int divisor_ = 2;  // of moving frames: sides are so much smaller
  std::mutex mutex_;
  std::condition_variable changed_;
  WantedView wanted_;
  std::optional<Point> point_;
  uint64_t number_ = 0;
  bool ends_ = false;
};

}  // namespace gluray::panel
