// The lines of gluray top, from events of state (docs/control-protocol.md).
#pragma once
#include "control/running_program.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gluray::launcher {

/// What a program, or a rank of one, spends. Negative: not known.
struct TopRow {
  int64_t rank = -1;  // of a program without ranks: -1
  std::string host;
  std::string state;                          // "lost", "ended" ...; empty: it runs
  double fps = -1;                            // images a second
  double eye = -1, light = -1, waiting = -1;  // milliseconds an image
  double sent = -1, received = -1;            // bytes a second between workers
  double memory = -1;                         // bytes
};

/// The states of one program.
class TopProgram {
 public:
  explicit TopProgram(RunningProgram program) : program_(std::move(program)) {}

  /// Takes an untrusted state of the time `now` in seconds.
  void take(const nlohmann::json& state, double now);
  /// Whether there are two states, between which rates are known.
  bool hasRates() const { return states_ > 1; }
  const RunningProgram& program() const { return program_; }
  /// One row, or one a rank; none before the first state.
  std::vector<TopRow> rows() const;

 private:
  RunningProgram program_;
  nlohmann::json before_, last_;
  double beforeAt_ = 0, lastAt_ = 0;
  int states_ = 0;
};

/// The table of these programs.
std::string topTable(const std::vector<TopProgram>& programs);

/// The rows as objects; null: not known.
nlohmann::json topJson(const std::vector<TopProgram>& programs);

}  // namespace gluray::launcher
