#include "doctor/job_findings.h"

#include "doctor/job_faults.h"
#include "text_table.h"

#include <algorithm>
#include <set>

namespace gluray::launcher {
namespace {

using cluster::JobFacts;
using cluster::RankFacts;

std::string counted(size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string coresText(const RankFacts& rank) {
  const std::string all = std::to_string(rank.hostCores);
  if (rank.usableCores == 0 || rank.usableCores >= rank.hostCores) return "all " + all + " cores";
  return std::to_string(rank.usableCores) + " of " + all + " cores (" + rank.cores + ")";
}

std::string placeText(const RankFacts& rank) {
  if (rank.ranksHere <= 1) return rank.host + ": ";
  return rank.host + " (" + std::to_string(rank.rankHere + 1) + " of " + std::to_string(rank.ranksHere) +
         " there): ";
}

void sayJob(const std::string& job, const JobFacts& facts, Diagnosis& diagnosis) {
  const RankFacts* first = nullptr;  // whose version is this program's
  size_t threads = 0;
  std::set<std::string> hosts;
  for (const RankFacts& rank : facts.ranks) {
    if (!isKnown(rank)) continue;
    if (!first) first = &rank;
    threads += static_cast<size_t>(std::max(rank.threads, 0));
    hosts.insert(rank.host);
  }
  std::string text = "\"" + job + "\" answers: " + counted(facts.ranks.size(), "rank", "ranks");
  if (first)
    text += " on " + counted(hosts.size(), "host", "hosts") + ", " + counted(threads, "thread", "threads") +
            ", " + first->mpi + ", GLuRay " + first->version + " as this program, " +
            (first->isBigEndian ? "big-endian" : "little-endian");
  diagnosis.ok("job", text);
}

void sayRank(const RankFacts& rank, Diagnosis& diagnosis) {
  std::string text = placeText(rank) +
                     counted(static_cast<size_t>(std::max(rank.threads, 0)), "thread", "threads") + " on " +
                     coresText(rank) + "; " + inGigabytes(rank.memoryBytes) + " GB of memory, " +
                     inGigabytes(rank.availableBytes) + " GB of it available; /dev/shm " +
                     inGigabytes(rank.shmFreeBytes) + " GB free";
  if (!rank.hugePages.empty()) text += "; huge pages: " + rank.hugePages;
  diagnosis.ok("rank " + std::to_string(rank.rank), text);
}

}  // namespace

std::string ranksText(const std::vector<int>& ranks) {
  std::string text = ranks.size() == 1 ? "rank " : "ranks ";
  for (size_t i = 0; i < ranks.size();) {
    size_t last = i;
    while (last + 1 < ranks.size() && ranks[last + 1] == ranks[last] + 1) ++last;
    if (i > 0) text += ", ";
    text += std::to_string(ranks[i]);
    if (last > i) text += (last == i + 1 ? ", " : "-") + std::to_string(ranks[last]);
    i = last + 1;
  }
  return text;
}

void judgeJob(const std::string& job, const JobFacts& facts, Diagnosis& diagnosis) {
  sayJob(job, facts, diagnosis);
  for (const RankFacts& rank : facts.ranks)
    if (isKnown(rank)) sayRank(rank, diagnosis);
  findFaults(facts, diagnosis);
}

}  // namespace gluray::launcher
