// A program's connection to the worker of its machine. One thread at a time.
#pragma once
#include "cluster/local/line.h"
#include "cluster/messages/figure_messages.h"
#include "cluster/messages/program_messages.h"
#include "cluster/program/worker_place.h"
#include "cluster/stream/snapshot_encoder.h"

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

namespace gluray::cluster {

/// A program's place among the ranks of its MPI job.
struct MpiPlace {
  int onMachine = 0;  // its number among the ranks on its machine
  std::string job;    // empty: not an MPI program
  int rank = 0, ranks = 1;
};

class WorkerLink {
 public:
  /// The worker of the job `job` whose socket is in `directory`; of several on this machine, that of the
  /// program's place.
  WorkerLink(std::string directory, std::string job, MpiPlace place);

  /// Connects if necessary. Returns false if no worker traces for this program at present; why() returns the
  /// reason. The first attempt waits for the worker's welcome, later ones do not.
  bool isReady(double now);
  const std::string& why() const { return why_; }
  /// Whether why() is that no worker runs or answers.
  bool isAway() const { return isAway_; }
  int ranks() const { return ranks_; }

  /// Whether images of the snapshot are independent of the program's other ranks, whose surfaces may belong
  /// to them or block their light.
  bool standsAlone(const scene::Snapshot& snapshot) const;
  /// Whether the last image of the snapshot also showed surfaces of other ranks, so that this process must
  /// not trace it.
  bool isGathered(const scene::Snapshot& snapshot) const;
  /// Whether another rank's process makes that image.
  bool isMadeElsewhere(const scene::Snapshot& snapshot) const {
    return isGathered(snapshot) && elsewhere_ == snapshot.number;
  }
  /// Sends the displayed image of a gathered snapshot. Returns false if the connection has failed.
  bool show(const scene::Snapshot& snapshot, const Image& image, bool finished);
  /// Sends the snapshot and its arrays that the worker lacks. Returns false if the connection has failed.
  bool ask(const scene::Snapshot& snapshot, uint32_t missColor);
  enum class Came : uint8_t { nothing, sign, image, failure };
  /// Waits for the worker's messages about the image. `failure`: the worker is silent for too long, or
  /// gone.
  Came wait(int timeoutMs, double now);
  /// After Came::image.
  const ImageDone& done() const { return done_; }
  /// The image's pixels, until the next ask().
  const std::byte* pixels() const { return memory_.get(); }
  void cancel();
  /// Whether a worker traces for this program, as of the last request.
  bool isConnected() const { return welcome_; }
  /// Requests what the worker knows of the program's ranks. Call between images. Waits so long for its answer
  /// at most. Returns false if there is none.
  bool askFigures(int timeoutMs);
  /// The last answer to askFigures(), in the order of ranks; rank 0's only has all.
  const std::vector<RankFigures>& figures() const { return figures_; }
  /// Tells the worker that the program ends by itself. Waits so long at most.
  void sayEnd(int timeoutMs) noexcept;
  void disconnect(std::string why, double now);
  /// Disconnects from a worker that is gone or does not answer.
  void lose(std::string why, double now);

 private:
  bool connect(double now);
  bool greet(int timeoutMs, double now);
  bool sendArrays(const EncodedSnapshot& encoded);
  void forgetGone();
  template <class M>
  bool send(const M& message, int attached = -1);

  const std::string directory_, job_;
  const MpiPlace place_;
  std::optional<Line> line_;
  bool welcome_ = false, everTried_ = false, isAway_ = false;
  double nextTry_ = 0, lastSign_ = 0, helloAt_ = 0;
  std::string why_;
  int ranks_ = 1;
  SnapshotEncoder encoder_;
  std::unordered_map<Hash128, std::weak_ptr<const void>> sent_;
  size_t sentAfterForgetting_ = 0;
  uint64_t lastId_ = 0;
  std::shared_ptr<const std::byte> memory_;
  size_t memoryBytes_ = 0;
  ImageDone done_;
  std::vector<RankFigures> figures_;
  bool hasFigures_ = false;  // since they were requested
  // Snapshot::number of the last request, the last gathered image, and the last one of another process.
  uint64_t asked_ = 0, gathered_ = 0, elsewhere_ = 0;
};

}  // namespace gluray::cluster
