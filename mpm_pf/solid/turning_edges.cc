// Edges held along themselves and free across: the end of a beam that may not sink but may turn.
//
// Such an edge follows its tracers, so that after a while it is neither straight nor parallel to an
// axis. No row of nodes stands for it; as beside a driven box (driven_sides.cc), the held component
// sees functions that take the prescribed velocity V on the edge itself. With s the distance from
// the chord between two tracers, positive in the material, in cells along the row or column that
// the chord's normal is closer to, a node i with s_i < 1/2 is tied to the first node M in its row
// or column with s_M >= 1/2,
//   v_i = V_i + r_i w_M,   v_M = V_M + w_M,   r_i = s_i/s_M,
//   w_M = sum r_i m_i (v_i - V_i)/sum r_i^2 m_i   over M itself, r = 1, and all that is tied to it.
// On an edge along a row these are the folded functions of shape_functions.h. Tracers of the edge
// are where the displacement says, to the last bit, and slide across as the material does.
#include "scene/geometry.h"
#include "solid/supports.h"

namespace solid
{
  namespace
  {
    constexpr double beside = 0.5 + 1e-9; // cells from the edge from which on a node moves freely
    // Cells around a chord: a point's spline is seen 1.5 cells off in both directions, hence from
    // 3 cells off along a row that a slanted edge cuts.
    constexpr double window = 3.5;

    struct Chord
    {
      std::size_t outline, tracer; // that it starts from
    };

    // Of the nodes around the chord, those that no other one is nearer to.
    void list_around(const Chord &at, TurningEdge &edge, std::vector<int> &listed,
                     const Tracers &tracers, const Grid &grid)
    {
      const auto [o, k] = at;
      const auto &outline = tracers.outlines[o];
      const Point &a = outline[k].x, &b = outline[(k + 1) % outline.size()].x;
      const Point chord = b - a;
      std::array<int, 2> first, last;
      for (int axis = 0; axis < 2; ++axis)
      {
        first[axis] = grid.cell(std::min(a[axis], b[axis]) - window * grid.dx, axis) + 1;
        last[axis] = grid.cell(std::max(a[axis], b[axis]) + window * grid.dx, axis);
      }
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
        {
          if (!grid.has(i, j))
            continue;
          const Point x(grid.node_x(i), grid.node_y(j));
          const double along = scene::along_segment(x, a, b);
          const double distance2 = (x - a - along * chord).squaredNorm();
          const std::ptrdiff_t n = grid.at(i, j);
          if (listed[n] < 0)
          {
            listed[n] = static_cast<int>(edge.nodes.size());
            edge.nodes.emplace_back();
            edge.nodes.back().node = n, edge.nodes.back().at = {i, j};
          }
          else if (edge.nodes[listed[n]].distance2 <= distance2)
            continue;
          NearEdge &node = edge.nodes[listed[n]];
          node.outline = o, node.chord = k, node.distance2 = distance2;
        }
    }

    // From a node to its chord along the row or column.
    void measure(const TurningEdge &edge, const Tracers &tracers, const Grid &grid, NearEdge &node)
    {
      const auto &outline = tracers.outlines[node.outline];
      const std::size_t count = outline.size(), k = node.chord;
      const Tracer &a = outline[k], &b = outline[(k + 1) % count];
      const Point chord = b.x - a.x, inwards(-chord[1], chord[0]); // material lies to the left
      const Point x(grid.node_x(node.at[0]), grid.node_y(node.at[1]));
      const int axis = std::abs(inwards[0]) > std::abs(inwards[1]) ? 0 : 1;
      if (inwards[axis] == 0.)
        return;
      const double off = inwards.dot(x - a.x) / inwards[axis]; // along +axis
      node.step[axis] = inwards[axis] > 0. ? 1 : -1;
      node.distance = node.step[axis] * off * grid.inverse_dx;
      node.x = x, node.x[axis] -= off;
      const double along = (node.x - a.x).dot(chord) / chord.squaredNorm();
      node.X = (1. - along) * a.X + along * b.X;
      // The piece ends where no chord of it goes on.
      const std::uint32_t bit = edge.line.bit;
      const bool goes_on = along < 0. ? (outline[(k + count - 1) % count].lines & bit) != 0
                                      : (outline[(k + 2) % count].lines & bit) != 0;
      const double beyond = chord.norm() * std::max(-along, along - 1.);
      const int c = edge.component(), end = (b.X[c] > a.X[c]) == (along > 0.5) ? 1 : 0;
      node.beside = beyond <= 0. || goes_on ||
                    beyond <= edge.line.overhang[end] + (edge.line.reach[end] + 1e-9) * grid.dx;
    }

    void tie_behind(TurningEdge &edge, std::vector<std::uint8_t> &tied,
                    const std::vector<int> &listed, const Grid &grid)
    {
      constexpr int farthest = 5; // from 3.5 cells behind the edge to half a cell in front
      const auto bit = static_cast<std::uint8_t>(1 << edge.component());
      for (NearEdge &node : edge.nodes)
      {
        if (!node.beside || node.distance >= beside)
          continue;
        tied[node.node] |= bit;
        for (int k = 1; k <= farthest; ++k)
        {
          const int i = node.at[0] + k * node.step[0], j = node.at[1] + k * node.step[1];
          const int index = grid.has(i, j) ? listed[grid.at(i, j)] : -1;
          if (index < 0)
            break;
          const NearEdge &master = edge.nodes[index];
          if (master.distance < beside)
            continue;
          node.master = index, node.ratio = node.distance / master.distance;
          tied[master.node] |= bit;
          break;
        }
      }
    }

    double prescribed(const TurningEdge &edge, const Motion &motion, const NearEdge &node,
                      const HeldStep &step)
    {
      return ((motion.at(node.X, node.x, step.end()) - motion.at(node.X, node.x, step.t)) /
              step.dt)[edge.component()];
    }

    // Node n with the velocity v in the edge's component.
    HeldNode held_by(const TurningEdge &edge, const Grid &grid, const std::ptrdiff_t n,
                     const double v)
    {
      const Velocity now = grid.velocity[n];
      const int c = edge.component();
      std::array<bool, 2> held{false, false};
      held[c] = true;
      return {n, held, c == 0 ? Point(v, now.y) : Point(now.x, v)};
    }
  } // namespace

  void locate_turning_edges(Supports &supports, const Tracers &tracers, const Grid &grid)
  {
    supports.tied.assign(grid.nodes.size(), 0);
    if (supports.listed.size() != grid.nodes.size())
      supports.listed.assign(grid.nodes.size(), -1);
    for (TurningEdge &edge : supports.edges)
    {
      edge.nodes.clear();
      for (std::size_t o = 0; o < tracers.outlines.size(); ++o)
        for (std::size_t k = 0; k < tracers.outlines[o].size(); ++k)
          if (tracers.outlines[o][k].lines &
              tracers.outlines[o][(k + 1) % tracers.outlines[o].size()].lines & edge.line.bit)
            list_around({o, k}, edge, supports.listed, tracers, grid);
      for (NearEdge &node : edge.nodes)
        measure(edge, tracers, grid, node);
      tie_behind(edge, supports.tied, supports.listed, grid);
      for (const NearEdge &node : edge.nodes)
        supports.listed[node.node] = -1;
    }
  }

  void apply_turning_edges(Supports &supports, Grid &grid, const HeldStep &step)
  {
    for (TurningEdge &edge : supports.edges)
    {
      const Motion &motion = supports.all[edge.line.support].motion;
      const int c = edge.component();
      const auto add = [&](NearEdge &master, const NearEdge &node, const double ratio)
      {
        const Velocity &v = grid.velocity[node.node];
        const double mass = grid.mass[node.node];
        master.p += ratio * mass * ((c == 0 ? v.x : v.y) - node.prescribed);
        master.mass += ratio * ratio * mass;
      };
      for (NearEdge &node : edge.nodes)
        node.mass = node.p = 0.;
      for (NearEdge &node : edge.nodes)
      {
        if (!node.beside || node.distance >= beside)
          continue;
        node.prescribed = prescribed(edge, motion, node, step);
        if (node.master < 0)
          continue;
        NearEdge &master = edge.nodes[node.master];
        if (!(master.mass > 0.))
        {
          master.prescribed = prescribed(edge, motion, master, step);
          add(master, master, 1.);
        }
        add(master, node, node.ratio);
      }
      const auto excess = [](const NearEdge &master)
      { return master.mass > 0. ? master.p / master.mass : 0.; };
      Support *const support = step.count_reaction ? &supports.all[edge.line.support] : nullptr;
      const auto set = [&](const NearEdge &node, const double beyond)
      {
        set_velocity(supports, support, grid,
                     held_by(edge, grid, node.node, node.prescribed + beyond));
      };
      for (const NearEdge &node : edge.nodes)
        if (node.beside && node.distance < beside)
          set(node, node.master < 0 ? 0. : node.ratio * excess(edge.nodes[node.master]));
        else if (node.mass > 0.)
          set(node, excess(node));
    }
  }

  void move_turning_edges(const Supports &supports, Tracers &tracers, const double t)
  {
    for (const TurningEdge &edge : supports.edges)
      for (auto &outline : tracers.outlines)
        for (Tracer &tracer : outline)
          if (tracer.lines & edge.line.bit)
          {
            const int c = edge.component();
            tracer.x[c] =
                tracer.X[c] + supports.all[edge.line.support].motion.at(tracer.X, tracer.x, t)[c];
          }
  }
} // namespace solid
