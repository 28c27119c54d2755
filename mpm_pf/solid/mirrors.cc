#include "solid/mirrors.h"

namespace solid
{
  namespace
  {
    // Call f(outside, on, inside) for the nodes next to the side, beyond, on and inside of it.
    // Points touch one row beyond.
    template <typename F>
    void for_images(const Grid &grid, const Mirror &mirror, F &&f)
    {
      const auto [begin, end] =
          mirror.axis == 1 ? grid.columns(mirror.row) : std::pair{grid.row_begin, grid.row_end};
      for (int k = begin; k < end; ++k)
      {
        std::array<std::ptrdiff_t, 3> nodes;
        bool all = true;
        for (int n = 0; n < 3; ++n)
        {
          const int across = mirror.row + (n - 1) * mirror.side;
          const int i = mirror.axis == 1 ? k : across, j = mirror.axis == 1 ? across : k;
          all = all && grid.has(i, j);
          nodes[n] = all ? grid.at(i, j) : 0;
        }
        if (all)
          f(nodes[0], nodes[1], nodes[2]);
      }
    }

    Velocity reflected(const Velocity &v, const int axis)
    {
      return axis == 0 ? Velocity{-v.x, v.y} : Velocity{v.x, -v.y};
    }
  } // namespace

  Image image_of(const Grid &grid, int i, int j)
  {
    Image image{-1, {1., 1.}, 1.};
    for (const Mirror &mirror : grid.mirrors)
    {
      int &k = mirror.axis == 0 ? i : j;
      if ((k - mirror.row) * mirror.side < 0)
        k = 2 * mirror.row - k, image.sign[mirror.axis] = -1.;
      else if (k == mirror.row)
        image.sign[mirror.axis] = 0., image.whole *= 2.;
    }
    image.at = {i, j};
    if (grid.has(i, j))
      image.node = grid.at(i, j);
    return image;
  }

  bool on_mirror(const Grid &grid, const int axis, const int i, const int j)
  {
    for (const Mirror &mirror : grid.mirrors)
      if (mirror.axis == axis && mirror.row == (axis == 0 ? i : j))
        return true;
    return false;
  }

  void fold_images(Grid &grid)
  {
    for (const Mirror &mirror : grid.mirrors) // across x first: corners go over both
    {
      const Quad turn = mirror.axis == 0 ? Quad{-1., -1., 1., 1.} : Quad{1., 1., -1., -1.};
      const Quad along = 0.5 * (turn + Quad{1., 1., 1., 1.}); // across, both halves cancel on it
      for_images(
          grid, mirror,
          [&](const std::ptrdiff_t outside, const std::ptrdiff_t on, const std::ptrdiff_t image)
          {
            grid.nodes[on].motion *= along;
            grid.mass[image] += grid.mass[outside];
            grid.nodes[image].motion += turn * grid.nodes[outside].motion;
            grid.mass[outside] = 0., grid.nodes[outside] = Node{};
          });
    }
  }

  void reflect_velocities(Grid &grid)
  {
    for (const Mirror &mirror : grid.mirrors)
      for_images(grid, mirror,
                 [&](const std::ptrdiff_t outside, std::ptrdiff_t, const std::ptrdiff_t image)
                 {
                   grid.velocity[outside] = reflected(grid.velocity[image], mirror.axis);
                   if (!grid.change.empty())
                     grid.change[outside] = reflected(grid.change[image], mirror.axis);
                 });
  }
} // namespace solid
