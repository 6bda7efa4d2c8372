// Display lists: recorded by ListCompiler, executed by us. GL threads: several may call a list of their share
// group.
#pragma once
#include "gl/context/context.h"

#include <memory>
#include <mutex>
#include <vector>

namespace gluray::gl {

/// One recorded step of a list.
class ListOp {
 public:
  virtual ~ListOp() = default;
  virtual void execute(Context& context) = 0;
};

/// A recorded call with its arguments. `anywhere`: it is legal between glBegin and glEnd, where a list may be
/// called.
template <class Call>
class CallOp final : public ListOp {
 public:
  CallOp(Call call, bool anywhere) : call_(std::move(call)), anywhere_(anywhere) {}
  void execute(Context& context) override {
    if (!anywhere_ && context.immediate.insideBegin()) return context.errors.set(GL_INVALID_OPERATION);
    if (!anywhere_) context.immediate.closeRunIfOpen();
    call_(context);
  }

 private:
  Call call_;
  bool anywhere_;
};

/// A fragment: commands that we do not model, compiled by the real OpenGL into a list of its own.
class FragmentOp final : public ListOp {
 public:
  FragmentOp(GLuint realList, std::weak_ptr<ShareGroup> group)
      : realList_(realList), group_(std::move(group)) {}
  ~FragmentOp() override;
  void execute(Context& context) override;

 private:
  GLuint realList_;
  std::weak_ptr<ShareGroup> group_;
};

class DisplayList {
 public:
  /// After this, the next append() does not allocate.
  void makeRoom() {
    if (ops_.size() == ops_.capacity()) ops_.reserve(ops_.size() * 2 + 4);
  }
  void append(std::unique_ptr<ListOp> op) { ops_.push_back(std::move(op)); }
  void execute(Context& context) const {
    for (const auto& op : ops_) op->execute(context);
  }

 private:
  std::vector<std::unique_ptr<ListOp>> ops_;
};

}  // namespace gluray::gl
