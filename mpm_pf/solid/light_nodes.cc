#include "solid/light_nodes.h"

#include <tuple>

namespace solid
{
  namespace
  {
    constexpr std::uint8_t both = 3;
    // Which components no support holds at a node. Of the two rows where a line folds functions
    // only the carriers are held; the row before them counts as free where `before_supports` is.
    struct FreeComponents
    {
      const Supports &supports;
      const Grid &grid;
      bool before_supports;

      std::uint8_t at(const std::ptrdiff_t n, const int i, const int j) const
      {
        std::uint8_t free = both;
        for (int axis = 0; axis < 2 && grid.fold[n] > 0; ++axis)
        {
          const int l = supports.folds.pairs[grid.fold[n] - 1][axis];
          if (l >= 0 &&
              (!before_supports || supports.folds.lines[l].carrier() == (axis == 0 ? i : j)))
            for (int c = 0; c < 2; ++c)
              if (supports.lines[l].held[c])
                free &= static_cast<std::uint8_t>(~(1 << c));
        }
        if (!supports.tied.empty())
          free &= static_cast<std::uint8_t>(~supports.tied[n]);
        for (int c = 0; c < 2 && !supports.driven_parts.empty(); ++c)
          if (supports.driven_parts[n][c].mass > 0.)
            free &= static_cast<std::uint8_t>(~(1 << c));
        return free;
      }
    };

    // Direction d of the eight around a node.
    std::array<int, 2> direction(const int d)
    {
      const int k = d < 4 ? d : d + 1;
      return {k % 3 - 1, k / 3 - 1};
    }

    /// Calls f(k, node, turn) for the nodes behind that count; `turn` is an Image or Straight.
    template <typename F>
    void for_behind(const LightNode &light, const Grid &grid, F &&f)
    {
      if (light.straight)
      {
        for (int k = 0; k < 16; ++k)
          if (light.weight[k] != 0.)
            f(k, light.behind[k], Straight{});
        return;
      }
      for (int k = 0; k < 16; ++k)
        if (light.weight[k] != 0.)
        {
          const auto [a, b] = direction(k / 2);
          const int steps = 1 + k % 2;
          f(k, light.behind[k], image_of(grid, light.at[0] + steps * a, light.at[1] + steps * b));
        }
    }

    // How many of a light node and its own images lean on a node behind it that is kept.
    int count(const Image &light, const Image &behind)
    {
      int times = 1;
      for (int c = 0; c < 2; ++c)
        if (const bool on_side = light.sign[c] == 0.; behind.sign[c] < 0.)
          times *= on_side ? 0 : 1;
        else if (behind.sign[c] == 0.)
          times *= on_side ? 1 : 2;
      return times;
    }
    int count(const Image &, Straight)
    {
      return 1;
    }

    template <typename Turn>
    Point acceleration(const Grid &grid, const std::ptrdiff_t n, const Turn &turn)
    {
      return turn.apply(grid.nodes[n].force() / grid.mass[n]);
    }

    Image self(const Grid &grid, const LightNode &light)
    {
      return light.straight ? Image{light.node, {1., 1.}, 1.}
                            : image_of(grid, light.at[0], light.at[1]);
    }

    // Weights of the nodes behind it: the heavier a direction's first node, the more it counts.
    // Both nodes of a direction where any has two, else the first ones.
    template <bool straight>
    bool find_behind(LightNode &light, const FreeComponents &free, const double least)
    {
      const Grid &grid = free.grid;
      const auto [i, j] = light.at;
      double omega = 0.; // mass of the node that was asked for last
      const auto node = [&](int a, int b) -> std::ptrdiff_t
      {
        std::ptrdiff_t n = -1;
        double whole = 1.;
        if constexpr (!straight)
        {
          const Image image = image_of(grid, a, b);
          n = image.node, whole = image.whole;
          if (n < 0)
            return -1;
          std::tie(a, b) = std::tie(image.at[0], image.at[1]);
        }
        else
        {
          if (!grid.has(a, b))
            return -1;
          n = grid.at(a, b);
        }
        omega = whole * grid.mass[n];
        return omega >= least && (free.at(n, a, b) & light.components) == light.components ? n : -1;
      };
      light.behind.fill(light.node), light.weight.fill(0.);
      double of_pairs = 0., of_single = 0.;
      std::array<double, 8> single{};
#pragma GCC unroll 8
      for (int d = 0; d < 8; ++d)
      {
        const auto [a, b] = direction(d);
        const std::ptrdiff_t first = node(i + a, j + b);
        if (first < 0)
          continue;
        single[d] = omega, of_single += omega;
        light.behind[2 * d] = first;
        const std::ptrdiff_t second = node(i + 2 * a, j + 2 * b);
        if (second < 0)
          continue;
        light.behind[2 * d + 1] = second;
        light.weight[2 * d] = 2. * single[d], light.weight[2 * d + 1] = -single[d];
        of_pairs += single[d];
      }
      if (of_pairs > 0.)
        for (double &w : light.weight)
          w /= of_pairs;
      else if (of_single > 0.)
        for (int d = 0; d < 8; ++d)
          light.weight[2 * d] = single[d] / of_single;
      return of_single > 0.;
    }

    // q dt of the equations of motion of I and those behind it. Where n light nodes lean on one it
    // counts n times as light for each of them, so that all corrections together, each made as if
    // it were alone, take no acceleration beyond zero (Cauchy's inequality).
    void find_impulse(LightNode &light, const std::vector<std::uint8_t> &leaning, const Grid &grid,
                      const double least, const double dt)
    {
      const Image itself = self(grid, light);
      const double mass = itself.whole * grid.mass[light.node];
      Point relative = acceleration(grid, light.node, itself);
      double yielding = 1. / (least - mass) + 1. / mass;
      for_behind(light, grid,
                 [&](const int k, const std::ptrdiff_t n, const auto &turn)
                 {
                   const double w = light.weight[k];
                   relative -= w * acceleration(grid, n, turn);
                   yielding += leaning[n] * w * w / (turn.whole * grid.mass[n]);
                 });
      light.impulse = dt / yielding * relative;
      for (int c = 0; c < 2; ++c)
        if (!(light.components & (1 << c)))
          light.impulse[c] = 0.;
    }

    void find_in_row(std::vector<LightNode> &found, const FreeComponents &free, const int j,
                     const double least)
    {
      found.clear();
      const Grid &grid = free.grid;
      const double rounding = 1e-9 * least;
      const auto [begin, end] = grid.columns(j);
      const std::ptrdiff_t offset = grid.offset[j - grid.row_begin];
      for (int i = begin; i < end; ++i)
      {
        const double mass = grid.mass[offset + i];
        if (mass >= least || mass <= 0.25 * rounding)
          continue;
        LightNode light;
        light.node = offset + i, light.at = {i, j};
        light.straight = !near_mirror(grid, i, j, 2);
        if (!light.straight)
          if (const double mass = self(grid, light).whole * grid.mass[light.node];
              mass >= least || mass <= rounding)
            continue;
        light.components = free.at(light.node, i, j);
        if (light.components == 0 || !(light.straight ? find_behind<true>(light, free, least)
                                                      : find_behind<false>(light, free, least)))
          continue;
        found.push_back(light);
      }
    }

    template <typename Turn>
    void add(Grid &grid, const std::ptrdiff_t n, const Turn &turn, const Point &impulse)
    {
      const Point dv = turn.apply(impulse) / (turn.whole * grid.mass[n]);
      grid.velocity[n].x += dv[0], grid.velocity[n].y += dv[1];
      if (!grid.change.empty())
        grid.change[n].x += dv[0], grid.change[n].y += dv[1];
    }
  } // namespace

  void tie_light_nodes(LightNodes &nodes, const Supports &supports, Grid &grid, const double least,
                       const double dt, const int threads)
  {
    const FreeComponents free{supports, grid, nodes.before_supports};
    const int rows = grid.row_end - grid.row_begin;
    nodes.found.resize(static_cast<std::size_t>(rows));
    nodes.leaning.assign(grid.nodes.size(), 0);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int row = 0; row < rows; ++row)
      find_in_row(nodes.found[row], free, grid.row_begin + row, least);
    for (const auto &row : nodes.found)
      for (const LightNode &light : row)
      {
        const Image itself = self(grid, light);
        for_behind(light, grid,
                   [&](int, const std::ptrdiff_t n, const auto &turn)
                   { nodes.leaning[n] += static_cast<std::uint8_t>(count(itself, turn)); });
      }
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int row = 0; row < rows; ++row)
      for (LightNode &light : nodes.found[row])
        find_impulse(light, nodes.leaning, grid, least, dt);
    for (const auto &row : nodes.found)
      for (const LightNode &light : row)
      {
        const Image itself = self(grid, light);
        add(grid, light.node, itself, -light.impulse);
        for_behind(light, grid,
                   [&](const int k, const std::ptrdiff_t n, const auto &turn)
                   { add(grid, n, turn, count(itself, turn) * light.weight[k] * light.impulse); });
      }
  }
} // namespace solid
