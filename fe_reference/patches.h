// The patch of a cell that each integration point stands for, split into samples.
#pragma once

#include "sampling.h"

namespace fe
{
  /// A sample of a patch: position in the frame asked for, current and initial area.
  struct PatchSample
  {
    int cell, point; // point: within the cell
    Point unit, x;
    double area;
  };

  /// Calls `visit` for split x split samples of every patch of the body, or of one cell.
  template <class Visit>
  void for_each_sample(const Snapshot &body, int split, scene::Frame frame, const Visit &visit);
  template <class Visit>
  void for_each_sample_of(const Snapshot &body, int cell, int split, scene::Frame frame,
                          const Visit &visit);

  /// Integration point whose patch holds the unit coordinates.
  int patch_of(const Discretisation &, const Point &unit);

  /// Bounds of the one-dimensional patches: 0, ..., 1 (degree + 2 numbers).
  std::vector<double> patch_bounds(int degree);

  template <class Visit>
  void for_each_sample(const Snapshot &body, const int split, const scene::Frame frame,
                       const Visit &visit)
  {
    for (int cell = 0; cell < body.problem.mesh.cells; ++cell)
      for_each_sample_of(body, cell, split, frame, visit);
  }

  template <class Visit>
  void for_each_sample_of(const Snapshot &body, const int cell, const int split,
                          const scene::Frame frame, const Visit &visit)
  {
    const Discretisation &d = body.problem.mesh;
    const std::vector<double> bound = patch_bounds(d.degree);
    const int patches = d.degree + 1;
    for (int q = 0; q < d.points_per_cell; ++q)
    {
      // Gauss points of deal.II run in x first.
      const int i = q % patches, j = q / patches;
      const double dx = (bound[i + 1] - bound[i]) / split, dy = (bound[j + 1] - bound[j]) / split;
      for (int k = 0; k < split * split; ++k)
      {
        // Undivided, the patch is its Gauss point, and the sum is Gauss quadrature.
        const Point unit = split == 1 ? d.unit_point[q]
                                      : Point(bound[i] + (k % split + 0.5) * dx,
                                              bound[j] + (k / split + 0.5) * dy);
        PatchSample sample{cell, q, unit, Point::Zero(), 0.};
        Matrix2 slope;
        sample.x = position_in(body, {cell, sample.unit}, scene::Frame::current, &slope);
        sample.area = dx * dy * (slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0));
        if (frame == scene::Frame::material)
          sample.x = position_in(body, {cell, sample.unit}, frame);
        if (sample.area > 0.)
          visit(sample);
      }
    }
  }
} // namespace fe
