// A page: a mesh whose arrays are loaded, and whose structure is built, when a ray meets its bounds. Owned by
// the Blas that stands for it; entered on tracing threads.
#pragma once
#include "accel/meshes/blas.h"
#include "accel/rays/bounds.h"
#include "scene/mesh.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

struct RTCSceneTy;

namespace gluray::accel {

class PageCache;

class Page {
 public:
  /// `cache` must outlive it.
  Page(PageCache& cache, const scene::Mesh& mesh);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Of all hits, object space.
  Bounds bounds() const { return {mesh_.lower, mesh_.upper}; }
  /// The same, and some roundings around it.
  const Bounds& widened() const { return widened_; }
  /// The box of the mesh that it is the first page of; null: it is a later one.
  const scene::Residence::Whole* whole() const { return mesh_.residence->whole(); }
  /// The structure of its triangles, which stays until leave(); null: it cannot be had. May wait for it.
  RTCSceneTy* enter() noexcept;
  void leave() noexcept { users_.fetch_sub(1); }

 private:
  friend class PageCache;
  enum class State : uint8_t {
    absent,
    coming,  // some thread loads it
    ready,
    leaving,  // the cache looks whether it is in use
  };

  PageCache& cache_;
  scene::Mesh mesh_;  // positions and indices alone
  const Bounds widened_;
  std::atomic<State> state_{State::absent};
  std::atomic<uint32_t> users_{0};
  std::atomic<uint64_t> lastUsed_{0};
  // Guarded by the cache.
  BlasPtr blas_;
  size_t bytes_ = 0;        // of arrays and structure, while it is ready
  bool loaded_ = false;     // the arrays are in memory
  uint64_t retiredAt_ = 0;  // since when only readers of hits may need the arrays; 0: not so
};

}  // namespace gluray::accel
