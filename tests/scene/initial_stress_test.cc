// A stress that no state of a rate-independent solid has is refused; overstress that relaxes is
// not.
#include "scene_file.h"

using namespace scene_test;

namespace
{
  // The bar (yield stress 4e8) that starts with this stress.
  std::string stressed(const std::string &stress)
  {
    return with(bar, "shape = ", "initial_stress = " + stress + "\nshape = ");
  }

  std::string said(const std::string &text)
  {
    const Folder folder;
    return errors(folder.write("stressed.toml", text));
  }
} // namespace

TEST(InitialStress, AboveYieldIsRefusedWhereItIs)
{
  // Uniaxial; in shear sqrt(3) times as much; deviatoric in all three directions.
  EXPECT_NE(said(stressed("[0, 4.01e8, 0, 0]")).find("initial_stress"), std::string::npos);
  EXPECT_NE(said(stressed("[0, 0, 0, 2.32e8]")).find("above the yield stress"), std::string::npos);
  EXPECT_NE(said(stressed("[2e8, -2e8, 3.3e8, 0]")).find("above the yield stress"),
            std::string::npos);
  // Somewhere only, near the top.
  const std::string top = said(stressed("[0, \"2e8*Y\", 0, 0]"));
  EXPECT_NE(top.find(", 2.126"), std::string::npos) << top;
}

TEST(InitialStress, WithinYieldPasses)
{
  EXPECT_EQ(said(stressed("[0, 3.99e8, 0, 0]")), "");
  EXPECT_EQ(said(stressed("[0, 0, 0, 2.30e8]")), "");
  // However large a pressure.
  EXPECT_EQ(said(stressed("[-9e9, -9e9, -9e9, 1e8]")), "");
}

TEST(InitialStress, OverstressMayRelax)
{
  EXPECT_EQ(said(with(stressed("[0, 8e8, 0, 0]"), "yield_stress = 4e8",
                      "yield_stress = 4e8\nviscosity = 1e8")),
            "");
}
