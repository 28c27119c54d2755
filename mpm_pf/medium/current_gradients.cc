#include "medium/current_gradients.h"

namespace medium
{
  namespace
  {
    /// Three rows of a field round the one in hand.
    struct RowsOf
    {
      RowsOf(const Field<double> &f, int j)
          : below(f.row(j - 1)), here(f.row(j)), above(f.row(j + 1))
      {
      }
      const double *below, *here, *above;
    };
  } // namespace

  CurrentGradients::CurrentGradients(const CipFields &f, const Mesh &mesh)
      : fields(f), count(mesh.nodes[0]), per_x(0.5 / mesh.spacing[0]), per_y(0.5 / mesh.spacing[1]),
        pitch(static_cast<std::size_t>(mesh.nodes[0]) + 2 * lead), memory((f.xy ? 9 : 6) * pitch)
  {
  }

  void CurrentGradients::compute_row(int j)
  {
    newest = (newest + 1) % 3;
    const RowsOf now(*fields.f, j), before(*fields.last, j);
    const double *old_x = fields.x->row(j), *old_y = fields.y->row(j);
    double *x = memory.data() + offset(0, newest), *y = memory.data() + offset(1, newest);
#pragma omp simd
    for (int i = -1; i <= count; ++i)
    {
      x[i] = old_x[i] + per_x * ((now.here[i + 1] - now.here[i - 1]) -
                                 (before.here[i + 1] - before.here[i - 1]));
      y[i] =
          old_y[i] + per_y * ((now.above[i] - now.below[i]) - (before.above[i] - before.below[i]));
    }
    if (!fields.xy)
      return;
    const double *old_xy = fields.xy->row(j), per_xy = per_x * per_y;
    double *xy = memory.data() + offset(2, newest);
#pragma omp simd
    for (int i = -1; i <= count; ++i)
      xy[i] = old_xy[i] + per_xy * (((now.above[i + 1] - now.above[i - 1]) -
                                     (now.below[i + 1] - now.below[i - 1])) -
                                    ((before.above[i + 1] - before.above[i - 1]) -
                                     (before.below[i + 1] - before.below[i - 1])));
  }
} // namespace medium
