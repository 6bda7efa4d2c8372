// Traces images on a job of workers instead of this process's renderer. Any thread.
#pragma once
#include "cluster/program/worker_link.h"
#include "frame/tracing/tracer.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace gluray::cluster {

/// Sends one image at a time to the workers. If no worker answers, this process traces, logs one line, and
/// keeps looking for workers.
class RemoteTracer {
 public:
  /// `here`: traces in this process. `say`: one line for the user.
  RemoteTracer(std::string directory, std::string job, MpiPlace place, frame::TraceBehind here,
               std::function<void(const std::string&)> say);

  /// Implements frame::Trace and frame::TraceBehind. `stop` null: with priority over calls that may be
  /// stopped.
  bool trace(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
             const std::function<bool()>& stop) noexcept;
  /// As frame::Shown.
  void shown(const scene::Snapshot& snapshot, const Image& image, bool finished) noexcept;
  /// As frame::Scenery. trace() leaves ground and background out where the program has several ranks and the
  /// setting `gather` is on.
  bool isGathered(const scene::Snapshot& snapshot) noexcept;
  bool traceComplete(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                     std::string& error) noexcept;
  void leaveSceneryOut() noexcept;
  /// What the program's ranks have spent, in their order: all ranks at rank 0, otherwise this one. As of the
  /// last answer if the worker does not answer within that time; empty if images are traced for so long. Any
  /// thread.
  std::vector<RankFigures> figures(int timeoutMs) noexcept;
  /// Asks for the figures after images for some seconds, on the threads that trace. Returns those of the last
  /// answer to anybody. For threads that do not have the process's descriptors. Never waits for images.
  std::vector<RankFigures> observedFigures();
  /// Tells the worker that the program ends by itself. Waits so long at most.
  void sayEnd(int timeoutMs) noexcept;
  enum class Reach : uint8_t { untried, connected, alone };
  /// Whether a worker has traced the last image. Any thread.
  Reach reach() const noexcept { return reach_; }
  /// As frame::Improves, of the last image.
  bool improves() const noexcept { return improves_; }
  /// As frame::StandsAlone.
  bool standsAlone(const scene::Snapshot& snapshot) const noexcept { return link_.standsAlone(snapshot); }

 private:
  enum class Result : uint8_t { done, stopped, failed, nobody };
  Result byWorkers(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                   const std::function<bool()>& stop);
  Result receive(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                 const std::function<bool()>& stop);
  /// `isAway`: because no worker runs or answers.
  void tell(const std::string& why, bool isAway = false);
  bool traceAll(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& error,
                const std::function<bool()>& stop) noexcept;
  /// Asks the worker if figures are observed. Requires `mutex_`.
  void observe();
  void askFigures(int timeoutMs);
  /// Locks `mutex_` within that time. Returns false if it is locked for longer.
  bool lockWithin(int timeoutMs);
  /// Whether trace() omits ground and background.
  bool leavesOut(const scene::Snapshot& snapshot) const;

  const std::string job_;
  const bool hasPeers_;  // other ranks of the same program
  const frame::TraceBehind here_;
  const std::function<void(const std::string&)> say_;
  std::mutex mutex_;
  std::atomic<int> wanted_{0};  // priority calls that wait or trace
  std::atomic<bool> improves_{false};
  WorkerLink link_;
  std::atomic<Reach> reach_{Reach::untried};
  std::atomic<double> observedUntil_{0};
  double observed_ = 0;  // when
  std::mutex figuresMutex_;
  std::vector<RankFigures> figures_;  // of the last answer
  bool traced_ = false;               // the last image came from workers
  std::string told_;                  // why the one before did not
  bool toldOfLoss_ = false;           // that a worker that traced was lost
  std::string toldNote_;              // ImageDone::note
  std::atomic<bool> toldOfScenery_{false};
};

}  // namespace gluray::cluster
