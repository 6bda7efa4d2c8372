#include "cluster/worker/tracing_thread.h"

#include "base/clock.h"
#include "cluster/gather/merged.h"
#include "cluster/pages/paged_tiles.h"
#include "cluster/worker/moving/moving_tiles.h"
#include "render/moving/moving_frame.h"

#include <exception>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr size_t kMaxGatheredScenes = 4;

}  // namespace

TracingThread::TracingThread(ArrayStore& store, Outbox& outbox, int threads, PeerExchange* peers,
                             PageStore* pages)
    : store_(store),
      outbox_(outbox),
      threads_(threads),
      peers_(peers),
      pages_(pages),
      renderer_(peers ? frame::Renderer::Threads::own : frame::Renderer::Threads::shared),
      decoder_([&store](const Hash128& name) { return store.find(name); }, pages),
      thread_([this] { run(); }) {}

TracingThread::~TracingThread() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  more_.notify_all();
  thread_.join();
}

void TracingThread::add(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  more_.notify_all();
}

void TracingThread::run() {
  for (;;) {
    Task task;
    {
      std::unique_lock lock(mutex_);
      more_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
      if (ends_) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    trace(task);
  }
}

void TracingThread::trace(const Task& task) {
  Finished result;
  result.id = task.order.id;
  sent_ = false;
  const double start = nowSeconds();
  const auto whole = [&] {
    result.layers = image_.layers;
    task.tiles->doneAll(image_, nowSeconds() - start);
    send(task, result);
  };
  if (peers_) peers_->start(task.order.averages, task.order.meetsPeers, whole);
  try {
    if (!store_.waitFor(task.order.needs, [&] { return task.tiles->isClosed(); })) return;
    const std::shared_ptr<scene::Snapshot> snapshot = decode(task.order);
    snapshot->settings.threads = threads_;
    image_.missColor = task.order.missColor;
    render(task, *snapshot, result);
    if (!task.order.shared && !sent_ && result.error.empty()) whole();
  } catch (const std::exception& error) { result.error = error.what(); }
  if (peers_) peers_->finish();
  if (!sent_) send(task, result);
}

std::shared_ptr<scene::Snapshot> TracingThread::decode(const TraceOrder& order) {
  std::shared_ptr<scene::Snapshot> snapshot = decoder_.decode(order.snapshot);
  if (order.parts.empty()) return gathered_.clear(), snapshot;
  std::vector<std::shared_ptr<scene::Snapshot>> parts;
  for (const std::vector<std::byte>& part : order.parts) parts.push_back(decoder_.decode(part));
  merge(parts, *snapshot);
  gathered_.push_back(snapshot);
  if (gathered_.size() > kMaxGatheredScenes) gathered_.pop_front();
  return snapshot;
}

void TracingThread::send(const Task& task, Finished& result) {
  result.improves = renderer_.improves();
  outbox_.push(task.head, forRanks(result));
  sent_ = true;
}

void TracingThread::render(const Task& task, const scene::Snapshot& snapshot, Finished& result) {
  if (task.order.moving.isMoving) return renderMoving(task, snapshot, result);
  if (!pages_) return renderHere(task, snapshot, *task.tiles, result);
  pages_->begin([&] { return task.tiles->isClosed(); });
  PagedTiles tiles(*task.tiles, *pages_);
  renderHere(task, snapshot, tiles, result);
  if (const std::string why = pages_->end(); result.error.empty()) result.error = why;
}

void TracingThread::renderMoving(const Task& task, const scene::Snapshot& snapshot, Finished& result) {
  const MovingOrder& order = task.order.moving;
  MovingTiles tiles(*task.tiles, store_, order.index);
  renderer_.renderMoving(snapshot, image_, result.cost, result.error, tiles, task.order.averages,
                         {order.raysOfPixel, order.quarter});
}

void TracingThread::renderHere(const Task& task, const scene::Snapshot& snapshot, render::TileSource& tiles,
                               Finished& result) {
  if (task.order.shared) {
    renderer_.renderTiles(snapshot, image_, result.cost, result.error, tiles, task.order.averages);
    result.layers = image_.layers;
  } else if (peers_ && task.order.meetsPeers) {
    do {
      renderer_.renderPart(snapshot, image_, result.cost, result.error, *peers_, peers_->averages(), *peers_);
    } while (result.error.empty() && peers_->again());
  } else {
    renderer_.render(snapshot, image_, result.cost, result.error);
  }
}

}  // namespace gluray::cluster
