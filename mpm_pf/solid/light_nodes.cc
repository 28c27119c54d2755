#include "solid/light_nodes.h"

namespace solid
{
  namespace
  {
    constexpr std::uint8_t both = 3;
    // Which components no support holds, at the nodes of each fold and at free ones.
    struct FreeComponents
    {
      const Supports &supports;
      const Grid &grid;
      std::vector<std::uint8_t> of_fold{both};

      FreeComponents(const Supports &s, const Grid &g) : supports(s), grid(g)
      {
        for (const auto &lines : s.folds.pairs)
        {
          std::uint8_t free = both;
          for (const int line : lines)
            for (int c = 0; c < 2 && line >= 0; ++c)
              if (s.lines[line].held[c])
                free &= static_cast<std::uint8_t>(~(1 << c));
          of_fold.push_back(free);
        }
      }

      std::uint8_t at(const std::ptrdiff_t n) const
      {
        std::uint8_t free = of_fold[grid.fold[n]];
        if (!supports.tied.empty())
          free &= static_cast<std::uint8_t>(~supports.tied[n]);
        for (int c = 0; c < 2 && !supports.driven_parts.empty(); ++c)
          if (supports.driven_parts[n][c].mass > 0.)
            free &= static_cast<std::uint8_t>(~(1 << c));
        return free;
      }
    };

    Point acceleration(const Grid &grid, const Image &at)
    {
      return at.apply(grid.nodes[at.node].force() / grid.mass[at.node]);
    }

    double whole_mass(const Grid &grid, const Image &at)
    {
      return grid.mass[at.node] / at.share;
    }

    // How many of a light node and its own images lean on a node behind it that is kept.
    int count(const LightNode &light, const Image &behind)
    {
      int times = 1;
      for (int c = 0; c < 2; ++c)
        if (const bool on_side = light.self.sign[c] == 0.; behind.sign[c] < 0.)
          times *= on_side ? 0 : 1;
        else if (behind.sign[c] == 0.)
          times *= on_side ? 1 : 2;
      return times;
    }

    // Weights of the nodes behind it: the heavier a direction's first node, the more it counts.
    // Both nodes of a direction where any has two, else the first ones.
    bool find_behind(LightNode &light, const FreeComponents &free, const int i, const int j,
                     const double least)
    {
      const Grid &grid = free.grid;
      const auto node = [&](const int a, const int b)
      {
        Image at = image_of(grid, a, b);
        if (at.node >= 0 && (whole_mass(grid, at) < least ||
                             (free.at(at.node) & light.components) != light.components))
          at.node = -1;
        return at;
      };
      light.weight.fill(0.);
      double of_pairs = 0., of_single = 0.;
      std::array<double, 8> single{};
      for (int k = 0, d = 0; k < 9; ++k)
      {
        const int a = k % 3 - 1, b = k / 3 - 1;
        if (k == 4)
          continue;
        if (const Image first = node(i + a, j + b); first.node >= 0)
        {
          const Image second = node(i + 2 * a, j + 2 * b);
          const double omega = whole_mass(grid, first);
          light.behind[2 * d] = first;
          single[d] = omega, of_single += omega;
          if (second.node >= 0)
          {
            light.behind[2 * d + 1] = second;
            light.weight[2 * d] = 2. * omega, light.weight[2 * d + 1] = -omega;
            of_pairs += omega;
          }
        }
        ++d;
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
      const double mass = whole_mass(grid, light.self);
      Point relative = acceleration(grid, light.self);
      double yielding = 1. / (least - mass) + 1. / mass;
      for (int k = 0; k < 16; ++k)
        if (const double w = light.weight[k]; w != 0.)
        {
          const Image &at = light.behind[k];
          relative -= w * acceleration(grid, at);
          yielding += leaning[at.node] * w * w / whole_mass(grid, at);
        }
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
        if (grid.mass[offset + i] >= least || grid.mass[offset + i] <= 0.)
          continue;
        LightNode light;
        light.self = image_of(grid, i, j);
        if (const double mass = whole_mass(grid, light.self); mass >= least || mass <= rounding)
          continue;
        light.components = free.at(light.self.node);
        if (light.components == 0 || !find_behind(light, free, i, j, least))
          continue;
        found.push_back(light);
      }
    }

    void add(Grid &grid, const Image &at, const Point &impulse)
    {
      const std::ptrdiff_t n = at.node;
      const Point dv = at.apply(impulse) / whole_mass(grid, at);
      grid.velocity[n].x += dv[0], grid.velocity[n].y += dv[1];
      if (!grid.change.empty())
        grid.change[n].x += dv[0], grid.change[n].y += dv[1];
    }
  } // namespace

  void tie_light_nodes(LightNodes &nodes, const Supports &supports, Grid &grid, const double least,
                       const double dt, const int threads)
  {
    const FreeComponents free(supports, grid);
    const int rows = grid.row_end - grid.row_begin;
    nodes.found.resize(static_cast<std::size_t>(rows));
    nodes.leaning.assign(grid.nodes.size(), 0);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int row = 0; row < rows; ++row)
      find_in_row(nodes.found[row], free, grid.row_begin + row, least);
    for (const auto &row : nodes.found)
      for (const LightNode &light : row)
        for (int k = 0; k < 16; ++k)
          if (light.weight[k] != 0.)
            nodes.leaning[light.behind[k].node] += count(light, light.behind[k]);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (int row = 0; row < rows; ++row)
      for (LightNode &light : nodes.found[row])
        find_impulse(light, nodes.leaning, grid, least, dt);
    for (const auto &row : nodes.found)
      for (const LightNode &light : row)
      {
        add(grid, light.self, -light.impulse);
        for (int k = 0; k < 16; ++k)
          if (light.weight[k] != 0.)
            add(grid, light.behind[k],
                count(light, light.behind[k]) * light.weight[k] * light.impulse);
      }
  }
} // namespace solid
