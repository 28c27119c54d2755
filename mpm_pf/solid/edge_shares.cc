#include "solid/edge_shares.h"
#include "solid/mirrors.h"

namespace solid
{
  namespace
  {
    // Call f(node, weight, gradient, turn) for the nodes around x, those beyond a symmetry side by
    // their images: what they get is turned as these are.
    template <typename F>
    void for_nodes(const Stencil &s, const Grid &grid, F &&f)
    {
      if (near_mirror(grid, s.i, s.j, 1))
      {
        for (int k = 0; k < 9; ++k)
        {
          const int a = k % 3, b = k / 3;
          const Image image = image_of(grid, s.i - 1 + a, s.j - 1 + b);
          f(image.node, s.x.w[a] * s.y.w[b], Point(s.x.g[a] * s.y.w[b], s.x.w[a] * s.y.g[b]),
            image);
        }
        return;
      }
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a)
          f(grid.at(s.i - 1 + a, s.j - 1 + b), s.x.w[a] * s.y.w[b],
            Point(s.x.g[a] * s.y.w[b], s.x.w[a] * s.y.g[b]), Straight{});
    }

    // Call f(x, n ds) for the Gauss points of the chord from tracer k; material lies to its left.
    template <typename F>
    void for_gauss_points(const std::vector<Tracer> &outline, const std::size_t k, F &&f)
    {
      const Point chord = outline[(k + 1) % outline.size()].x - outline[k].x;
      for (const double s : chord_gauss_points)
        f(on_chord(outline, k, s)[1], Point(0.5 * chord[1], -0.5 * chord[0]));
    }
  } // namespace

  void EdgeShares::find_near(const Tracers &tracers, const Points &points, const Grid &grid)
  {
    near.clear(), chords.clear(), nodes.clear();
    sums.assign(grid.nodes.size(), Sums{});
    // Two nodes between two that share one, one more that each may travel, and one from the middle
    // of each chord to its Gauss points.
    constexpr int reach = 6;
    std::vector<std::uint8_t> close(grid.nodes.size(), 0);
    for (const auto &outline : tracers.outlines)
      for (std::size_t k = 0; k < outline.size(); ++k)
        if (outline[k].loads != 0)
        {
          const Point x = on_chord(outline, k, 0.5)[1];
          const int i = grid.nearest(x[0], 0), j = grid.nearest(x[1], 1);
          for (int row = j - reach; row <= j + reach; ++row)
            for (int column = i - reach; column <= i + reach; ++column)
              if (grid.has(column, row))
                close[grid.at(column, row)] = 1;
        }
    for (std::size_t o = 0; o < tracers.outlines.size(); ++o)
      for (std::size_t k = 0; k < tracers.outlines[o].size(); ++k)
      {
        const Point x = on_chord(tracers.outlines[o], k, 0.5)[1];
        const int i = grid.nearest(x[0], 0), j = grid.nearest(x[1], 1);
        if (grid.has(i, j) && close[grid.at(i, j)])
          chords.push_back({o, k});
      }
    for (std::size_t p = 0; p < points.active; ++p)
      if (close[grid.at(grid.nearest(points.x[p], 0), grid.nearest(points.y[p], 1))])
        near.push_back(static_cast<std::uint32_t>(p));
  }

  double EdgeShares::bytes() const
  {
    return static_cast<double>(sums.size() * sizeof(sums[0]) + nodes.size() * sizeof(nodes[0]) +
                               near.size() * sizeof(near[0]) + chords.size() * sizeof(chords[0]));
  }

  void EdgeShares::add_loaded(const Tracers &tracers, const Interpolation &at)
  {
    const Grid &grid = at.grid;
    for (const Chord &chord : chords)
      if (const auto &outline = tracers.outlines[chord.outline]; outline[chord.tracer].loads != 0)
        for_gauss_points(
            outline, chord.tracer,
            [&](const Point &x, const Point &normal)
            {
              if (!grid.surrounds(x))
                return; // it has parted from the material, or belongs to a rigid grip
              for_nodes(stencil(at, x), grid,
                        [&](const std::ptrdiff_t n, const double w, const Point &, const auto &turn)
                        {
                          if (sums[n].share == 0.)
                            sums[n].share = 1., nodes.push_back(n);
                          sums[n].loaded += turn.apply(w * normal);
                        });
            });
  }

  void EdgeShares::add_edges(const Tracers &tracers, const Interpolation &at)
  {
    const Grid &grid = at.grid;
    for (const Chord &chord : chords)
      for_gauss_points(
          tracers.outlines[chord.outline], chord.tracer,
          [&](const Point &x, const Point &normal)
          {
            if (grid.surrounds(x))
              for_nodes(stencil(at, x), grid,
                        [&](const std::ptrdiff_t n, const double w, const Point &, const auto &turn)
                        {
                          if (sums[n].share != 0.)
                            sums[n].edge += turn.apply(w * normal);
                        });
          });
  }

  void EdgeShares::add_points(const Points &points, const Interpolation &at,
                              const double inverse_density)
  {
    for (const std::uint32_t p : near)
    {
      const double volume = points.mass[p] * inverse_density * points.jacobian[p];
      for_nodes(stencil(at, {points.x[p], points.y[p]}), at.grid,
                [&](const std::ptrdiff_t n, const double, const Point &slope, const auto &turn)
                {
                  if (sums[n].share != 0.)
                    sums[n].points += turn.apply(volume * slope);
                });
    }
  }

  void EdgeShares::measure(const Tracers &tracers, const Points &points, const Interpolation &at,
                           const double inverse_density)
  {
    for (const std::ptrdiff_t n : nodes)
      sums[n] = Sums{};
    nodes.clear();
    add_loaded(tracers, at);
    add_edges(tracers, at);
    add_points(points, at, inverse_density);
    for (const std::ptrdiff_t n : nodes)
    {
      Sums &sum = sums[n];
      const double loaded = sum.loaded.squaredNorm();
      const double edge = sum.edge.dot(sum.loaded), seen = sum.points.dot(sum.loaded);
      // Two edges of a sliver cancel in B_i: nothing can be told from it.
      const double share = edge > 0.05 * loaded ? seen / edge : 1.;
      sum.share = std::min(std::max(share, 1e-12), 2.);
    }
  }
} // namespace solid
