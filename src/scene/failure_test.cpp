#include "scene/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <system_error>

namespace gluray::scene {
namespace {

TEST(Failure, LossFollowsTheKindOfException) {
  EXPECT_EQ(lossOf(Untraceable("a matrix")), Loss::draws);
  EXPECT_EQ(lossOf(std::bad_alloc()), Loss::frames);
  EXPECT_EQ(lossOf(Failure("no memory for a structure", Loss::frames)), Loss::frames);
  EXPECT_EQ(lossOf(std::system_error(EAGAIN, std::generic_category())), Loss::frames);
  EXPECT_EQ(lossOf(std::system_error(ENOMEM, std::system_category())), Loss::frames);
  EXPECT_EQ(lossOf(std::system_error(EACCES, std::generic_category())), Loss::tracing);
  EXPECT_EQ(lossOf(std::logic_error("a bug")), Loss::tracing);
  EXPECT_EQ(lossOf(std::runtime_error("anything else")), Loss::tracing);
}

}  // namespace
}  // namespace gluray::scene
