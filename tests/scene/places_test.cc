// Where supports and loads may be.
#include "scene_file.h"

using namespace scene_test;

namespace
{
  std::string errors_of(const std::string &text)
  {
    const Folder folder;
    return errors(folder.write("scene.toml", text));
  }

  // The bar's material reaches from (2, 0.2) to (3, 2.2); its edges at the top and bottom are held.
  std::string with_boxes(const std::string &first, const std::string &second)
  {
    return bar + "[[support]]\nname = \"a\"\nregion = " + first +
           "\ndisplacement = [\"free\", \"0.1*t\"]\n[[support]]\nname = \"b\"\nregion = " + second +
           "\ndisplacement = [\"free\", \"0.2*t\"]\n";
  }

  const std::string same = "hold the same component of the same place";
} // namespace

TEST(Places, BoxesThatOverlapInMaterialDoNotMoveApart)
{
  EXPECT_NE(errors_of(with_boxes("{lower = [1.9, 1.0], upper = [2.6, 1.4]}",
                                 "{lower = [2.5, 1.0], upper = [3.1, 1.4]}"))
                .find(same),
            std::string::npos);
}

TEST(Places, BoxesMayTouchAndOverlapBesideTheMaterial)
{
  EXPECT_EQ(errors_of(with_boxes("{lower = [1.9, 1.0], upper = [2.6, 1.4]}",
                                 "{lower = [2.6, 1.0], upper = [3.1, 1.4]}")),
            "");
  EXPECT_EQ(errors_of(with_boxes("{lower = [1.8, 1.0], upper = [2.6, 1.4]}",
                                 "{lower = [1.8, 1.4], upper = [1.9, 1.6]}"))
                .find(same),
            std::string::npos);
}

TEST(Places, ABoxDoesNotMoveApartFromTheEdgeInIt)
{
  const std::string grip = "[[support]]\nname = \"grip\"\nregion = {lower = [1.9, 2.0], upper = "
                           "[3.1, 2.3]}\ndisplacement = ";
  EXPECT_NE(errors_of(bar + grip + "[\"0.1*t\", \"free\"]\n").find(same), std::string::npos);
  EXPECT_EQ(errors_of(bar + grip + "[\"0.4*t\", \"free\"]\n"), "");
}

TEST(Places, OfSupportsMayMeetInAPoint)
{
  // The top of the bar reaches from (2, 2.2) to (3, 2.2): a box over its left half, a segment over
  // its right half.
  const std::string halves =
      with(bar, "on = \"top\"", "segment = [[2.5, 2.2], [3.0, 2.2]]") +
      "[[support]]\nname = \"left half\"\nregion = {lower = [1.9, 2.0], upper = [2.5, 2.3]}\n"
      "displacement = [\"0.7*t\", \"free\"]\n";
  EXPECT_EQ(errors_of(halves).find(same), std::string::npos) << errors_of(halves);
}

TEST(Places, OfSupportsMaySayTheSameInOtherWords)
{
  std::string alike = with_boxes("{lower = [1.9, 1.0], upper = [2.6, 1.4]}",
                                 "{lower = [2.5, 1.0], upper = [3.1, 1.4]}");
  EXPECT_NE(errors_of(alike).find(same), std::string::npos);
  alike.replace(alike.find("0.2*t"), 5, "t/10.");
  EXPECT_EQ(errors_of(alike).find(same), std::string::npos);
}

TEST(Places, AnEdgeIsNotCutOffByASymmetrySide)
{
  const std::string cut =
      with(with(bar, "cells = [50, 24]",
                "cells = [50, 24]\norigin = [0, 0.5]\nboundary = {bottom = \"symmetry\", left = "
                "\"no_flux\", right = \"no_flux\", top = \"no_flux\"}"),
           "line = [[1.5, 1.2], [3.5, 1.2]]", "line = [[1.5, 1.2], [3.5, 1.3]]");
  EXPECT_NE(errors_of(cut).find("a symmetry side that cuts their bottom edge off"),
            std::string::npos);
}

TEST(Names, OfTablesWrittenUnaskedAreKeptForThem)
{
  const std::string energy = "[[probe]]\nname = \"energy\"\nevery = 0.5\n",
                    reaction = "[[probe]]\nname = \"reaction top\"\nevery = 0.5\n";
  EXPECT_NE(errors_of(bar + energy + "region = \"all\"\nof = [\"area\"]\n")
                .find("\"energy\" is kept for a history"),
            std::string::npos);
  EXPECT_NE(errors_of(bar + reaction + "reaction = \"bottom\"\n")
                .find("kept for the reaction of \"top\""),
            std::string::npos);
  EXPECT_EQ(errors_of(bar + energy + "history = true\n" + reaction + "reaction = \"top\"\n"), "");
}

TEST(Overrides, IncludeNothing)
{
  const Folder folder;
  folder.write("other.toml", "[clock]\nend = 2.0\n");
  EXPECT_NE(errors(folder.write("scene.toml", bar), {"include=[\"other.toml\"]"})
                .find("an override cannot include a file"),
            std::string::npos);
}
