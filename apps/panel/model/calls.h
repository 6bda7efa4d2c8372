// Requests whose answers a part of the panel waits for. Each taker is called once: with the answer, or with
// the reason why none comes. GUI thread; nothing waits.
#pragma once
#include <nlohmann/json.hpp>

#include <QPointer>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::panel {

/// What a program answered: `value` is an object, a list or a plain value, and null if `why` says something.
struct CallAnswer {
  nlohmann::json value;
  std::string why;
};
using CallTaker = std::function<void(const CallAnswer&)>;

/// The answers to the requests of a `batch`, in their order; fewer, or none, if it failed.
using BatchTaker = std::function<void(const std::vector<CallAnswer>&)>;

class Calls {
 public:
  /// `receiver`: nobody is called after it has gone. `changes`: the request may change settings.
  void wait(uint64_t id, int program, QObject* receiver, BatchTaker then, bool changes = false);
  /// Whether a request that may change settings is unanswered, also where its receiver has gone.
  bool anyChanges() const;
  /// Whether the answer is that of a call; then its taker has been called.
  bool receiveAnswer(uint64_t id, const nlohmann::json& answer);
  /// Calls of programs that are not in the list end with `why`: late answers are nobody's.
  void endOthers(const std::vector<int>& programs, const std::string& why);
  /// All calls end.
  void end(const std::string& why) { endOthers({}, why); }

 private:
  struct Waiting {
    int program = 0;
    QPointer<QObject> receiver;
    BatchTaker then;
    bool changes = false;
  };
  std::map<uint64_t, Waiting> waiting_;
};

}  // namespace gluray::panel
