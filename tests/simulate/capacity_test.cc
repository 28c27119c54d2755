#include "capacity.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/reader.h"

namespace
{
  scene::Scene block(const int cells)
  {
    scene::Scene scene;
    scene.domain.size = {2., 2.}, scene.domain.cells = {cells, cells};
    scene.domain.place = {"scene.toml", 7, "domain"};
    scene::Body body;
    body.shape = scene::Rectangle{{0.5, 0.5}, {1., 1.}};
    scene.bodies.push_back(body);
    scene.solid.emplace();
    return scene;
  }
} // namespace

// A quarter of 100 x 100 cells holds 2 x 2 points of 130 bytes each, every node 8 bytes.
TEST(Capacity, CountsNodesAndPoints)
{
  EXPECT_NEAR(least_bytes(block(100)), 101. * 101. * 8. + 2500. * 4. * 130., 1.);
}

TEST(Capacity, RefusesWhatNoMachineHolds)
{
  try
  {
    const scene::Scene scene = block(100000);
    refuse_more_than_memory(scene, 1e6 * least_bytes(scene));
    FAIL() << "it was accepted";
  }
  catch (const scene::BadScene &error)
  {
    EXPECT_NE(std::string(error.what()).find("scene.toml:7: domain.cells: 100000 x 100000"),
              std::string::npos)
        << error.what();
  }
}

TEST(Capacity, AcceptsASmallScene)
{
  const scene::Scene scene = block(100);
  EXPECT_NO_THROW(refuse_more_than_memory(scene, least_bytes(scene)));
}
