// The programs that the hub knows: one entry each, and one for all ranks of an MPI job. On the hub's thread.
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace gluray::control {

inline constexpr int kProtocolVersion = 1;

/// What a program says of itself.
struct ProgramHello {
  int version = kProtocolVersion;
  int pid = 0;
  std::string host, name, job;
  int rank = 0, ranks = 1;
  double since = 0;  // seconds since 1970; 0: not said
};
/// Reads it; a text says what is wrong with it.
std::variant<ProgramHello, std::string> programHello(const nlohmann::json& message);

struct Program {
  uint64_t number = 0;
  std::string job;  // empty: none
  int ranks = 1;    // of the job
  double since = 0;
  struct Member {
    uint64_t connection;
    ProgramHello hello;
  };
  std::map<int, Member> members;  // by rank, those that are connected; never empty

  /// The connection of rank 0, which speaks for the program; 0: it is not connected.
  uint64_t speaker() const;
  bool complete() const { return members.size() == static_cast<size_t>(ranks); }
  /// As in `list`.
  nlohmann::json row() const;
};

class Programs {
 public:
  /// Adds a program to its job's entry, or makes an entry. A second program with the same rank of a job, or
  /// with another number of ranks, gets an entry of its own outside the job. `since`: seconds since 1970.
  Program& add(uint64_t connection, const ProgramHello& hello, double since);
  /// Removes a connection. Returns the number of its entry, and whether that is gone, too. 0: it was no
  /// program.
  struct Removed {
    uint64_t number = 0;
    bool gone = false, wasSpeaker = false;
  };
  Removed remove(uint64_t connection);
  Program* find(uint64_t number);
  Program* ofConnection(uint64_t connection);
  const std::map<uint64_t, Program>& all() const { return programs_; }
  nlohmann::json rows() const;
  size_t connections() const { return numbers_.size(); }
  bool hasProcess(const std::string& host, int pid) const;

 private:
  uint64_t last_ = 0;
  std::map<uint64_t, Program> programs_;
  std::map<uint64_t, uint64_t> numbers_;  // by connection
};

}  // namespace gluray::control
