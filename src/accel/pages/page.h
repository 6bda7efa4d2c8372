// A page: a mesh whose arrays are loaded, and whose acceleration structure is built, when a ray hits its
// bounds. Owned by the Blas that represents it; entered on tracing threads.
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

  /// Bounds of all hits, object space.
  Bounds bounds() const { return {mesh_.lower, mesh_.upper}; }
  /// The bounds, enlarged by the rounding error of single precision.
  const Bounds& widened() const { return widened_; }
  /// The box of the whole mesh, if this is its first page; otherwise null.
  const scene::Residence::Whole* whole() const { return mesh_.residence->whole(); }
  /// Returns the structure of its triangles, which stays until leave(); null if it cannot be loaded. May wait
  /// for it.
  RTCSceneTy* enter() noexcept;
  void leave() noexcept { users_.fetch_sub(1); }

 private:
  friend class PageCache;
  enum class State : uint8_t {
    absent,
    coming,  // a thread is loading it
    ready,
    leaving,  // the cache is checking whether it is in use
  };

  PageCache& cache_;
  scene::Mesh mesh_;  // only positions and indices
  const Bounds widened_;
  std::atomic<State> state_{State::absent};
  std::atomic<uint32_t> users_{0};
  std::atomic<uint64_t> lastUsed_{0};
  // Guarded by the cache.
  BlasPtr blas_;
  size_t bytes_ = 0;        // of arrays and structure, while it is ready
  bool loaded_ = false;     // the arrays are in memory
  uint64_t retiredAt_ = 0;  // time since when only readers of hits may need the arrays; 0: other uses
};

}  // namespace gluray::accel
