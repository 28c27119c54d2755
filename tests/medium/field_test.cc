#include "medium/field.h"
#include "medium/sums.h"

#include <cstdint>

#include <gtest/gtest.h>
#include <omp.h>

namespace
{
  using medium::Boundary;
  using medium::Field;
  using medium::Mesh;
  using medium::Parity;

  Mesh mesh_of(int nx, int ny, Boundary all = Boundary::no_flux)
  {
    Mesh mesh;
    mesh.nodes = {nx, ny};
    mesh.spacing = {0.5, 0.25};
    mesh.boundary = {all, all, all, all};
    return mesh;
  }

  Field<double> numbered(const Mesh &mesh)
  {
    Field<double> field(mesh);
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        field(i, j) = 100. * j + i;
    return field;
  }
} // namespace

TEST(Field, AlignsRowsAndAvoidsPagePitch)
{
  for (int nodes = 4; nodes < 1100; nodes += 7)
  {
    const Field<double> wide(mesh_of(nodes, 4));
    const Field<float> narrow(mesh_of(nodes, 4));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(wide.row(2)) % 64, 0u);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(narrow.row(2)) % 64, 0u);
    EXPECT_NE(wide.pitch() * 8 % 4096, 0);
    EXPECT_NE(narrow.pitch() * 4 % 4096, 0);
  }
}

TEST(Field, MirrorsThroughTheBorderNode)
{
  const Mesh mesh = mesh_of(6, 5);
  Field<double> field = numbered(mesh);
  medium::fill_ghosts(field, mesh);
  for (int layer = 1; layer <= medium::ghost_layers; ++layer)
  {
    EXPECT_EQ(field(-layer, 2), field(layer, 2));
    EXPECT_EQ(field(5 + layer, 2), field(5 - layer, 2));
    EXPECT_EQ(field(-layer, 4 + layer), field(layer, 4 - layer));
  }
  medium::fill_ghosts(field, mesh, Parity::odd_in_x);
  EXPECT_EQ(field(-2, 1), -field(2, 1));
  EXPECT_EQ(field(2, -1), field(2, 1));
}

TEST(Field, WrapsPeriodicSidesByCellsNotNodes)
{
  const Mesh mesh = mesh_of(6, 5, Boundary::periodic);
  Field<double> field = numbered(mesh);
  medium::fill_ghosts(field, mesh);
  EXPECT_EQ(field(-1, 0), field(4, 0)); // node 5 is node 0
  EXPECT_EQ(field(6, 0), field(1, 0));
  EXPECT_EQ(field(2, -2), field(2, 2)); // rows 0 and 4 are the same place
}

TEST(Field, ContinuesLinearlyBeyondAFixedSide)
{
  const Mesh mesh = mesh_of(6, 5, Boundary::fixed);
  Field<double> field = numbered(mesh);
  medium::fill_ghosts(field, mesh);
  EXPECT_DOUBLE_EQ(field(-2, 1), 98.);
  EXPECT_DOUBLE_EQ(field(7, 3), 307.);
  EXPECT_DOUBLE_EQ(field(3, -3), -297.);
}

TEST(Sums, AreTheTrapezoidalIntegralInCells)
{
  const Mesh mesh = mesh_of(6, 5);
  Field<double> one(mesh, 1.);
  EXPECT_DOUBLE_EQ(medium::weighted_sum(one, mesh), 5. * 4.);
}

TEST(MakeMesh, RefusesHalfPeriodicAndTinyDomains)
{
  scene::Domain domain;
  domain.size = {1., 1.};
  domain.cells = {8, 8};
  domain.boundary = {Boundary::periodic, Boundary::no_flux, Boundary::no_flux, Boundary::no_flux};
  EXPECT_THROW(medium::make_mesh(domain), std::invalid_argument);
  domain.boundary[0] = Boundary::no_flux;
  EXPECT_EQ(medium::make_mesh(domain).nodes[0], 9);
  domain.cells = {2, 8};
  EXPECT_THROW(medium::make_mesh(domain), std::invalid_argument);
}

// f = x on [0, 1]: mean 1/2; trapezoidal variance 1/12 + 1/(6 n^2) for n cells.
TEST(Sums, SpreadOfALinearFieldIsKnownAndHasTheSameBitsOnThreeThreads)
{
  scene::Domain domain;
  domain.size = {1., 0.5}, domain.cells = {37, 19};
  const Mesh mesh = medium::make_mesh(domain);
  Field<double> f(mesh);
  for (int j = 0; j < mesh.nodes[1]; ++j)
    for (int i = 0; i < mesh.nodes[0]; ++i)
      f(i, j) = i / 37.;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const medium::Statistics statistics = medium::statistics_of(f, mesh);
  omp_set_num_threads(3);
  const medium::Statistics again = medium::statistics_of(f, mesh);
  omp_set_num_threads(before);
  EXPECT_NEAR(statistics.mean, 0.5, 1e-15);
  EXPECT_NEAR(statistics.variance, 1. / 12. + 1. / (6. * 37. * 37.), 1e-15);
  EXPECT_EQ(statistics.min, 0.);
  EXPECT_EQ(statistics.max, 1.);
  EXPECT_EQ(statistics.mean, again.mean);
  EXPECT_EQ(statistics.variance, again.variance);
}

// 1 + 1e16 - 1e16: a plain sum loses the one.
TEST(Sums, AreCompensated)
{
  scene::Domain domain;
  domain.size = {8., 8.}, domain.cells = {8, 8};
  const Mesh mesh = medium::make_mesh(domain);
  Field<double> f(mesh);
  f(2, 2) = 1e16, f(3, 3) = 1., f(2, 4) = -1e16;
  EXPECT_EQ(medium::weighted_sum(f, mesh), 1.);
}
