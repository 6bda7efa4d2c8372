// What programs say to their head.
#include "cluster/messages/version.h"
#include "cluster/worker/head.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::cluster {

void Head::add(control::Descriptor socket) { programs_.emplace_back(Line(std::move(socket))); }

std::vector<int> Head::descriptors() {
  std::vector<int> all;
  for (ConnectedProgram& program : programs_) all.push_back(program.line().descriptor());
  return all;
}

void Head::readPrograms(double now) {
  for (ConnectedProgram& program : programs_) {
    try {
      while (!program.isGone()) {
        const std::optional<Message> message = program.line().receive();
        if (!message) break;
        handle(program, *message, now);
      }
    } catch (const std::exception& error) {
      say_((program.name.empty() ? "a program" : program.name) + ": " + error.what() +
           "; it is disconnected");
      program.end();
    }
  }
  for (auto it = programs_.begin(); it != programs_.end();) {
    if (!it->isGone()) {
      ++it;
      continue;
    }
    leave(*it, now);
    it = programs_.erase(it);
  }
}

void Head::handle(ConnectedProgram& program, const Message& message, double now) {
  const auto as = [&]<class M>(M) { return decoded<M>(message.body); };
  if (message.type == Hello::kType) {
    if (!program.name.empty()) throw Malformed("it says hello twice");
    return greet(program, as(Hello{}));
  }
  if (program.name.empty()) throw Malformed("it says no hello");
  switch (message.type) {
    case ArrayComes::kType:
      if (program.peer) peers_.gatherer(program.peer).comes(now);
      return takeArray(program, as(ArrayComes{}), message.attached);
    case ArraysGo::kType: return forget(program, as(ArraysGo{}).names);
    case TraceRequest::kType:
      endImage(program, now);
      program.request = as(TraceRequest{});
      return ask(program, now);
    case Cancel::kType:
      if (!(program.image || program.isWaiting()) || program.request->id != as(Cancel{}).id) return;
      endImage(program, now);
      return program.send(
          ImageDone{program.request->id, false, false, false, "", "", {1, 1, 1, Image::kColorDepth}, {}, {}});
    case ImageShown::kType: return takeShown(program, as(ImageShown{}), message.attached);
    case FiguresQuestion::kType:
      as(FiguresQuestion{});
      return program.send(program.peer ? peers_.figuresFor(program.peer) : FiguresKnown{});
    case ProgramEnds::kType:
      as(ProgramEnds{});
      if (program.peer) peers_.ends(program.peer);
      return;
    case JobQuestion::kType: as(JobQuestion{}); return inquiry_.ask(program, now);
    default: throw Malformed("its kind is not known");
  }
}

void Head::greet(ConnectedProgram& program, const Hello& hello) {
  program.name = hello.program + " (process " + std::to_string(hello.process) + ")";
  Welcome welcome{"", ranks_.size(), states_.allThreads()};
  if (hello.version != version())
    welcome.refusal = "the worker is of GLuRay " + std::string(version()) + ", the program of " +
                      hello.version + "; use one version for both";
  program.ranks = std::max(hello.ranks, 1);
  if (welcome.refusal.empty() && hello.ranks > 1) {
    program.peer = peers_.add(hashBytes(hello.mpiJob.data(), hello.mpiJob.size()), hello.rank, hello.ranks);
    program.spreads = false;
  }
  program.send(welcome);
  say_(program.name + (welcome.refusal.empty() ? " is connected" : ": " + welcome.refusal));
  if (!welcome.refusal.empty()) program.end();
}

void Head::leave(ConnectedProgram& program, double now) {
  endImage(program, now);
  if (program.paging.number) pages_.forget(program.paging.number);
  if (program.peer) peers_.remove(program.peer);
  inquiry_.forget(program);
  forget(program, {program.arrays.begin(), program.arrays.end()});
  if (!program.name.empty()) say_(program.name + " is gone");
}

}  // namespace gluray::cluster
