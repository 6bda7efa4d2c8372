// The programs that the hub knows: one entry for each, and one entry for all ranks of an MPI job. On the
// hub's thread.
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace gluray::control {

inline constexpr int kProtocolVersion = 1;

/// Contents of a program's hello.
struct ProgramHello {
  int version = kProtocolVersion;
  int pid = 0;
  std::string host, name, job;
  int rank = 0, ranks = 1;
  double since = 0;  // seconds since 1970; 0: unspecified
};
/// Parses a hello, or returns an error message.
std::variant<ProgramHello, std::string> programHello(const nlohmann::json& message);

struct Program {
  uint64_t number = 0;
  std::string job;  // empty: no job
  int ranks = 1;    // of the job
  double since = 0;
  struct Member {
    uint64_t connection;
    ProgramHello hello;
  };
  std::map<int, Member> members;  // connected ranks; never empty

  /// The connection of rank 0, which speaks for the program; 0 if it is not connected.
  uint64_t speaker() const;
  bool complete() const { return members.size() == static_cast<size_t>(ranks); }
  /// The program's row in the answer to `list`.
  nlohmann::json row() const;
};

class Programs {
 public:
  /// Adds a program to its job's entry, or creates an entry. A second program with the same rank in a job, or
  /// with another number of ranks, gets its own entry outside the job. `since`: seconds since 1970.
  Program& add(uint64_t connection, const ProgramHello& hello, double since);
  /// Result of remove(): the number of the entry (0 if the connection was not a program), and whether the
  /// entry was removed.
  struct Removed {
    uint64_t number = 0;
    bool gone = false, wasSpeaker = false;
  };
  /// Removes a connection.
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
