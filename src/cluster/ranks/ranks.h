// Message passing between the processes of a job of workers. Implemented with MPI (mpi_ranks.cpp), for a
// single process, and for tests with threads. One thread uses it.
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

/// The job cannot continue, because MPI reports a failure.
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
  /// Returns the next message; none if none has arrived.
  virtual std::optional<RankMessage> receive() = 0;
  /// Copies `bytes` of rank `root` to all others, which have as many. All ranks call it, in the same order.
  /// Never blocks; the memory must stay until `done` is called, by progress().
  virtual void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) = 0;
  /// Progresses pending operations.
  virtual void progress() = 0;
  /// Whether operations are pending.
  virtual bool busy() const = 0;
  /// Ends all processes of the job if MPI supports it, after a failure of this process for which the others
  /// would wait. May not return.
  virtual void endJob() noexcept {}
};

}  // namespace gluray::cluster
