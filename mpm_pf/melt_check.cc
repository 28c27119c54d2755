#include "melt_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "medium/numerical_error.h"
#include "medium/tiles.h"
#include "scene/value.h"

namespace
{
  struct Checked
  {
    const medium::Field<double> &field;
    const char *name;
    double bound;
  };

  // The sum is there for NaN, which no comparison sees.
  bool within(const double *const f, const int count, const double bound)
  {
    double largest = 0., sum = 0.;
#pragma omp simd reduction(max : largest) reduction(+ : sum)
    for (int i = 0; i < count; ++i)
    {
      const double square = f[i] * f[i];
      largest = square > largest ? square : largest;
      sum += square;
    }
    return std::isfinite(sum) && largest < bound * bound;
  }

  bool row_within(const Checked &checked, const medium::Tiles *const tiles, const int nodes,
                  const int j)
  {
    using medium::Tiles;
    const double *const f = checked.field.row(j);
    if (!tiles)
      return within(f, nodes, checked.bound);
    for (int i = 0; i < nodes; i += Tiles::width)
    {
      if (tiles->at(i / Tiles::width, j / Tiles::height) == medium::Activity::frozen)
        continue;
      if (!within(f + i, std::min(Tiles::width, nodes - i), checked.bound))
        return false;
    }
    return true;
  }

  [[noreturn]] void refuse(const Checked &checked, const medium::Mesh &mesh, const int j)
  {
    const double *const f = checked.field.row(j);
    int i = 0;
    while (i + 1 < mesh.nodes[0] && std::abs(f[i]) < checked.bound)
      ++i;
    const scene::Point at = mesh.position(i, j);
    throw medium::NumericalError(
        std::string(checked.name) + " = " + scene::number_text(f[i]) + " at (" +
        scene::number_text(at[0]) + ", " + scene::number_text(at[1]) +
        ") has left its bounds; a shorter step (growth.step_fraction, clock.step) or motions "
        "that are finite everywhere are the remedy");
  }

  void check(const Checked &checked, const medium::Tiles *const tiles, const World &world)
  {
    const medium::Mesh &mesh = *world.mesh;
    int first = mesh.nodes[1];
#pragma omp parallel for schedule(static) reduction(min : first) num_threads(world.threads)
    for (int j = 0; j < mesh.nodes[1]; ++j)
      if (!row_within(checked, tiles, mesh.nodes[0], j))
        first = std::min(first, j);
    if (first < mesh.nodes[1])
      refuse(checked, mesh, first);
  }
} // namespace

void check_melt(const World &world)
{
  // Where nothing is carried and no wall passes, only growth writes, and not on frozen tiles.
  const bool grown_only = world.growth && !world.melt_moves && !world.walls;
  const medium::Tiles *const tiles = grown_only ? &world.growth->tiles() : nullptr;
  if (world.phase)
    check({world.phase->value, "phi", 2.}, tiles, world);
  if (world.heat)
    check({world.heat->value, "theta", std::numeric_limits<double>::infinity()}, tiles, world);
}
