#include "dist/worker/tracing_thread.h"

#include "base/clock.h"

#include <exception>
#include <utility>

namespace gluray::dist {

TracingThread::TracingThread(ArrayStore& store, Outbox& outbox, int threads)
    : store_(store),
      outbox_(outbox),
      threads_(threads),
      decoder_([&store](const Hash128& name) { return store.find(name); }),
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
  try {
    if (!store_.waitFor(task.order.needs, [&] { return task.tiles->isClosed(); })) return;
    render(task, result);
  } catch (const std::exception& error) { result.error = error.what(); }
  result.improves = renderer_.improves();
  outbox_.push(task.head, forRanks(result));
}

void TracingThread::render(const Task& task, Finished& result) {
  const std::shared_ptr<scene::Snapshot> snapshot = decoder_.decode(task.order.snapshot);
  snapshot->settings.threads = threads_;
  image_.missColor = task.order.missColor;
  if (task.order.shared) {
    renderer_.renderTiles(*snapshot, image_, result.cost, result.error, *task.tiles, task.order.averages);
  } else {
    const double start = nowSeconds();
    if (renderer_.render(*snapshot, image_, result.cost, result.error))
      task.tiles->doneAll(image_, nowSeconds() - start);
  }
  result.layers = image_.layers;
}

}  // namespace gluray::dist
