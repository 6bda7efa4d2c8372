#include "gl/programs/nearest_family.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

size_t countShared(const Program& program, const Family& family) {
  const auto isMentioned = [&](const auto& variable) { return family.mentions(variable.first); };
  return static_cast<size_t>(std::ranges::count_if(program.attributes, isMentioned) +
                             std::ranges::count_if(program.uniforms, isMentioned));
}

}  // namespace

void NearestFamily::take(const Program& program, const Family& family, bool codeAlone,
                         std::vector<std::string> obstacles) {
  if (!family.rasteriseBecause.empty() || family.hasBuiltInVertices() != readsFixedVertices(program)) return;
  const size_t shared = countShared(program, family);
  if (!isBeatenBy(codeAlone, shared, obstacles.size())) return;
  family_ = &family, codeAlone_ = codeAlone, shared_ = shared, obstacles_ = std::move(obstacles);
}

bool NearestFamily::isBeatenBy(bool codeAlone, size_t shared, size_t obstacles) const {
  if (!family_) return codeAlone || shared > 0;
  if (codeAlone != codeAlone_) return codeAlone;
  return shared != shared_ ? shared > shared_ : obstacles < obstacles_.size();
}

std::string NearestFamily::text() const {
  if (!family_) return "";
  constexpr size_t kSaid = 4;
  std::string text = "; nearest: " + family_->name;
  for (size_t i = 0; i < obstacles_.size() && i < kSaid; ++i)
    text.append(i ? ", " : ", but it ").append(obstacles_[i]);
  if (obstacles_.size() > kSaid)
    text.append(" and ").append(std::to_string(obstacles_.size() - kSaid)).append(" more");
  if (codeAlone_)
    text.append("; statements that do not affect the image can be added to [[code]] section \"")
        .append(family_->code.back())
        .append("\" by a file for --program-families");
  return text;
}

}  // namespace gluray::gl
