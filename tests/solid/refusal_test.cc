// What a scene asks for that material points cannot do is refused where it stands, by its name.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "scene/reader.h"
#include "small_scenes.h"

namespace
{
  // What make_solid() says of a block that `change` has made impossible; "" if it was made.
  std::string refusal(const std::function<void(scene::Scene &)> &change)
  {
    scene::Scene scene = small::rectangle({1., 1.}, {1., 1.}, {3., 3.}, {30, 30});
    change(scene);
    try
    {
      solid::make_solid(scene);
    }
    catch (const scene::BadScene &error)
    {
      return error.what();
    }
    return "";
  }

  std::string refusal_of_support(const scene::Where &where, const std::string &x,
                                 const std::string &y)
  {
    return refusal([&](scene::Scene &scene) { small::hold(scene, "grip", where, x, y); });
  }

  void expect_words(const std::string &said, const std::string &words)
  {
    EXPECT_NE(said.find("grip"), std::string::npos) << said;
    EXPECT_NE(said.find("test:2"), std::string::npos) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
} // namespace

TEST(RefusedSupport, OnASlantedSegment)
{
  expect_words(refusal_of_support(scene::Segment{{1., 1.}, {1.5, 1.2}}, "0", "0"),
               "slanted segment");
}

// A quarter of a cell is 0.025. At every twentieth of the end, where a look at even times would
// find nothing, the second motion is nought.
TEST(RefusedSupport, ThatBendsItsEdge)
{
  EXPECT_EQ(refusal_of_support(scene::Edge::top, "0", "0.02*(X - 1)*t"), "");
  for (const char *bent : {"0.03*(X - 1)*t", "0.03*(X - 1)*sin(20*pi*t)"})
    expect_words(refusal_of_support(scene::Edge::top, "0", bent), "bends its edge");
  EXPECT_EQ(refusal_of_support(scene::Edge::top, "0.03*(X - 1)*t", "0"), ""); // it stretches
}

TEST(RefusedSupport, OnTooLittleOfTheOutline)
{
  expect_words(refusal_of_support(scene::Segment{{1.5, 2.}, {1.51, 2.}}, "0", "0"),
               "holds less of the outline");
}

TEST(RefusedSupport, OfABoxWithoutAPoint)
{
  expect_words(refusal_of_support(scene::Box{{1.5, 1.5}, {1.501, 1.501}}, "0", "0"),
               "without a material point");
}

TEST(RefusedMachNumber, WhereNothingMoves)
{
  const std::string said = refusal([](scene::Scene &scene) { scene.mpm->mach = 1e-3; });
  EXPECT_NE(said.find("none of them moves"), std::string::npos) << said;
}
