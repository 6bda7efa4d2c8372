// The arrays of a head's programs: who has them, and which ranks need them.
#include "cluster/worker/head.h"

namespace gluray::cluster {

void Head::takeArray(ConnectedProgram& program, const ArrayComes& array, const control::Descriptor& memory) {
  if (program.arrays.contains(array.name)) return;
  if (!holders_.contains(array.name)) {
    // Other programs may use it by this name.
    intake_.add(++lastCheck_, array.name, mapSealed(memory, array.bytes));
    holders_[array.name].check = lastCheck_;
  }
  Holders& holders = holders_[array.name];
  ++holders.programs;
  holders.bytes = array.bytes;
  program.arrayBytes += array.bytes;
  if (program.spreads && !isLarge(program)) holders.shared = true;
  spread(array.name, holders);
  program.arrays.insert(array.name);
  program.newArrays.push_back(array.name);
}

void Head::receive(const ArrayChecked& checked) {
  const auto found = holders_.find(checked.name);
  if (found == holders_.end() || found->second.check != checked.number) return;  // forgotten since
  if (checked.isRight) {
    found->second.here = true;
    return spread(checked.name, found->second);
  }
  for (ConnectedProgram& program : programs_) {
    if (!program.arrays.contains(checked.name)) continue;
    say_(program.name + ": an array is not what its name says; it is disconnected");
    program.end();
  }
}

void Head::spread(const Hash128& name, Holders& holders) {
  if (ranks_.size() == 1 || !holders.here || !holders.shared || holders.everywhere) return;
  holders.everywhere = true;
  const Array array = store_.find(name);
  store_.put(ranks_.rank(), name, array);  // until it has been broadcast
  ranks_.send(kCoordinator, forRanks(TurnWanted{name, array.bytes.size()}));
}

void Head::spreadAll(ConnectedProgram& program) {
  program.spreads = true;
  for (const Hash128& name : program.arrays) holders_[name].shared = true, spread(name, holders_[name]);
}

void Head::forget(ConnectedProgram& program, const std::vector<Hash128>& names) {
  Forget all, here;
  for (const Hash128& name : names) {
    if (program.arrays.erase(name) == 0) continue;
    Holders& holders = holders_[name];
    program.arrayBytes -= holders.bytes;
    if (--holders.programs > 0) continue;
    (holders.everywhere ? all : here).names.push_back(name);
    holders_.erase(name);
  }
  std::erase_if(program.newArrays, [&](const Hash128& name) { return !program.arrays.contains(name); });
  for (int rank = 0; rank < ranks_.size() && !all.names.empty(); ++rank) ranks_.send(rank, forRanks(all));
  if (!here.names.empty()) store_.forget(ranks_.rank(), here.names);
}

}  // namespace gluray::cluster
