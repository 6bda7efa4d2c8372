#include "cluster/worker/worker.h"

#include "base/clock.h"
#include "cluster/messages/version.h"
#include "control/local_socket.h"
#include "parallel/arena.h"

#include <poll.h>
#include <sys/socket.h>

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

// How long the loop may sleep, which messages of other ranks do not end.
constexpr double kAwake = 0.1;  // seconds after the last work, in which more of it is likely
constexpr int kMaxAtOnce = 64;  // messages between two looks at all else
constexpr timespec kActive{0, 50'000}, kIdle{0, 1'000'000}, kAlone{0, 100'000'000};

int threadsOf(int threads) { return threads > 0 ? threads : Arena(0).threads(); }

}  // namespace

Worker::Worker(Ranks& ranks, int threads, size_t memory, control::Descriptor listening, Head::Say say)
    : ranks_(ranks),
      threads_(threadsOf(threads)),
      intake_(store_, outbox_, ranks.rank(), threads_),
      pages_(store_, outbox_, memory, say),
      pageMaker_(store_, outbox_, ranks.rank(), threads_),
      peers_(ranks, store_, outbox_, threads_, say),
      inquiry_(ranks, threads_),
      roll_(ranks, version(), say),
      head_(ranks, store_, intake_, pageMaker_, peers_, inquiry_, threads_, memory, say),
      member_(ranks, store_, outbox_, pages_, threads_),
      listening_(std::move(listening)),
      say_(std::move(say)) {}

void Worker::meet(const std::atomic<bool>& stop) {
  while (!stop && !roll_.isOver()) goOn();
}

void Worker::run(const std::atomic<bool>& stop) {
  while (!stop) goOn();
}

void Worker::goOn() {
  if (handleArrivals() || head_.isBusy() || member_.isBusy() || peers_.isBusy()) lastBusy_ = nowSeconds();
  wait();
}

bool Worker::handleArrivals() {
  const double now = nowSeconds();
  bool found = false;
  accept();
  head_.readPrograms(now);
  for (Outbox::Letter& letter : outbox_.takeLetters())
    ranks_.send(letter.to, std::move(letter.message)), found = true;
  ranks_.progress();
  for (int i = 0; i < kMaxAtOnce; ++i) {
    const std::optional<RankMessage> message = ranks_.receive();
    if (!message) break;
    handle(*message, now), found = true;
  }
  head_.tick(now);
  member_.tick(now);
  peers_.tick(now);
  inquiry_.tick(now);
  roll_.tick(now);
  return found;
}

void Worker::handle(const RankMessage& message, double now) {
  const int from = message.from;
  try {
    ByteReader in(message.bytes);
    const auto type = in.get<uint16_t>();
    if (type == RankHello::kType) return roll_.takeHello(from, in.readBytes(in.left()));
    const auto as = [&]<class M>(M) { return decoded<M>(in.readBytes(in.left())); };
    switch (type) {
      case AllAreAlike::kType: as(AllAreAlike{}); return roll_.takeEnd();
      case ArrayChecked::kType:
        if (from != ranks_.rank()) throw Malformed("it is for the sender alone");
        return head_.receive(as(ArrayChecked{}));
      case PagesMade::kType:
        if (from != ranks_.rank()) throw Malformed("it is for the sender alone");
        return head_.receive(as(PagesMade{}), now);
      case PageWanted::kType: return pageMaker_.give(from, as(PageWanted{}));
      case PageGiven::kType: return pages_.receivePage(as(PageGiven{}));
      case TurnWanted::kType: return member_.receive(from, as(TurnWanted{}));
      case Turn::kType: return member_.receive(as(Turn{}));
      case Forget::kType: return member_.receive(from, as(Forget{}));
      case TraceOrder::kType: return member_.receive(from, as(TraceOrder{}), now);
      case MoreTiles::kType: return member_.receive(from, as(MoreTiles{}));
      case VisibilityReady::kType: return member_.receive(from, as(VisibilityReady{}));
      case CollectedTile::kType: return head_.receive(from, as(CollectedTile{}), now);
      case EndOfImage::kType: return member_.receive(from, as(EndOfImage{}));
      case TracedTile::kType: return head_.receive(from, as(TracedTile{}), now);
      case CaughtUp::kType: as(CaughtUp{}); return head_.takeCaughtUp(from, now);
      case Finished::kType: return head_.receive(from, as(Finished{}), now);
      case Alive::kType: return head_.receive(from, as(Alive{}), now);
      case FactsWanted::kType: return inquiry_.receive(from, as(FactsWanted{}));
      case FactsGiven::kType: return inquiry_.receive(from, as(FactsGiven{}));
      default:
        if (!peers_.receive(from, type, in.readBytes(in.left()), now))
          throw Malformed("its kind is not known");
    }
  } catch (const Malformed& error) { say_("rank " + std::to_string(from) + ": " + error.what()); }
}

void Worker::accept() {
  if (listening_.get() < 0 || !roll_.isOver()) return;
  for (;;) {
    control::Descriptor socket(::accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    if (socket.get() < 0) return;
    if (control::sameUser(socket.get())) head_.add(std::move(socket));
  }
}

void Worker::wait() {
  std::vector<pollfd> all{{outbox_.descriptor(), POLLIN, 0}};
  if (listening_.get() >= 0 && roll_.isOver()) all.push_back({listening_.get(), POLLIN, 0});
  for (const int socket : head_.descriptors()) all.push_back({socket, POLLIN, 0});
  const bool active = ranks_.busy() || nowSeconds() - lastBusy_ < kAwake;
  const timespec* const longest = ranks_.size() == 1 && !ranks_.busy() ? &kAlone : active ? &kActive : &kIdle;
  ppoll(all.data(), all.size(), longest, nullptr);
}

}  // namespace gluray::cluster
