#include "cluster/worker/job_inquiry.h"

#include "cluster/messages/version.h"
#include "cluster/worker/facts/rank_facts.h"

#include <algorithm>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr double kPatience = 2;  // seconds

}  // namespace

bool JobInquiry::Question::isAnswered() const {
  return std::ranges::all_of(facts.ranks, [](const RankFacts& rank) { return rank.answered; });
}

void JobInquiry::ask(ConnectedProgram& program, double now) {
  forget(program);
  Question& question = questions_.emplace_back(Question{&program, ++lastId_, now, {}});
  question.facts.ranks.resize(static_cast<size_t>(ranks_.size()));
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    question.facts.ranks[static_cast<size_t>(rank)].rank = rank;
    ranks_.send(rank, forRanks(FactsWanted{question.id}));
  }
}

void JobInquiry::forget(const ConnectedProgram& program) {
  std::erase_if(questions_, [&](const Question& question) { return question.program == &program; });
}

void JobInquiry::receive(int head, const FactsWanted& wanted) {
  ranks_.send(head, forRanks(FactsGiven{wanted.id, version(), encoded(factsOf(ranks_, threads_))}));
}

void JobInquiry::receive(int rank, const FactsGiven& given) {
  const auto question = std::ranges::find(questions_, given.id, &Question::id);
  if (question == questions_.end()) return;  // too late
  RankFacts facts;
  if (given.version == version()) facts = decoded<RankFacts>(given.facts);
  facts.rank = rank, facts.version = given.version, facts.answered = true;
  question->facts.ranks[static_cast<size_t>(rank)] = std::move(facts);
  if (!question->isAnswered()) return;
  question->program->send(question->facts);
  questions_.erase(question);
}

void JobInquiry::tick(double now) {
  std::erase_if(questions_, [&](const Question& question) {
    if (now - question.since < kPatience) return false;
    question.program->send(question.facts);
    return true;
  });
}

}  // namespace gluray::cluster
