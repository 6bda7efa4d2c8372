// What the parts of a Context have in common (docs/adr/0030). GL thread.
#pragma once

namespace gluray::gl {

class Context;

/// A class that is a member of one context and uses what is public there.
class ContextPart {
 public:
  explicit ContextPart(Context& context) : c_(context) {}
  ContextPart(const ContextPart&) = delete;
  ContextPart& operator=(const ContextPart&) = delete;

 protected:
  ~ContextPart() = default;

  Context& c_;
};

}  // namespace gluray::gl
