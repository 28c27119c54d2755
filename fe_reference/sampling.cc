#include "sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "point_numbers.h"
#include "scene/geometry.h"

namespace fe
{
  namespace
  {
    Point node_position(const Snapshot &body, const int node, const scene::Frame frame)
    {
      const Point &X = body.problem.mesh.position[node];
      return frame == scene::Frame::material ? X
                                             : X + Point(body.u[2 * node], body.u[2 * node + 1]);
    }
  } // namespace

  std::vector<char> folded_cells(const Problem &problem, const std::vector<double> &u,
                                 double &smallest)
  {
    const Discretisation &d = problem.mesh;
    std::vector<char> folded(d.cells, 0);
    std::vector<double> gradient(2 * d.nodes_per_cell);
    smallest = std::numeric_limits<double>::infinity();
    for (int cell = 0; cell < d.cells; ++cell)
      for (const Point &unit : d.unit_node)
      {
        shape_functions(d.degree, d.unit_node, unit, nullptr, gradient.data());
        Matrix2 initial = Matrix2::Zero(), current = Matrix2::Zero();
        for (int a = 0; a < d.nodes_per_cell; ++a)
        {
          const int n = d.nodes_of(cell)[a];
          const Eigen::RowVector2d slope(gradient[2 * a], gradient[2 * a + 1]);
          initial += d.position[n] * slope;
          current += (d.position[n] + Point(u[2 * n], u[2 * n + 1])) * slope;
        }
        const double ratio = current.determinant() / initial.determinant();
        smallest = std::min(smallest, ratio);
        folded[cell] |= ratio <= 0.;
      }
    return folded;
  }

  Snapshot make_snapshot(const Problem &problem, const State &now, const State &before)
  {
    std::vector<double> velocity(now.u.size(), 0.);
    if (now.time > before.time)
      for (std::size_t k = 0; k < velocity.size(); ++k)
        velocity[k] = (now.u[k] - before.u[k]) / (now.time - before.time);
    double smallest = 0.;
    return {problem,
            now.time,
            now.u,
            std::move(velocity),
            unpack_points(gather_points(problem.mesh, now.points)),
            folded_cells(problem, now.u, smallest)};
  }

  Point position_in(const Snapshot &body, const Location &at, const scene::Frame frame,
                    Matrix2 *slope)
  {
    const Discretisation &d = body.problem.mesh;
    std::array<double, 9> value{};
    std::array<double, 18> gradient{};
    shape_functions(d.degree, d.unit_node, at.unit, value.data(), gradient.data());
    Point x = Point::Zero();
    if (slope)
      slope->setZero();
    for (int a = 0; a < d.nodes_per_cell; ++a)
    {
      const Point p = node_position(body, d.nodes_of(at.cell)[a], frame);
      x += value[a] * p;
      if (slope)
        *slope += p * Eigen::RowVector2d(gradient[2 * a], gradient[2 * a + 1]);
    }
    return x;
  }

  scene::Box box_of_cell(const Snapshot &body, const int cell, const scene::Frame frame)
  {
    const Discretisation &d = body.problem.mesh;
    Point lower = node_position(body, d.nodes_of(cell)[0], frame), upper = lower;
    for (int a = 1; a < d.nodes_per_cell; ++a)
    {
      const Point p = node_position(body, d.nodes_of(cell)[a], frame);
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    const Point margin = 0.25 * (upper - lower); // curved sides leave the box of their nodes
    return {lower - margin, upper + margin};
  }

  std::optional<Location> locate(const Snapshot &body, const Point &x, const scene::Frame frame)
  {
    const Discretisation &d = body.problem.mesh;
    constexpr double tolerance = 1e-8; // of the unit square: points on a side belong to the cell
    for (int cell = 0; cell < d.cells; ++cell)
    {
      const scene::Box box = box_of_cell(body, cell, frame);
      if ((x.array() < box.lower.array()).any() || (x.array() > box.upper.array()).any())
        continue;
      Location at{cell, Point(0.5, 0.5)};
      for (int iteration = 0; iteration < 20; ++iteration)
      {
        Matrix2 slope;
        const Point miss = x - position_in(body, at, frame, &slope);
        if (!(std::abs(slope.determinant()) > 0.))
          break;
        const Point step = slope.inverse() * miss;
        at.unit += step;
        if (at.unit.cwiseAbs().maxCoeff() > 3.)
          break;
        if (step.norm() < 1e-12)
          break;
      }
      if (at.unit.minCoeff() > -tolerance && at.unit.maxCoeff() < 1. + tolerance &&
          (x - position_in(body, at, frame)).norm() < 1e-8 * (box.upper - box.lower).norm())
        return at;
    }
    return std::nullopt;
  }

  std::optional<Location> locate_material(const Snapshot &body, const Point &x,
                                          const scene::Frame frame)
  {
    constexpr double sagitta = 0.1; // of a side, on the sharpest curve that is worth a mesh
    const std::optional<Location> inside = locate(body, x, frame);
    if (inside || frame != scene::Frame::material || !body.starts_in || !body.starts_in(x))
      return inside;
    const Discretisation &d = body.problem.mesh;
    double nearest = std::numeric_limits<double>::infinity();
    Point foot = x;
    for (const BoundarySide &side : d.boundary)
    {
      const Point &a = d.position[side.node[0]], &b = d.position[side.node[d.degree]];
      const Point along = b - a;
      const double s = scene::along_segment(x, a, b);
      const double distance = (x - a - s * along).norm();
      if (distance < nearest && distance < sagitta * along.norm())
        nearest = distance, foot = a + s * along;
    }
    return nearest < std::numeric_limits<double>::infinity() ? locate(body, foot, frame) : inside;
  }
} // namespace fe
