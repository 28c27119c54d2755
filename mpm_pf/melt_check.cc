#include "melt_check.h"

#include <cmath>
#include <limits>

#include "medium/numerical_error.h"
#include "scene/value.h"

namespace
{
  // The sum is there for NaN, which no comparison sees.
  void check(const medium::Field<double> &field, const medium::Mesh &mesh, const char *name,
             const double bound)
  {
    for (int j = 0; j < mesh.nodes[1]; ++j)
    {
      const double *f = field.row(j);
      double largest = 0., sum = 0.;
#pragma omp simd reduction(max : largest) reduction(+ : sum)
      for (int i = 0; i < mesh.nodes[0]; ++i)
      {
        const double square = f[i] * f[i];
        largest = square > largest ? square : largest;
        sum += square;
      }
      if (std::isfinite(sum) && largest < bound * bound)
        continue;
      int i = 0;
      while (i + 1 < mesh.nodes[0] && std::abs(f[i]) < bound)
        ++i;
      const scene::Point at = mesh.position(i, j);
      throw medium::NumericalError(
          std::string(name) + " = " + scene::number_text(f[i]) + " at (" +
          scene::number_text(at[0]) + ", " + scene::number_text(at[1]) +
          ") has left its bounds; a shorter step (growth.step_fraction, clock.step) or motions "
          "that are finite everywhere are the remedy");
    }
  }
} // namespace

void check_melt(const World &world)
{
  if (world.phase)
    check(world.phase->value, *world.mesh, "phi", 2.);
  if (world.heat)
    check(world.heat->value, *world.mesh, "theta", std::numeric_limits<double>::infinity());
}
