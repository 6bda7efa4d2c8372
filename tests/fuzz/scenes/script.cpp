#include "tests/fuzz/scenes/script.h"

namespace gluray::fuzz {

void Writer::join(size_t count) {
  const auto first = calls.end() - static_cast<ptrdiff_t>(count);
  const std::vector<Call> parts(first, calls.end());
  calls.erase(first, calls.end());
  Role role = Role::other;
  for (const Call& part : parts)
    if (part.role != Role::other) role = part.role;
  calls.push_back({role,
                   [parts](Gl gl, Answers& answers) {
                     for (const Call& part : parts) part.play(gl, answers);
                   },
                   [parts] {
                     std::string text;
                     for (const Call& part : parts) text += (text.empty() ? "" : "; ") + part.text();
                     return text;
                   }});
}

}  // namespace gluray::fuzz
