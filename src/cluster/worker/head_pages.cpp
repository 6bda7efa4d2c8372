// The pages of a head's programs: whose geometry is too large for the memory of a rank.
#include "cluster/worker/head.h"

#include <algorithm>
#include <utility>

namespace gluray::cluster {
namespace {

// Of a structure and its arrays, by byte of the arrays: positions and indices of an isosurface take 18 bytes
// a triangle, its structure up to 60.
constexpr uint64_t kStructures = 4;
// Pages that fit the memory of a rank, and what a triangle takes there.
constexpr uint64_t kPagesInMemory = 256, kTriangleBytes = 80;
constexpr uint64_t kMin = 1 << 11, kMax = 1 << 18;  // triangles of a page

}  // namespace

bool Head::isLarge(const ConnectedProgram& program) const {
  const bool gathers = program.peer && program.request && program.request->gathers;
  return program.arrayBytes * kStructures > memory_ / static_cast<uint64_t>(gathers ? program.ranks : 1);
}

bool Head::needsPages(const ConnectedProgram& program) const {
  const bool isOnAllRanks = !program.peer || program.request->gathers;
  return isOnAllRanks && isLarge(program) && !program.request->layered;
}

void Head::makePages(ConnectedProgram& program, double now) {
  ConnectedProgram::Paging& paging = program.paging;
  if (paging.number == 0) {
    paging.number = ++lastPaging_;
    say_(program.name +
         ": its geometry is larger than the memory of a rank, so ranks fetch only the parts that rays hit");
  }
  paging.job = ++lastPaging_;
  paging.cancelled = std::make_shared<std::atomic<bool>>(false);
  program.saidAtWork = now;
  PageMaker::Job job;
  job.number = paging.job, job.program = paging.number;
  job.snapshot = program.request->snapshot;
  job.needs = program.newArrays;
  job.mostTriangles =
      static_cast<uint32_t>(std::clamp(memory_ / (kPagesInMemory * kTriangleBytes), kMin, kMax));
  job.cancelled = paging.cancelled;
  pages_.make(std::move(job));
}

void Head::receive(const PagesMade& made, double now) {
  const auto found =
      std::ranges::find(programs_, made.number, [](const ConnectedProgram& p) { return p.paging.job; });
  if (found == programs_.end() || made.number == 0) return;
  ConnectedProgram& program = *found;
  program.paging.job = 0;
  if (!made.error.empty()) {
    ImageDone failed;
    failed.id = program.request->id, failed.error = made.error;
    failed.shape = {1, 1, 1, Image::kColorDepth};
    return program.send(failed);
  }
  program.paged = program.request;
  program.paged->snapshot = made.snapshot, program.paged->arrays = made.arrays;
  spreadOnly(program, made.arrays);
  askNow(program, now);
}

void Head::endPages(ConnectedProgram& program) {
  if (program.paging.job == 0) return;
  *program.paging.cancelled = true;
  store_.wake();
  program.paging.job = 0;
}

void Head::spreadOnly(ConnectedProgram& program, const std::vector<Hash128>& names) {
  program.spreads = true;
  std::unordered_set<Hash128> wanted(names.begin(), names.end());
  Forget unwanted;
  for (const Hash128& name : program.arrays) {
    Holders& holders = holders_[name];
    if (wanted.contains(name)) {
      holders.shared = true;
      spread(name, holders);
    } else if (holders.everywhere && holders.programs == 1) {
      holders.shared = holders.everywhere = false;
      unwanted.names.push_back(name);
    }
  }
  for (int rank = 0; rank < ranks_.size() && !unwanted.names.empty(); ++rank)
    if (rank != ranks_.rank()) ranks_.send(rank, forRanks(unwanted));
}

}  // namespace gluray::cluster
