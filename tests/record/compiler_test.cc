// The compiler of this build stores constant lists as they are written: GCC 12 with AVX-512 does
// not, unless CMakeLists.txt tells it to copy in small pieces. Every number that is shown rests on
// this.

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace
{
  // As long and as short as a register, not inlined: a caller that sees the list would fold it.
  [[gnu::noinline]] std::vector<int> eight_ints()
  {
    return {2, 2, 2, 2, 0, 0, 0, 0};
  }
  [[gnu::noinline]] std::vector<int> sixteen_ints()
  {
    return {2, 2, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  }
  [[gnu::noinline]] std::vector<double> four_doubles()
  {
    return {1., 1., 0., 0.};
  }
  [[gnu::noinline]] std::vector<double> eight_doubles()
  {
    return {.5, .5, .5, .5, .5, 0., 0., 0.};
  }
  [[gnu::noinline]] std::array<double, 5> five_doubles()
  {
    return {1., 1., 0., 0., 0.};
  }

  /// How many entries are not zero.
  template <typename List>
  std::size_t nonzero(const List &list)
  {
    std::size_t n = 0;
    for (const auto value : list)
      n += value != 0;
    return n;
  }
} // namespace

TEST(Compiler, ConstantListsKeepTheirZeros)
{
  EXPECT_EQ(nonzero(eight_ints()), 4u);
  EXPECT_EQ(nonzero(sixteen_ints()), 4u);
  EXPECT_EQ(nonzero(four_doubles()), 2u);
  EXPECT_EQ(nonzero(eight_doubles()), 5u);
  EXPECT_EQ(nonzero(five_doubles()), 2u);
}
