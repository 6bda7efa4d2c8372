// A presenter for tests: passes every batch's snapshot to a function and reports it as traced; no drawing.
#pragma once
#include "gl/batch/presenter.h"

#include <functional>
#include <string>
#include <utility>

namespace gluray::test {

class SnapshotTaker final : public gl::Presenter {
 public:
  using Take = std::function<void(const scene::Snapshot&)>;
  explicit SnapshotTaker(Take take) : take_(std::move(take)) {}

  gl::PresentResult present(const gl::RealGl&, const scene::SnapshotPtr& snapshot,
                            const gl::PresentTarget&) noexcept override {
    take_(*snapshot);
    gl::PresentResult result;
    result.outcome = gl::PresentResult::traced;
    return result;
  }
  bool supports(const gl::RealGl&, bool, std::string&) noexcept override { return true; }
  void forget(const gl::RealGl&) noexcept override {}

 private:
  Take take_;
};

}  // namespace gluray::test
