#include "cluster/program/job_question.h"

#include "cluster/messages/version.h"
#include "cluster/program/worker_place.h"

#include <unistd.h>

#include <cerrno>
#include <exception>
#include <stdexcept>

namespace gluray::cluster {
namespace {

constexpr int kAskMs = 2000, kGreetMs = 5000;
constexpr int kFactsMs = 5000;  // more than a head waits for its ranks

template <class M>
void say(Line& line, const M& message) {
  if (!line.send(M::kType, encoded(message), -1, kAskMs)) throw std::runtime_error("the worker is gone");
}

template <class M>
M awaited(Line& line, int timeoutMs) {
  const std::optional<Message> message = line.receive(timeoutMs);
  if (!message)
    throw std::runtime_error(line.isBroken() ? "the worker is gone"
                                             : "the worker of this machine does not answer");
  if (message->type != M::kType) throw Malformed("its kind is not known");
  return decoded<M>(message->body);
}

}  // namespace

std::optional<JobFacts> askJob(const std::string& directory, const std::string& job, std::string& why) {
  std::optional<Line> line = lineToWorker(directory, job, 0, why);
  if (!line) return std::nullopt;
  try {
    say(*line, Hello{version(), program_invocation_short_name, static_cast<int32_t>(getpid())});
    if (why = awaited<Welcome>(*line, kGreetMs).refusal; !why.empty()) return std::nullopt;
    say(*line, JobQuestion{});
    return awaited<JobFacts>(*line, kFactsMs);
  } catch (const std::exception& error) { why = error.what(); }
  return std::nullopt;
}

}  // namespace gluray::cluster
