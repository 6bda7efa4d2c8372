#include "gl/culled/small/placed_positions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gluray::gl {
namespace {

constexpr size_t kMaxEntries = 8;
constexpr uint64_t kManyRuns = 256;  // runs of the shader; beyond these, runs must be rare among draws

/// Records the uniforms that are read, and keeps some uniforms symbolic.
class SymbolicUniforms final : public NotingUniforms {
 public:
  SymbolicUniforms(const CurrentUniforms& uniforms, std::vector<ReadUniform>& noted,
                   const std::set<std::string, std::less<>>& symbolic)
      : NotingUniforms(uniforms, noted), uniforms_(uniforms), symbolic_(symbolic) {}
  bool isSymbolic(std::string_view name) const override {
    CurrentUniforms::Place place;
    return symbolic_.contains(name) && uniforms_.find(name, place);
  }

 private:
  const CurrentUniforms& uniforms_;
  const std::set<std::string, std::less<>>& symbolic_;
};

}  // namespace

bool PlacedPositions::find(const CurrentUniforms& uniforms, PlacedPosition& found) {
  ++calls_;
  Entry* entry = known(uniforms);
  if (!entry) {
    if (runs_ > kManyRuns && 8 * runs_ > calls_) return false;
    entry = &runAgain(uniforms);
  }
  if (!entry->position || !evaluate(*entry, uniforms, found.matrix)) return false;
  found.position = &*entry->position;
  return true;
}

PlacedPositions::Entry* PlacedPositions::known(const CurrentUniforms& uniforms) {
  for (Entry& entry : entries_)
    if (haveSameValues(entry.read, uniforms)) {
      std::swap(entry, entries_.front());
      return &entries_.front();
    }
  return nullptr;
}

/// Uniforms whose values have changed since the last run become symbols, if positions are then still linear.
PlacedPositions::Entry& PlacedPositions::runAgain(const CurrentUniforms& uniforms) {
  Names changed;
  if (!entries_.empty())
    for (const ReadUniform& was : entries_.front().read) {
      CurrentUniforms::Numbers now;
      const bool same = uniforms.read(was.place, now) && now == was.numbers;
      if (!same && !constant_.contains(was.place.name)) changed.insert(was.place.name);
    }
  std::optional<Entry> entry;
  for (const std::string& name : changed) {
    Names more = symbolic_;
    more.insert(name);
    Entry tried = run(uniforms, more);
    // Integers are never symbolic.
    const bool isRead =
        std::ranges::any_of(tried.read, [&](const ReadUniform& r) { return r.place.name == name; });
    if (tried.position && !isRead) {
      symbolic_ = std::move(more), entry = std::move(tried);
      entries_.clear();  // they know fewer symbols
    } else {
      constant_.insert(name);
    }
  }
  if (!entry) entry = run(uniforms, symbolic_);
  if (entries_.size() == kMaxEntries) entries_.pop_back();
  entries_.insert(entries_.begin(), std::move(*entry));
  return entries_.front();
}

PlacedPositions::Entry PlacedPositions::run(const CurrentUniforms& uniforms, const Names& symbolic) {
  ++runs_;
  Entry entry;
  std::string why;
  entry.position = slice_.evaluate(SymbolicUniforms(uniforms, entry.read, symbolic), why);
  if (!entry.position) return entry;
  for (const InstanceColumn& column : entry.position->columns) {
    CurrentUniforms::Place place;
    if (column.column == 0 && uniforms.find(column.attribute, place))
      entry.symbols.push_back(std::move(place));
  }
  return entry;
}

bool PlacedPositions::evaluate(const Entry& entry, const CurrentUniforms& uniforms, ClipMatrix& matrix) {
  const LinearPosition& position = *entry.position;
  if (position.terms.empty()) {
    matrix = {position.clipFromAttribute, position.magnitudes};
    return true;
  }
  std::array<double, LinearPosition::kNumbers> numbers{1};
  size_t count = 1;
  for (const CurrentUniforms::Place& place : entry.symbols) {
    CurrentUniforms::Numbers now;
    if (!uniforms.read(place, now) || count + now.count > numbers.size()) return false;
    std::copy_n(now.values.begin(), now.count, numbers.begin() + static_cast<std::ptrdiff_t>(count));
    count += now.count;
  }
  return position.at(numbers, matrix.clipFromObject, matrix.magnitudes);
}

}  // namespace gluray::gl
