#include <gtest/gtest.h>

#include <reference/loaded_body.hpp>
#include <reference/taylor.hpp>
#include <rigor/linalg/rotation.hpp>

namespace rigor::reference {
namespace {

using V = Vec3<double>;
using P = Precise;

P apart(const Attitude<P>& a, const Attitude<P>& b) { return (a.R_WB - b.R_WB).norm() + (a.w_B - b.w_B).norm(); }

// Without load it is the free body, which another series solves.
TEST(LoadedBody, WithoutLoadIsFree) {
  const FreeBody body{{1, 1.25, 1.5}, {1, -0.75, 0.5}, rotation_of<double>(Vec4<double>(1, 2, -1, 3))};
  EXPECT_LT(apart(taylor_loaded_body({body}, 0.5, 28, 0.02), taylor_free_body<P>(body, P(0.5))), P("1e-35"));
}

// The error that the frozen table states, 1e-31: more terms and shorter steps change nothing above it.
TEST(LoadedBody, IsAsGoodAsTheTableSays) {
  const LoadedBody all{{{0.75, 1, 1.125}, {1, 0.5, -1}, identity3<double>()}, {0.25, -0.5, 0.5}, {0.125, 0, -0.75}, {0.5, 0.25, -1}, 1.75};
  EXPECT_LT(apart(taylor_loaded_body(all, 0.5, 28, 0.02), taylor_loaded_body(all, 0.5, 34, 0.0125)), P("1e-31"));
  const LoadedBody fast{{{0.5, 1, 1}, {8, 0, 0.75}, identity3<double>()}, {2, 0, 0}};
  EXPECT_LT(apart(taylor_loaded_body(fast, 0.25, 28, 0.01), taylor_loaded_body(fast, 0.25, 34, 0.00625)), P("1e-31"));
  EXPECT_GT(apart(taylor_loaded_body(all, 0.5, 8, 0.02), taylor_loaded_body(all, 0.5, 28, 0.02)), P("1e-25")) << "the comparison can fail";
}

}  // namespace
}  // namespace rigor::reference
