// What is written comes back, bit for bit, and nothing half-written ever has the final name.
#include <cmath>
#include <fstream>
#include <limits>

#include "../scratch.h"
#include "record/reader.h"
#include "record/writer.h"

namespace
{
  using namespace record;
  namespace fs = std::filesystem;

  scene::Scene some_scene()
  {
    scene::Scene scene;
    scene.file = "scene.toml";
    scene.title = "A title";
    scene.text = "title = \"A title\"\n";
    scene.hash = "1234";
    return scene;
  }

  const Provenance someone{{"program", "mpm_pf"}, {"start", "2026-01-01T00:00:00Z"}};
  const Columns force{{"force_x", "force_y"}, {"N", "N"}};

  Snapshot some_grid()
  {
    Snapshot grid;
    grid.kind = Snapshot::Kind::grid;
    grid.origin = {-1., 2.};
    grid.spacing = {0.5, 0.25};
    grid.nodes = {3, 2};
    grid.fields["phi"] = {1., 2., 3., 4., 5., std::nan("")};
    return grid;
  }

  Snapshot some_cells()
  {
    Snapshot cells;
    cells.kind = Snapshot::Kind::cells;
    cells.vertex = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {2., 0.}, {2., 1.}};
    cells.connectivity = {0, 1, 2, 3, 1, 4, 5, 2};
    cells.fields["von_mises"] = {7., 8.};
    return cells;
  }
} // namespace

TEST(Record, GivesTableRowsBackBitForBit)
{
  const Scratch scratch;
  const double awkward = 0.1 + 0.2;
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    writer.table("top reaction", force, 0., {1., awkward});
    writer.flush();
    writer.table("top reaction", force, 0.5, {std::numeric_limits<double>::denorm_min(), -0.});
    writer.finish({});
  }
  const Table table = Reader(scratch / "a.h5").table("top reaction");
  EXPECT_EQ(table.columns.names, force.names);
  EXPECT_EQ(table.columns.units, force.units);
  EXPECT_EQ(table.time, (std::vector<double>{0., 0.5}));
  EXPECT_EQ(table.rows.at(0).at(1), awkward);
  EXPECT_EQ(table.rows.at(1).at(0), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(table.rows.at(1).at(1)));
}

TEST(Record, ShowsItsRowsWhenTheyHaveWaitedAndNotBefore)
{
  const Scratch scratch;
  Writer writer(scratch / "a.h5", someone, some_scene(), false);
  writer.table("top reaction", force, 0., {1., 2.});
  writer.flush_after(3600.);
  EXPECT_TRUE(Reader(scratch / "a.h5.part").tables().empty());
  writer.flush_after(0.);
  EXPECT_EQ(Reader(scratch / "a.h5.part").table("top reaction").time.size(), 1u);
}

TEST(Record, KeepsMissingLineValuesMissing)
{
  const Scratch scratch;
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    for (int k = 0; k < 3; ++k)
      writer.line("centre line", {{"von_mises"}, {"Pa"}}, k,
                  {{{0., double(k)}, {1., 2.}}, {3. + k, std::nan("")}});
    writer.finish({});
  }
  const Lines lines = Reader(scratch / "a.h5").line("centre line");
  ASSERT_EQ(lines.samples.size(), 3u);
  EXPECT_EQ(lines.samples[2].position.at(0), Point(0., 2.));
  EXPECT_EQ(lines.samples[2].values.at(0), 5.);
  EXPECT_TRUE(std::isnan(lines.samples[2].values.at(1)));
}

TEST(Record, GivesOutlinesOfSeveralCurvesBack)
{
  const Scratch scratch;
  const std::vector<Polyline> ring{{{0., 0.}, {4., 0.}, {2., 3.}}, {{1., 1.}, {3., 1.}, {2., 2.}}};
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    for (int k = 0; k < 12; ++k) // more than ten: "10" must not come before "2"
      writer.outline("contour", k, k == 11 ? ring : std::vector<Polyline>{});
    writer.finish({});
  }
  const Outlines outlines = Reader(scratch / "a.h5").outline("contour");
  ASSERT_EQ(outlines.time.size(), 12u);
  EXPECT_EQ(outlines.time[2], 2.);
  EXPECT_TRUE(outlines.outlines[2].empty());
  EXPECT_EQ(outlines.outlines[11], ring);
}

TEST(Record, GivesSnapshotsOfEveryKindBack)
{
  const Scratch scratch;
  Snapshot points;
  points.vertex.assign(5000, Point(0.25, 0.75)); // large enough to be compressed
  points.fields["pressure"].assign(5000, 3.);
  points.fields["pressure"][4999] = 4.;
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    writer.snapshot("grid", 0.5, some_grid());
    writer.snapshot("cells", 1., some_cells());
    writer.snapshot("points", 1., points);
    writer.snapshot("points", 2., points);
    writer.finish({});
  }
  const Reader reader(scratch / "a.h5");
  const Snapshot grid = reader.snapshot("grid", 0), cells = reader.snapshot("cells", 0);
  EXPECT_EQ(grid.kind, Snapshot::Kind::grid);
  EXPECT_EQ(grid.nodes, (std::array<int, 2>{3, 2}));
  EXPECT_EQ(grid.origin, Point(-1., 2.));
  EXPECT_EQ(grid.spacing, Point(0.5, 0.25));
  EXPECT_EQ(grid.fields.at("phi").at(4), 5.);
  EXPECT_TRUE(std::isnan(grid.fields.at("phi").at(5)));
  EXPECT_EQ(cells.kind, Snapshot::Kind::cells);
  EXPECT_EQ(cells.connectivity, some_cells().connectivity);
  EXPECT_EQ(cells.vertex, some_cells().vertex);
  EXPECT_EQ(cells.fields, some_cells().fields);
  EXPECT_EQ(reader.snapshot_times("points"), (std::vector<double>{1., 2.}));
  EXPECT_EQ(reader.snapshot("points", 1).fields, points.fields);
  EXPECT_EQ(reader.snapshot("points", 1).vertex, points.vertex);
}

TEST(Record, KeepsAttributesProvenanceAndProfile)
{
  const Scratch scratch;
  {
    Writer writer(scratch / "a.h5", collect_provenance("mpm_pf", "mpm_pf scene.toml", 2),
                  some_scene(), false);
    writer.attribute("quasi_static", "yes");
    writer.attribute("largest_load", 0.75);
    writer.finish({{{"solve", 1.5, 3., 42}}, {{"steps", 1e6}, {"wall_s", 2.}}}, "complete");
  }
  const Reader reader(scratch / "a.h5");
  EXPECT_EQ(reader.status(), "complete");
  EXPECT_EQ(reader.attribute("quasi_static"), "yes");
  EXPECT_EQ(reader.attribute("scene_hash"), "1234");
  EXPECT_EQ(reader.attribute("command"), "mpm_pf scene.toml");
  EXPECT_EQ(reader.attribute("never written"), "");
  EXPECT_EQ(reader.scene_text(), some_scene().text);
  EXPECT_EQ(reader.number("largest_load"), 0.75);
  EXPECT_EQ(reader.number("steps"), 1e6);
  EXPECT_TRUE(std::isnan(reader.number("never written")));
  const Profile profile = reader.profile();
  ASSERT_EQ(profile.parts.size(), 1u);
  EXPECT_EQ(profile.parts[0].name, "solve");
  EXPECT_EQ(profile.parts[0].cpu_s, 3.);
  EXPECT_EQ(profile.parts[0].calls, 42);
  EXPECT_EQ(profile.numbers.at("wall_s"), 2.);
  const Provenance all = reader.provenance();
  for (const char *name : {"version", "commit", "dirty", "compiler", "flags", "build_type", "cpu",
                           "start", "hdf5", "threads"})
    EXPECT_NE(all.at(name), "") << name;
}

TEST(Record, HasItsFinalNameOnlyWhenFinished)
{
  const Scratch scratch;
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    writer.table("top reaction", force, 0., {1., 2.});
  }
  EXPECT_FALSE(fs::exists(scratch / "a.h5"));
  EXPECT_TRUE(fs::exists(scratch / "a.h5.part"));
  EXPECT_NE(error_of<std::runtime_error>([&] { Reader(scratch / "a.h5"); }).find("unfinished"),
            std::string::npos);
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    writer.finish({}, "failed: step 3");
  }
  EXPECT_FALSE(fs::exists(scratch / "a.h5.part"));
  EXPECT_FALSE(fs::exists(scratch / "a.xdmf")) << "there is no snapshot to open";
  EXPECT_EQ(Reader(scratch / "a.h5").status(), "failed: step 3");
  EXPECT_TRUE(Reader(scratch / "a.h5").tables().empty()); // the earlier .part was not gone on with
}

TEST(Record, ReplacesAnEarlierOneOnlyByForce)
{
  const Scratch scratch;
  Writer(scratch / "a.h5", someone, some_scene(), false).finish({}, "first");
  EXPECT_NE(
      error_of<std::runtime_error>([&] { Writer(scratch / "a.h5", someone, some_scene(), false); })
          .find("--force"),
      std::string::npos);
  Writer writer(scratch / "a.h5", someone, some_scene(), true);
  EXPECT_EQ(Reader(scratch / "a.h5").status(), "first"); // still there until the new one is whole
  writer.finish({}, "second");
  EXPECT_EQ(Reader(scratch / "a.h5").status(), "second");
}

TEST(Record, RefusesWhatDoesNotFitItsDeclaration)
{
  const Scratch scratch;
  Writer writer(scratch / "a.h5", someone, some_scene(), false);
  writer.table("t", force, 0., {1., 2.});
  EXPECT_THROW(writer.table("t", force, 0., {1.}), std::invalid_argument);
  EXPECT_THROW(writer.table("t", {{"a", "b"}, {"N", "N"}}, 0., {1., 2.}), std::invalid_argument);
  EXPECT_THROW(writer.table("a/b", force, 0., {1., 2.}), std::invalid_argument);
  writer.line("l", {{"phi"}, {"1"}}, 0., {{{0., 0.}}, {1.}});
  EXPECT_THROW(writer.line("l", {{"phi"}, {"1"}}, 0., {{{0., 0.}, {1., 0.}}, {1., 2.}}),
               std::invalid_argument);
  Snapshot wrong = some_grid();
  wrong.fields["phi"].pop_back();
  EXPECT_THROW(writer.snapshot("s", 0., wrong), std::invalid_argument);
  writer.finish({});
  EXPECT_THROW(writer.table("t", force, 1., {1., 2.}), std::logic_error);
}

TEST(Record, SaysWhatCannotBeReadAndWhatThereIs)
{
  const Scratch scratch;
  EXPECT_NE(error_of<std::runtime_error>([&] { Reader(scratch / "b.h5"); }).find("does not exist"),
            std::string::npos);
  std::ofstream(scratch / "text.h5") << "no HDF5";
  EXPECT_NE(error_of<std::runtime_error>([&] { Reader(scratch / "text.h5"); }).find("text.h5"),
            std::string::npos);
  {
    Writer writer(scratch / "a.h5", someone, some_scene(), false);
    writer.table("energy", {{"kinetic"}, {"J"}}, 0., {1.});
    writer.finish({});
  }
  const Reader reader(scratch / "a.h5");
  EXPECT_NE(error_of<std::runtime_error>([&] { reader.table("enrgy"); }).find("energy"),
            std::string::npos);
  EXPECT_NE(error_of<std::runtime_error>([&] { reader.snapshot("fields", 0); }).find("nothing"),
            std::string::npos);
}

TEST(Record, SaysWhereItCannotBeWritten)
{
  EXPECT_NE(
      error_of<std::runtime_error>([] { Writer("/proc/no/a.h5", someone, some_scene(), false); })
          .find("/proc/no"),
      std::string::npos);
}
