// Totals of all contexts of the process.
#include "intercept/contexts/context_record.h"
#include "intercept/session/guarded.h"

namespace gluray::intercept {
namespace {

void addExplained(Totals& sum, const Record& record) {
  const gl::ContextInfo& info = record.context->info();
  const gl::Statistics& s = record.context->counts.statistics;
  if (!info.kinds) return;
  for (const auto& [kind, cost] : info.kinds->kinds()) sum.kinds[kind] += cost;
  for (const auto& [reason, draws] : info.kinds->notCulled()) sum.notCulled[reason] += draws;
  for (const auto& [reason, draws] : info.kinds->notLit()) sum.notLit[reason] += draws;
  for (const auto& [name, use] : info.kinds->targets()) sum.targets[name] += use;
  for (const auto& [known, use] : info.kinds->programs()) sum.programs[known] += use;
  constexpr const char* apis[] = {"GLX", "EGL", "OSMesa"};
  const bool es = record.version.starts_with("OpenGL ES");
  sum.list.push_back({apis[static_cast<int>(record.api)],
                      es          ? "ES"
                      : info.core ? "core"
                                  : "compatibility",
                      record.version, record.renderer, info.doubleBuffered,
                      s.frames + s.framesInFront + s.framesInMemory, s.frames > 0, s.drawsTraced,
                      s.drawsRasterised});
}

}  // namespace

void addTo(Totals& sum, const Record& record) {
  if (!record.context) return;
  ++sum.contexts;
  sum.statistics += record.context->counts.statistics;
  const auto& calls = record.context->unknownCalls();
  for (size_t i = 0; i < calls.size(); ++i)
    if (calls[i]) sum.unknownCalls[gl::kCommandNames[i].name] += calls[i];
  if (sum.renderer.empty())
    sum.vendor = record.vendor, sum.renderer = record.renderer, sum.version = record.version;
  addExplained(sum, record);
}

Totals totals() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  Totals sum = r.dead;
  for (const auto& [key, record] : r.records) addTo(sum, *record);
  return sum;
}

void closeKinds() noexcept {
  guarded("cannot end the explanation", [] {
    const std::lock_guard lock(registry().mutex);
    for (const auto& [key, record] : registry().records)
      if (record->context && record->context->counts.kinds()) record->context->counts.kinds()->close();
  });
}

}  // namespace gluray::intercept
