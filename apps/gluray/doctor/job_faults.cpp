#include "doctor/job_faults.h"

#include "doctor/job_findings.h"
#include "text_table.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace gluray::launcher {
namespace {

using cluster::JobFacts;
using cluster::RankFacts;
using RankList = std::vector<const RankFacts*>;

RankList knownRanks(const JobFacts& facts) {
  RankList known;
  for (const RankFacts& rank : facts.ranks)
    if (isKnown(rank)) known.push_back(&rank);
  return known;
}

/// Ranks by a text of theirs.
template <class Text>
std::map<std::string, RankList> byText(const RankList& ranks, Text text) {
  std::map<std::string, RankList> groups;
  for (const RankFacts* rank : ranks) groups[text(*rank)].push_back(rank);
  return groups;
}

std::string named(const RankList& ranks) {
  std::vector<int> numbers;
  for (const RankFacts* rank : ranks) numbers.push_back(rank->rank);
  return ranksText(numbers);
}

int threadsOf(const RankList& ranks) {
  int sum = 0;
  for (const RankFacts* rank : ranks) sum += rank->threads;
  return sum;
}

void findSilent(const JobFacts& facts, Diagnosis& diagnosis) {
  RankList silent;
  for (const RankFacts& rank : facts.ranks)
    if (!rank.answered) silent.push_back(&rank);
  if (silent.empty()) return;
  diagnosis.limited(
      "answers",
      named(silent) + (silent.size() == 1 ? " has" : " have") +
          " not answered within 2 seconds; the others trace what these would",
      "check whether the processes are stopped and their hosts can be reached, or start the job "
      "again without these hosts");
}

/// "A: ranks 0, 1; B: rank 2"
std::string shares(const std::map<std::string, RankList>& groups) {
  std::string text;
  for (const auto& [name, ranks] : groups) text += (text.empty() ? "" : "; ") + name + ": " + named(ranks);
  return text;
}

void findVersions(const JobFacts& facts, Diagnosis& diagnosis) {
  RankList answered;
  for (const RankFacts& rank : facts.ranks)
    if (rank.answered) answered.push_back(&rank);
  const auto versions = byText(answered, [](const RankFacts& rank) { return "GLuRay " + rank.version; });
  if (versions.size() > 1)
    diagnosis.broken("versions", "the ranks are of different versions: " + shares(versions),
                     "start all ranks from one installation of GLuRay");
  const auto mpis = byText(knownRanks(facts), [](const RankFacts& rank) { return rank.mpi; });
  if (mpis.size() > 1)
    diagnosis.limited("MPI", "the ranks use different versions of MPI: " + shares(mpis),
                      "install the same version on all hosts");
}

/// Ranks with a single core of several, as Open MPI binds those of small jobs.
void findBound(const std::string& host, const RankList& ranks, Diagnosis& diagnosis) {
  RankList bound;
  for (const RankFacts* rank : ranks)
    if (rank->usableCores == 1 && rank->hostCores > 1) bound.push_back(rank);
  if (bound.empty()) return;
  diagnosis.limited("binding",
                    named(bound) + " on " + host + (bound.size() == 1 ? " is" : " are each") +
                        " bound to one of " + std::to_string(bound[0]->hostCores) + " cores",
                    "Open MPI: mpirun --bind-to none; MPICH: mpiexec -bind-to none; Slurm: srun "
                    "--cpu-bind=none, or more --cpus-per-task");
}

void sayCrowded(const std::string& host, const RankList& ranks, int cores, Diagnosis& diagnosis) {
  const int threads = threadsOf(ranks), each = cores / static_cast<int>(ranks.size());
  diagnosis.limited("threads",
                    named(ranks) + " on " + host + (ranks.size() == 1 ? " traces" : " together trace") +
                        " with " + std::to_string(threads) + " threads on " + std::to_string(cores) +
                        (cores == 1 ? " core" : " cores"),
                    each > 0 ? "gluray-worker --threads " + std::to_string(each) +
                                   (ranks.size() == 1 ? "" : ", or fewer ranks on the host")
                             : "fewer ranks on the host");
}

/// More threads than cores: of the whole host, or of the cores that ranks are bound to.
void findCrowded(const std::string& host, const RankList& ranks, Diagnosis& diagnosis) {
  if (threadsOf(ranks) > ranks[0]->hostCores && ranks[0]->hostCores > 0)
    return sayCrowded(host, ranks, ranks[0]->hostCores, diagnosis);
  for (const auto& [cores, bound] : byText(ranks, [](const RankFacts& rank) { return rank.cores; }))
    if (threadsOf(bound) > bound[0]->usableCores && bound[0]->usableCores > 0)
      sayCrowded(host, bound, bound[0]->usableCores, diagnosis);
}

void findFullShm(const std::string& host, const RankFacts& rank, Diagnosis& diagnosis) {
  constexpr uint64_t kMin = uint64_t{32} << 20;  // bytes that MPI needs for the messages of a host's ranks
  if (rank.shmBytes == 0) return;
  if (rank.shmFreeBytes >= kMin && rank.shmFreeBytes >= rank.shmBytes / 10) return;
  diagnosis.limited("/dev/shm",
                    host + ": " + std::to_string(rank.shmFreeBytes >> 20) + " MB free of " +
                        std::to_string(rank.shmBytes >> 20) +
                        " MB; MPI keeps messages between ranks of one host there",
                    "remove files that ended programs have left there, or give it more room: sudo mount -o "
                    "remount,size=50% /dev/shm");
}

/// Memory that each of a host's ranks may take.
uint64_t shareOf(const RankList& ranks) { return ranks[0]->availableBytes / ranks.size(); }

/// Each rank holds all of the geometry, so the smallest share decides what a job can hold.
void findMemory(const std::map<std::string, RankList>& hosts, Diagnosis& diagnosis) {
  uint64_t most = 0;
  for (const auto& [host, ranks] : hosts) most = std::max(most, shareOf(ranks));
  for (const auto& [host, ranks] : hosts) {
    const RankFacts& rank = *ranks[0];
    const std::string available =
        host + " has " + inGigabytes(rank.availableBytes) + " GB of memory available";
    if (rank.availableBytes < rank.memoryBytes / 10)
      diagnosis.limited("memory", available + " of " + inGigabytes(rank.memoryBytes) + " GB",
                        "end other programs there, or start the job without this host");
    else if (shareOf(ranks) < most / 2)
      diagnosis.limited("memory",
                        available + ", " + inGigabytes(shareOf(ranks)) +
                            " GB for each rank; on other hosts each rank has up to " + inGigabytes(most) +
                            " GB. Each rank holds all of the geometry, so the smallest one is the limit",
                        ranks.size() > 1 ? "fewer ranks on the host, or leave it out" : "leave the host out");
  }
}

}  // namespace

bool isKnown(const RankFacts& rank) { return rank.answered && !rank.mpi.empty(); }

std::string inGigabytes(uint64_t bytes) { return fixed(static_cast<double>(bytes) / (uint64_t{1} << 30), 1); }

void findFaults(const JobFacts& facts, Diagnosis& diagnosis) {
  findVersions(facts, diagnosis);
  findSilent(facts, diagnosis);
  const auto hosts = byText(knownRanks(facts), [](const RankFacts& rank) { return rank.host; });
  for (const auto& [host, ranks] : hosts) {
    findBound(host, ranks, diagnosis);
    findCrowded(host, ranks, diagnosis);
    findFullShm(host, *ranks[0], diagnosis);
  }
  findMemory(hosts, diagnosis);
}

}  // namespace gluray::launcher
