// Writes a record of every kind of snapshot, for read_back.py to read with programs of others.
#include <cmath>

#include "record/writer.h"

namespace
{
  using namespace record;

  Snapshot grid(const double t)
  {
    Snapshot snapshot;
    snapshot.kind = Snapshot::Kind::grid;
    snapshot.origin = {-1., 2.};
    snapshot.spacing = {0.5, 0.25};
    snapshot.nodes = {4, 3};
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i)
        snapshot.fields["phi"].push_back(t + (-1. + 0.5 * i) + 10. * (2. + 0.25 * j));
    return snapshot;
  }

  Snapshot cells(const double t)
  {
    Snapshot snapshot;
    snapshot.kind = Snapshot::Kind::cells;
    snapshot.vertex = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {2., 0.}, {2. + t, 1.}};
    snapshot.connectivity = {0, 1, 2, 3, 1, 4, 5, 2};
    snapshot.fields["von_mises"] = {7. + t, std::nan("")};
    return snapshot;
  }

  Snapshot points(const double t)
  {
    Snapshot snapshot;
    snapshot.vertex = {{0., t}, {1., 1.}, {2., 4.}};
    snapshot.fields["plastic_strain"] = {0., 0.1, t};
    return snapshot;
  }
} // namespace

int main(int, char **argv)
{
  const std::string folder = argv[1];
  scene::Scene scene;
  scene.title = "Samples";
  scene.hash = "0";
  scene.text = "title = \"Samples\"\n";
  const Provenance provenance = collect_provenance("write_samples", "write_samples", 1);
  Writer all(folder + "/all.h5", provenance, scene, true);
  Writer cells_only(folder + "/cells.h5", provenance, scene, true);
  Writer points_only(folder + "/points.h5", provenance, scene, true);
  for (int k = 0; k < 12; ++k)
  {
    const double t = 0.1 * k;
    all.snapshot("fields & more", t, grid(t));
    all.snapshot("mesh", t, cells(t));
    all.snapshot("cloud", t, points(t));
    cells_only.snapshot("mesh", t, cells(t));
    points_only.snapshot("cloud", t, points(t));
    all.line("line", {{"phi"}, {"1"}}, t, {{{0., 0.}, {1., 0.}}, {t, std::nan("")}});
    all.table("energy", {{"kinetic"}, {"J"}}, t, {t});
    all.outline("contour", t, {{{0., 0.}, {1., 0.}, {0., 1.}}, {{2., 2.}, {3., 2.}, {2., 3.}}});
  }
  all.finish({{{"solve", 1., 1., 1}}, {{"steps", 12.}}});
  cells_only.finish({});
  points_only.finish({});
}
