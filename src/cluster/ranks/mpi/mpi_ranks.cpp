// Ranks by MPI: the only file that includes mpi.h. Compiled into one library for each implementation.
#include "cluster/ranks/mpi_plugin.h"

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <list>
#include <memory>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kTag = 1;
// MPI counts elements as int.
constexpr size_t kMaxMessageBytes = size_t{1} << 30, kPieceOfBroadcast = size_t{1} << 27;

void check(int result, const char* what) {
  if (result == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING] = {};
  int length = 0;
  MPI_Error_string(result, text, &length);
  throw RanksFailed(std::string(what) + ": " + text);
}

/// MPI, from its start to its end.
class Session {
 public:
  Session(int* argc, char*** argv) {
    int provided = 0;
    check(MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
    if (provided < MPI_THREAD_FUNNELED) throw RanksFailed("this MPI allows no threads beside it");
  }
  ~Session() { MPI_Finalize(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// A communicator of our own.
class Circle {
 public:
  Circle() {
    check(MPI_Comm_dup(MPI_COMM_WORLD, &comm), "MPI_Comm_dup");
    check(MPI_Comm_set_errhandler(comm, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  }
  ~Circle() { MPI_Comm_free(&comm); }
  Circle(const Circle&) = delete;
  Circle& operator=(const Circle&) = delete;

  MPI_Comm comm = MPI_COMM_NULL;
};

class MpiRanks final : public Ranks {
 public:
  MpiRanks(int* argc, char*** argv) : session_(argc, argv) {
    check(MPI_Comm_rank(messages_.comm, &rank_), "MPI_Comm_rank");
    check(MPI_Comm_size(messages_.comm, &size_), "MPI_Comm_size");
    MPI_Comm here = MPI_COMM_NULL;
    check(MPI_Comm_split_type(messages_.comm, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here),
          "MPI_Comm_split_type");
    MPI_Comm_rank(here, &rankHere_);
    MPI_Comm_size(here, &sizeHere_);
    MPI_Comm_free(&here);
  }
  ~MpiRanks() override {
    // Whoever leaves in the middle of something cannot wait for its end.
    if (busy()) endJob();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  int rankHere() const override { return rankHere_; }
  int sizeHere() const override { return sizeHere_; }
  std::string implementation() const override;

  void send(int to, std::vector<std::byte> message) override;
  std::optional<RankMessage> receive() override;
  void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) override;
  void progress() override;
  void endJob() noexcept override { MPI_Abort(MPI_COMM_WORLD, 1); }
  bool busy() const override { return !sends_.empty() || !broadcasts_.empty() || !toItself_.empty(); }

 private:
  struct Sending {
    std::vector<std::byte> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  struct Broadcast {
    std::vector<MPI_Request> pieces;
    std::function<void()> done;
  };

  Session session_;
  Circle messages_, broadcastsOf_;  // messages between two, and to all
  int rank_ = 0, size_ = 1, rankHere_ = 0, sizeHere_ = 1;
  std::list<Sending> sends_;
  std::list<Broadcast> broadcasts_;
  std::deque<std::vector<std::byte>> toItself_;
};

std::string MpiRanks::implementation() const {
  char text[MPI_MAX_LIBRARY_VERSION_STRING] = {};
  int length = 0;
  MPI_Get_library_version(text, &length);
  std::string name(text, static_cast<size_t>(length));
  name.resize(std::min(name.find_first_of(",\n"), name.size()));
  // "MPICH Version:\t4.0.2"; with spaces in other releases.
  if (const size_t colon = name.find(" Version:"); colon != name.npos) name.erase(colon, 9);
  std::ranges::replace(name, '\t', ' ');
  const auto isSecond = [](char a, char b) { return a == ' ' && b == ' '; };
  name.erase(std::unique(name.begin(), name.end(), isSecond), name.end());
  return name;
}

void MpiRanks::send(int to, std::vector<std::byte> message) {
  if (message.size() > kMaxMessageBytes) throw RanksFailed("a message is larger than 1 GiB");
  if (to == rank_) return toItself_.push_back(std::move(message));
  Sending& sending = sends_.emplace_back();
  sending.bytes = std::move(message);
  check(MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, kTag,
                  messages_.comm, &sending.request),
        "MPI_Isend");
}

std::optional<RankMessage> MpiRanks::receive() {
  if (!toItself_.empty()) {
    RankMessage message{rank_, std::move(toItself_.front())};
    toItself_.pop_front();
    return message;
  }
  int found = 0, bytes = 0;
  MPI_Message one = MPI_MESSAGE_NULL;
  MPI_Status status{};
  check(MPI_Improbe(MPI_ANY_SOURCE, kTag, messages_.comm, &found, &one, &status), "MPI_Improbe");
  if (!found) return std::nullopt;
  check(MPI_Get_count(&status, MPI_BYTE, &bytes), "MPI_Get_count");
  RankMessage message{status.MPI_SOURCE, std::vector<std::byte>(static_cast<size_t>(bytes))};
  check(MPI_Mrecv(message.bytes.data(), bytes, MPI_BYTE, &one, &status), "MPI_Mrecv");
  return message;
}

void MpiRanks::broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) {
  Broadcast& all = broadcasts_.emplace_back();
  all.done = std::move(done);
  for (size_t at = 0; at < bytes.size(); at += kPieceOfBroadcast) {
    const std::span<std::byte> piece = bytes.subspan(at, std::min(kPieceOfBroadcast, bytes.size() - at));
    check(MPI_Ibcast(piece.data(), static_cast<int>(piece.size()), MPI_BYTE, root, broadcastsOf_.comm,
                     &all.pieces.emplace_back(MPI_REQUEST_NULL)),
          "MPI_Ibcast");
  }
}

void MpiRanks::progress() {
  for (auto it = sends_.begin(); it != sends_.end();) {
    int done = 0;
    check(MPI_Test(&it->request, &done, MPI_STATUS_IGNORE), "MPI_Isend");
    it = done ? sends_.erase(it) : std::next(it);
  }
  for (auto it = broadcasts_.begin(); it != broadcasts_.end();) {
    int done = 0;
    check(MPI_Testall(static_cast<int>(it->pieces.size()), it->pieces.data(), &done, MPI_STATUSES_IGNORE),
          "MPI_Ibcast");
    if (!done) {
      ++it;
      continue;
    }
    const std::function<void()> finished = std::move(it->done);
    it = broadcasts_.erase(it);
    finished();
  }
}

Ranks* makeRanks(int* argc, char*** argv, char* why, size_t room) noexcept {
  try {
    return new MpiRanks(argc, argv);
  } catch (const std::exception& error) { std::snprintf(why, room, "%s", error.what()); }
  return nullptr;
}

}  // namespace
}  // namespace gluray::cluster

extern "C" {

__attribute__((visibility("default"))) const char* glurayMpiPluginVersion() { return GLURAY_VERSION; }

__attribute__((visibility("default"))) gluray::cluster::Ranks* glurayMakeMpiRanks(int* argc, char*** argv,
                                                                                  char* why, size_t room) {
  return gluray::cluster::makeRanks(argc, argv, why, room);
}
}
