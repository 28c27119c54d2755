// Bodies taken from a record: the cut is exact, and what is missing is said with its place.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "../scratch.h"
#include "record/outline_source.h"
#include "record/writer.h"
#include "scene/reader.h"

namespace
{
  using namespace record;

  /// Shoelace sum over curves of one orientation each; holes count negative if turned the other
  /// way.
  double area(const std::vector<Polyline> &curves)
  {
    double sum = 0.;
    for (const Polyline &curve : curves)
      for (std::size_t k = 0; k < curve.size(); ++k)
      {
        const Point &a = curve[k], &b = curve[(k + 1) % curve.size()];
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
    return sum;
  }

  /// A comb: base 5 x 1 with three teeth of 1 x 2 on it.
  const Polyline comb{{0., 0.}, {5., 0.}, {5., 3.}, {4., 3.}, {4., 1.}, {3., 1.},
                      {3., 3.}, {2., 3.}, {2., 1.}, {1., 1.}, {1., 3.}, {0., 3.}};

  scene::Scene scene_with(const std::string &file, const scene::RecordedOutline &source)
  {
    scene::Scene scene;
    scene.file = file;
    scene::Body body;
    body.name = "dendrite";
    body.shape = source;
    body.place = {file, 7, "body.record"};
    scene.bodies.push_back(body);
    return scene;
  }

  void write_comb(const std::string &path)
  {
    Writer writer(path, {}, {}, false);
    writer.outline("contour", 0.5, {{{0., 0.}, {1., 0.}, {0., 1.}}});
    writer.outline("contour", 1.5, {comb});
    writer.finish({});
  }

  scene::RecordedOutline source(const std::string &path, const std::string &probe)
  {
    scene::RecordedOutline outline;
    outline.path = path;
    outline.probe = probe;
    return outline;
  }
} // namespace

TEST(CutOutline, LeavesOneCombBelowItsTeethTips)
{
  const auto curves = cut_above({comb}, 2.);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_DOUBLE_EQ(area(curves), 5. + 3.);
  for (const Point &vertex : curves[0])
    EXPECT_LE(vertex[1], 2.);
}

TEST(CutOutline, SplitsTeethWithoutBridgesBetweenThem)
{
  auto upside_down = comb;
  for (Point &vertex : upside_down)
    vertex[1] = -vertex[1];
  const auto curves = cut_above({upside_down}, -2.); // only the three tips are left
  ASSERT_EQ(curves.size(), 3u);
  for (const Polyline &curve : curves)
  {
    ASSERT_EQ(curve.size(), 4u);
    EXPECT_DOUBLE_EQ(std::abs(area({curve})), 1.);
    int on_line = 0;
    for (const Point &vertex : curve)
      on_line += vertex[1] == -2.; // exactly, or a wall would not lie flat on it
    EXPECT_EQ(on_line, 2);
  }
}

TEST(CutOutline, OpensAHoleThatTheLineCrosses)
{
  const Polyline square{{0., 0.}, {4., 0.}, {4., 4.}, {0., 4.}};
  const Polyline same_way{{1., 1.}, {3., 1.}, {3., 3.}, {1., 3.}};
  const Polyline other_way(same_way.rbegin(), same_way.rend());
  for (const Polyline &hole : {same_way, other_way}) // even-odd: its direction must not matter
  {
    const auto curves = cut_above({square, hole}, 2.);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_DOUBLE_EQ(std::abs(area(curves)), 8. - 2.);
  }
}

TEST(CutOutline, KeepsWhatTheLineDoesNotMeet)
{
  EXPECT_EQ(cut_above({comb}, 3.5), std::vector<Polyline>{comb});
  EXPECT_TRUE(cut_above({comb}, -1.).empty());
  EXPECT_DOUBLE_EQ(area(cut_above({comb}, 1.)), 5.); // vertices on the line itself
  EXPECT_DOUBLE_EQ(area(cut_above({comb}, 3.)), 11.);
}

TEST(RecordedOutline, BecomesThePolygonOfTheWantedTime)
{
  const Scratch scratch;
  write_comb(scratch / "free.h5");
  auto scene = scene_with(scratch / "scene.toml", source(scratch / "free.h5", "contour"));
  resolve_outlines(scene);
  EXPECT_EQ(std::get<scene::Polygon>(scene.bodies[0].shape).outlines, std::vector<Polyline>{comb});

  auto early = source(scratch / "free.h5", "contour");
  early.time = 0.5;
  scene = scene_with("elsewhere/scene.toml", early);
  resolve_outlines(scene);
  EXPECT_EQ(std::get<scene::Polygon>(scene.bodies[0].shape).outlines[0].size(), 3u);
}

TEST(RecordedOutline, IsCutFromBothSides)
{
  const Scratch scratch;
  write_comb(scratch / "free.h5");
  auto between = source(scratch / "free.h5", "contour");
  between.cut_above = 2.;
  between.cut_below = 0.5;
  auto scene = scene_with(scratch / "scene.toml", between);
  resolve_outlines(scene);
  EXPECT_DOUBLE_EQ(std::abs(area(std::get<scene::Polygon>(scene.bodies[0].shape).outlines)), 5.5);
}

// A checkpoint is refused when the record that the body comes from was written anew in between.
TEST(RecordedOutline, EntersTheHashOfTheScene)
{
  const Scratch scratch;
  const auto hash_with = [&](const std::vector<Polyline> &curves)
  {
    Writer writer(scratch / "free.h5", {}, {}, true);
    writer.outline("contour", 1.5, curves);
    writer.finish({});
    auto scene = scene_with(scratch / "scene.toml", source(scratch / "free.h5", "contour"));
    scene.hash = "0123";
    resolve_outlines(scene);
    return scene.hash;
  };
  const std::string hash = hash_with({comb});
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash_with({comb}), hash);
  auto moved = comb;
  moved[2][1] = std::nextafter(moved[2][1], 0.);
  EXPECT_NE(hash_with({moved}), hash) << "by one bit";
  const Polyline half(comb.begin(), comb.begin() + 6), rest(comb.begin() + 6, comb.end());
  EXPECT_NE(hash_with({half, rest}), hash) << "the same vertices as two curves";
}

TEST(RecordedOutline, LeavesTheHashWhereNoBodyIsTakenFromARecord)
{
  auto scene = scene_with("scene.toml", {});
  scene.bodies[0].shape = scene::Polygon{{comb}};
  scene.hash = "0123";
  resolve_outlines(scene);
  EXPECT_EQ(scene.hash, "0123");
}

TEST(RecordedOutline, ComplainsWithPlaceAndRemedy)
{
  const Scratch scratch;
  write_comb(scratch / "free.h5");
  const auto refusal_of = [&](const scene::RecordedOutline &wanted)
  {
    auto scene = scene_with(scratch / "scene.toml", wanted);
    return error_of<scene::BadScene>([&] { resolve_outlines(scene); });
  };
  const std::string no_file = refusal_of(source(scratch / "fre.h5", "contour"));
  EXPECT_NE(no_file.find("scene.toml:7"), std::string::npos) << no_file;
  EXPECT_NE(no_file.find("Run the scene that writes this record first"), std::string::npos);
  EXPECT_NE(refusal_of(source(scratch / "free.h5", "countour")).find("only contour"),
            std::string::npos);
  auto wanted = source(scratch / "free.h5", "contour");
  wanted.time = 1.;
  EXPECT_NE(refusal_of(wanted).find("but at 0.5, 1.5"), std::string::npos) << refusal_of(wanted);
  wanted.time = 1.5;
  wanted.cut_above = -1.;
  EXPECT_NE(refusal_of(wanted).find("nothing"), std::string::npos);
}

// From a folder above: the path counts from the scene file, once.
TEST(RecordedOutline, LiesBesideTheSceneThatNamesIt)
{
  const Scratch scratch;
  std::filesystem::create_directories(scratch / "cases");
  write_comb(scratch / "cases/free.h5");
  std::ofstream(scratch / "cases/scene.toml") << R"(title = "comb"
[domain]
origin = [-1.0, -1.0]
size = [8.0, 8.0]
cells = [16, 16]
[[body]]
shape = "record"
record = "free.h5"
probe = "contour"
[solid]
young_modulus = 1.0
poisson_ratio = 0.3
density = 1.0
[[support]]
on = "bottom"
displacement = [0, 0]
[clock]
end = 1.0
)";
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(scratch / ".");
  scene::Scene scene = scene::read_scene("cases/scene.toml", {});
  const std::string error = error_of<std::exception>([&] { resolve_outlines(scene); });
  std::filesystem::current_path(before);
  EXPECT_EQ(error, "");
  ASSERT_TRUE(std::holds_alternative<scene::Polygon>(scene.bodies[0].shape));
  EXPECT_EQ(std::get<scene::Polygon>(scene.bodies[0].shape).outlines, std::vector<Polyline>{comb});
}
