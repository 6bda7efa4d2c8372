#include "accel/pages/page_cache.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::accel {
namespace {

/// Embree's triangles may be hit a few roundings beside the box of their corners.
Bounds widenedBounds(const scene::Mesh& mesh) {
  const glm::vec3 most = glm::max(glm::abs(mesh.lower), glm::abs(mesh.upper));
  const glm::vec3 by = 1e-5f * (mesh.upper - mesh.lower) + 1e-6f * most;
  return {mesh.lower - by, mesh.upper + by};
}

scene::Mesh geometryOf(const scene::Mesh& mesh) {
  scene::Mesh geometry;
  geometry.geometryId = mesh.geometryId;
  geometry.triangleCount = mesh.triangleCount, geometry.vertexCount = mesh.vertexCount;
  geometry.positions = mesh.positions, geometry.indices = mesh.indices;
  geometry.lower = mesh.lower, geometry.upper = mesh.upper;
  geometry.residence = mesh.residence;
  return geometry;
}

}  // namespace

Page::Page(PageCache& cache, const scene::Mesh& mesh)
    : cache_(cache), mesh_(geometryOf(mesh)), widened_(widenedBounds(mesh)) {
  cache_.add(*this);
}

Page::~Page() { cache_.remove(*this); }

RTCSceneTy* Page::enter() noexcept {
  users_.fetch_add(1);
  if (state_.load() == State::ready) {
    lastUsed_.store(cache_.clock_.load(std::memory_order_relaxed), std::memory_order_relaxed);
    return blas_->scene();
  }
  users_.fetch_sub(1);
  return cache_.load(*this);
}

void PageCache::add(Page&) {
  const std::lock_guard lock(mutex_);
  const size_t all = pages_ + 1;
  if (byUse_.capacity() < all) {
    const size_t room = 2 * all;
    ready_.reserve(room), retired_.reserve(room), byUse_.reserve(room);
  }
  pages_ = all;
}

void PageCache::remove(Page& page) {
  const std::lock_guard lock(mutex_);
  std::erase(ready_, &page);
  std::erase(retired_, &page);
  count(page.bytes_, 0);
  if (page.loaded_) page.mesh_.residence->drop();
  --pages_;
}

void PageCache::count(size_t gone, size_t come) noexcept {
  bytes_ += come, bytes_ -= gone;
  mostBytes_ = std::max(mostBytes_.load(), bytes_.load());
}

RTCSceneTy* PageCache::load(Page& page) noexcept {
  using State = Page::State;
  try {
    Lock lock(mutex_);
    came_.wait(lock, [&] { return page.state_ != State::coming; });
    page.users_.fetch_add(1);  // from now on it is not freed
    page.lastUsed_ = clock_.load();
    if (page.state_ != State::ready) {
      page.state_ = State::coming;
      page.state_ = build(page, lock) ? State::ready : State::absent;
      came_.notify_all();
    }
    if (page.state_ == State::ready) return page.blas_->scene();
    page.users_.fetch_sub(1);
    return nullptr;
  } catch (const std::exception&) { return nullptr; }  // the mutex cannot be locked: nothing else throws
}

bool PageCache::build(Page& page, Lock& lock) {
  scene::Residence& residence = *page.mesh_.residence;
  ++clock_, ++loads_;
  if (page.retiredAt_ != 0) std::erase(retired_, &page), page.retiredAt_ = 0;
  const size_t arrays = residence.bytes(), budget = residence.budget();
  const bool loaded = page.loaded_;
  if (!loaded) count(0, arrays), page.bytes_ = arrays;
  page.loaded_ = true;
  // A structure takes about twice the memory of its arrays.
  makeRoom(budget - std::min(budget, 2 * arrays));
  BlasPtr blas;
  lock.unlock();
  try {
    if (loaded || residence.load())
      blas = Blas::buildAlone(device_, iota_, Geometry{&page.mesh_, {}}, BvhQuality::fast);
  } catch (const std::exception& error) {
    blas = nullptr;
    residence.fail(error.what());
  }
  lock.lock();
  if (!blas) return drop(page), false;
  count(0, blas->bvhBytes());
  page.bytes_ += blas->bvhBytes();
  page.blas_ = std::move(blas);
  makeRoom(budget);
  ready_.push_back(&page);
  return true;
}

void PageCache::makeRoom(size_t most) noexcept {
  if (bytes_ <= most) return;
  // Other threads change the times of use while these are sorted.
  byUse_.clear();
  for (Page* const page : ready_) byUse_.emplace_back(page->lastUsed_.load(), page);
  std::ranges::sort(byUse_);
  for (const auto& [lastUsed, page] : byUse_) {
    if (bytes_ <= most) break;
    retire(*page);
  }
}

/// False: it is in use.
bool PageCache::retire(Page& page) noexcept {
  page.state_ = Page::State::leaving;
  if (page.users_ != 0) return page.state_ = Page::State::ready, false;
  page.state_ = Page::State::absent;
  std::erase(ready_, &page);
  const size_t structure = page.blas_->bvhBytes();
  page.blas_.reset();
  count(structure, 0);
  page.bytes_ -= structure;
  page.retiredAt_ = ++clock_;
  retired_.push_back(&page);
  if (readers_.empty()) sweep();
  return true;
}

void PageCache::drop(Page& page) noexcept {
  page.mesh_.residence->drop();
  count(page.bytes_, 0);
  page.bytes_ = 0, page.loaded_ = false, page.retiredAt_ = 0;
}

uint64_t PageCache::startReading() {
  const std::lock_guard lock(mutex_);
  return *readers_.insert(clock_.load());
}

void PageCache::endReading(uint64_t at) {
  const std::lock_guard lock(mutex_);
  readers_.erase(readers_.find(at));
  if (!retired_.empty()) sweep();
}

/// Drops the arrays that no reader may need.
void PageCache::sweep() noexcept {
  const uint64_t oldest = readers_.empty() ? UINT64_MAX : *readers_.begin();
  std::erase_if(retired_, [&](Page* page) {
    if (page->retiredAt_ > oldest) return false;
    drop(*page);
    return true;
  });
}

}  // namespace gluray::accel
