// What a [[traction]] may say, beside the rules that rules_test.cc tries.
#include "scene_file.h"

using namespace scene_test;
using scene::read_scene;

TEST(Traction, IsAVectorOrAPressure)
{
  const Folder folder;
  const scene::Scene s = read_scene(folder.write(
      "bar.toml", bar + "[[traction]]\nname = \"wind\"\non = \"left\"\ntraction = [1, 0]\n"
                        "[[traction]]\nname = \"gas\"\npressure = \"2*t\"\n"
                        "region = {lower = [2.9, 0.5], upper = [3.1, 1.5]}\n"));
  ASSERT_EQ(s.tractions.size(), 2u);
  EXPECT_FALSE(s.tractions[0].pressure);
  EXPECT_EQ(s.tractions[0].traction[0].text, "1");
  EXPECT_EQ(s.tractions[1].pressure->text, "2*t");
  EXPECT_EQ(std::get<scene::Box>(s.tractions[1].where).upper, scene::Point(3.1, 1.5));
}
