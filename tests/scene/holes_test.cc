// Holes of a polygon are taken out of it, once each, or refused.
#include "scene_file.h"

#include "scene/geometry.h"

using namespace scene_test;

namespace
{
  // The bar, of 1 x 2, with these holes.
  std::string holed(const std::string &holes)
  {
    return with(bar, "shape = \"rectangle\"\ncorner = [2.0, 0.2]\nsize = [1.0, 2.0]",
                "shape = \"polygon\"\nvertices = [[2, 0.2], [3, 0.2], [3, 2.2], [2, 2.2]]\n"
                "holes = [" +
                    holes + "]");
  }

  std::string square(const double x, const double y, const double side)
  {
    const auto at = [](const double a, const double b)
    { return "[" + std::to_string(a) + ", " + std::to_string(b) + "]"; };
    return "[" + at(x, y) + ", " + at(x + side, y) + ", " + at(x + side, y + side) + ", " +
           at(x, y + side) + "]";
  }
} // namespace

TEST(Holes, AreTakenOut)
{
  const Folder folder;
  const scene::Scene scene = scene::read_scene(
      folder.write("holes.toml", holed(square(2.2, 0.5, 0.3) + ", " + square(2.6, 1.5, 0.2))), {});
  double area = 0.;
  for (const scene::Polyline &line : scene::outline(scene.bodies, 10.))
    area += scene::signed_area(line);
  EXPECT_NEAR(area, 2. - 0.09 - 0.04, 1e-9);
}

TEST(Holes, ThatOverlapOrLieOutsideAreRefused)
{
  const Folder folder;
  const auto said = [&](const std::string &holes)
  { return errors(folder.write("holes.toml", holed(holes))); };
  EXPECT_NE(said(square(2.2, 0.5, 0.3) + ", " + square(2.4, 0.6, 0.3)).find("overlaps hole 1"),
            std::string::npos);
  EXPECT_NE(said(square(2.2, 0.5, 0.5) + ", " + square(2.3, 0.6, 0.1)).find("overlaps hole 1"),
            std::string::npos);
  EXPECT_NE(said(square(2.8, 1.0, 0.4)).find("hole 1 is not within"), std::string::npos);
  EXPECT_NE(said(square(3.5, 1.0, 0.4)).find("hole 1 is not within"), std::string::npos);
}
