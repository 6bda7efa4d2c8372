#include "cluster/pages/page_maker.h"

#include "scene/secondary_scene.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr size_t kSnapshots = 2;  // snapshots of a program

}  // namespace

PageMaker::PageMaker(ArrayStore& store, Outbox& outbox, int self, int threads)
    : store_(store),
      outbox_(outbox),
      self_(self),
      arena_(threads),
      decoder_([&store](const Hash128& name) { return store.find(name); }),
      cutting_([this] { cutAll(); }),
      giving_([this] { giveAll(); }) {}

PageMaker::~PageMaker() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    for (Job& job : jobs_) *job.cancelled = true;
  }
  store_.wake();
  moreJobs_.notify_all(), moreAsked_.notify_all();
  cutting_.join(), giving_.join();
}

void PageMaker::make(Job job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  moreJobs_.notify_all();
}

void PageMaker::give(int rank, const PageWanted& wanted) {
  {
    const std::lock_guard lock(mutex_);
    asked_.push_back({rank, wanted.id});
  }
  moreAsked_.notify_all();
}

void PageMaker::forget(uint64_t program) {
  std::deque<std::vector<MeshPtr>> gone;  // freed without the lock
  const std::lock_guard lock(mutex_);
  std::swap(gone, kept_[program]);
  kept_.erase(program);
}

void PageMaker::cutAll() {
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      moreJobs_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
      if (ends_) return;
      job = jobs_.front();  // stays there, so that the destructor can cancel it
    }
    cut(job);
    const std::lock_guard lock(mutex_);
    jobs_.pop_front();
  }
}

void PageMaker::cut(const Job& job) {
  PagesMade made;
  made.number = job.number;
  try {
    if (!store_.waitFor(job.needs, [&] { return job.cancelled->load(); }) || *job.cancelled) return;
    names_.forgetGone();
    const std::shared_ptr<scene::Snapshot> snapshot = decoder_.decode(job.snapshot);
    keep(job.program, arena_.execute([&] { return divide(*snapshot, job); }));
    EncodedSnapshot encoded = encoder_.encode(*snapshot);
    made.snapshot = std::move(encoded.message);
    for (const ArraySource& source : encoded.arrays) made.arrays.push_back(source.name);
  } catch (const std::exception& error) { made.error = error.what(); }
  outbox_.push(self_, forRanks(made));
}

std::vector<PageMaker::MeshPtr> PageMaker::divide(scene::Snapshot& snapshot, const Job& job) {
  std::vector<MeshPtr> meshes;
  divide(snapshot.instances, snapshot.shadings, job, meshes);
  if (!snapshot.secondaryScene) return meshes;
  auto around = std::make_shared<scene::SecondaryScene>(*snapshot.secondaryScene);
  const std::vector<size_t> from = divide(around->instances, around->shadings, job, meshes);
  around->blended.clear(), around->captured.clear();
  const std::vector<scene::CapturedSurface>& captured = snapshot.secondaryScene->captured;
  for (const size_t i : from) {
    around->blended.push_back(snapshot.secondaryScene->blended[i]);
    if (!captured.empty())
      around->captured.push_back(i < captured.size() ? captured[i] : scene::CapturedSurface{});
  }
  snapshot.secondaryScene = std::move(around);
  return meshes;
}

std::vector<size_t> PageMaker::divide(std::vector<scene::Instance>& instances,
                                      const std::vector<scene::Shading>& shadings, const Job& job,
                                      std::vector<MeshPtr>& meshes) {
  std::vector<scene::Instance> divided;
  std::vector<size_t> from;
  for (size_t i = 0; i < instances.size(); ++i) {
    const scene::Instance& instance = instances[i];
    const bool isLarge = instance.mesh->triangleCount > job.mostTriangles;
    if (*job.cancelled || !isLarge || !PagedMesh::fits(instance, shadings[instance.shading])) {
      divided.push_back(instance), from.push_back(i);
      continue;
    }
    const MeshPtr& mesh = meshes.emplace_back(pagesOf(instance, job.mostTriangles));
    for (size_t page = 0; page < mesh->count(); ++page) {
      scene::Instance& one = divided.emplace_back(instance);
      from.push_back(i);
      one.mesh = mesh->mesh(page);
      one.triangleColors = one.triangleNormals = one.triangleEdges = {};
      one.triangleOffset = 0;
    }
  }
  instances = std::move(divided);
  return from;
}

PageMaker::MeshPtr PageMaker::pagesOf(const scene::Instance& instance, uint32_t mostTriangles) {
  const Hash128 id = PagedMesh::idOf(instance, mostTriangles, self_, names_);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = meshes_.find(id); known != meshes_.end())
      if (MeshPtr mesh = known->second.lock()) return mesh;
  }
  auto mesh = std::make_shared<const PagedMesh>(id, instance, mostTriangles, self_);
  const std::lock_guard lock(mutex_);
  std::erase_if(meshes_, [](const auto& one) { return one.second.expired(); });
  std::erase_if(places_, [](const auto& one) { return one.second.mesh.expired(); });
  meshes_[id] = mesh;
  for (size_t page = 0; page < mesh->count(); ++page) places_[mesh->idOf(page)] = {mesh, page};
  return mesh;
}

void PageMaker::keep(uint64_t program, std::vector<MeshPtr> meshes) {
  std::vector<MeshPtr> gone;  // freed without the lock
  const std::lock_guard lock(mutex_);
  auto& kept = kept_[program];
  kept.push_back(std::move(meshes));
  if (kept.size() <= kSnapshots) return;
  gone = std::move(kept.front());
  kept.pop_front();
}

void PageMaker::giveAll() {
  for (;;) {
    Asked asked;
    {
      std::unique_lock lock(mutex_);
      moreAsked_.wait(lock, [this] { return ends_ || !asked_.empty(); });
      if (ends_) return;
      asked = asked_.front();
      asked_.pop_front();
    }
    PageGiven given{asked.id, {}};
    try {
      given.bytes = contentOf(asked.id);
    } catch (const std::bad_alloc&) {}  // the other rank reports that it has not got the page
    outbox_.push(asked.rank, forRanks(given));
  }
}

std::vector<std::byte> PageMaker::contentOf(const Hash128& id) {
  MeshPtr mesh;
  size_t page = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto found = places_.find(id);
    if (found == places_.end()) return {};
    mesh = found->second.mesh.lock(), page = found->second.page;
  }
  return mesh ? mesh->content(page) : std::vector<std::byte>();
}

}  // namespace gluray::cluster
