// The processes of a job of workers, and the messages between them: what workers need of MPI. Implemented by
// MPI (mpi_ranks.cpp), by a process alone, and for tests by threads. One thread uses it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace gluray::cluster {

struct RankMessage {
  int from = 0;
  std::vector<std::byte> bytes;
};

/// The job cannot go on: MPI reports a failure.
class RanksFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All calls may throw RanksFailed and std::bad_alloc.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;  // of this process, from 0
  virtual int size() const = 0;
  virtual int rankHere() const = 0;  // among the job's processes on this machine, from 0
  virtual int sizeHere() const = 0;
  /// "Open MPI 4.1.4".
  virtual std::string implementation() const = 0;

  /// Never blocks. Messages from one rank to another arrive in the order in which they were sent. A rank may
  /// send to itself.
  virtual void send(int to, std::vector<std::byte> message) = 0;
  /// The next message that has arrived; none: there is none.
  virtual std::optional<RankMessage> receive() = 0;
  /// Copies `bytes` of rank `root` to all others, which have as many. All ranks call it, in the same order.
  /// Never blocks; the memory must stay until `done` is called, by progress().
  virtual void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) = 0;
  /// Goes on with what has begun.
  virtual void progress() = 0;
  /// Whether something has begun that progress() must go on with.
  virtual bool busy() const = 0;
  /// Ends all processes of the job, where MPI can: this one fails, and the others would wait for it. May not
  /// return.
  virtual void endJob() noexcept {}
};

}  // namespace gluray::cluster
