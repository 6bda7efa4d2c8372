// Divides the large meshes of a program's snapshots into pages, and sends pages to the ranks that need them.
// Called on the main thread. It has two threads of its own, because dividing takes seconds, in which ranks
// request pages.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/messages/page_messages.h"
#include "cluster/pages/paged_mesh.h"
#include "cluster/ranks/outbox.h"
#include "cluster/stream/snapshot_decoder.h"
#include "cluster/stream/snapshot_encoder.h"
#include "parallel/arena.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class PageMaker {
 public:
  /// Sends PagesMade to `self`, this rank. `threads`: that cut meshes. All must outlive it.
  PageMaker(ArrayStore& store, Outbox& outbox, int self, int threads);
  /// Discards unfinished jobs.
  ~PageMaker();
  PageMaker(const PageMaker&) = delete;
  PageMaker& operator=(const PageMaker&) = delete;

  struct Job {
    uint64_t number = 0;   // for PagesMade
    uint64_t program = 0;  // its pages stay for this snapshot and the one before
    std::vector<std::byte> snapshot;
    std::vector<Hash128> needs;                    // arrays that may still be on their way
    uint32_t mostTriangles = 1;                    // of a page
    std::shared_ptr<std::atomic<bool>> cancelled;  // whoever sets it calls store.wake(), too
  };
  void make(Job job);
  void give(int rank, const PageWanted& wanted);
  void forget(uint64_t program);

 private:
  struct Asked {
    int rank = 0;
    Hash128 id;
  };
  using MeshPtr = std::shared_ptr<const PagedMesh>;
  void cutAll();
  void giveAll();
  void cut(const Job& job);
  /// Divides the large meshes of the snapshot into pages.
  std::vector<MeshPtr> divide(scene::Snapshot& snapshot, const Job& job);
  /// Divides these instances. Returns for each new instance the index of its former instance.
  std::vector<size_t> divide(std::vector<scene::Instance>& instances,
                             const std::vector<scene::Shading>& shadings, const Job& job,
                             std::vector<MeshPtr>& meshes);
  MeshPtr pagesOf(const scene::Instance& instance, uint32_t mostTriangles);
  void keep(uint64_t program, std::vector<MeshPtr> meshes);
  std::vector<std::byte> contentOf(const Hash128& id);

  ArrayStore& store_;
  Outbox& outbox_;
  const int self_;
  Arena arena_;
  SnapshotDecoder decoder_;
  SnapshotEncoder encoder_;
  ArrayNames names_;
  std::mutex mutex_;
  std::condition_variable moreJobs_, moreAsked_;
  std::deque<Job> jobs_;
  std::deque<Asked> asked_;
  std::map<uint64_t, std::deque<std::vector<MeshPtr>>> kept_;           // by program, the last ones
  std::unordered_map<Hash128, std::weak_ptr<const PagedMesh>> meshes_;  // by PagedMesh::id
  struct Place {
    std::weak_ptr<const PagedMesh> mesh;
    size_t page = 0;
  };
  std::unordered_map<Hash128, Place> places_;  // of pages
  bool ends_ = false;
  std::thread cutting_, giving_;
};

}  // namespace gluray::cluster
