#include "loads.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    // Three Gauss points on [0, 1]: exact for the fifth degree.
    struct SidePoint
    {
      double s, weight;
      std::array<double, 3> value{}, slope{};
    };

    std::array<SidePoint, 3> side_points(const int degree)
    {
      const double offset = 0.5 * std::sqrt(0.6);
      std::array<SidePoint, 3> points{SidePoint{0.5 - offset, 5. / 18.}, SidePoint{0.5, 8. / 18.},
                                      SidePoint{0.5 + offset, 5. / 18.}};
      for (SidePoint &p : points)
        if (degree == 1)
        {
          p.value = {1. - p.s, p.s, 0.};
          p.slope = {-1., 1., 0.};
        }
        else
        {
          p.value = {(2. * p.s - 1.) * (p.s - 1.), 4. * p.s * (1. - p.s), p.s * (2. * p.s - 1.)};
          p.slope = {4. * p.s - 3., 4. - 8. * p.s, 4. * p.s - 1.};
        }
      return points;
    }

    struct SideState
    {
      Point traction = Point::Zero(), tangent = Point::Zero();
      double pressure = 0.;

      // Force per unit of the side's parameter.
      Point density() const
      {
        return traction * tangent.norm() + pressure * Point(-tangent[1], tangent[0]);
      }
    };

    SideState side_state(const Loads::Traction &traction, const BoundarySide &side,
                         const Discretisation &d, const std::vector<double> &u, const double t,
                         const SidePoint &point)
    {
      scene::Argument argument;
      argument.t = t;
      SideState state;
      for (int k = 0; k <= d.degree; ++k)
      {
        const int n = side.node[k];
        const Point x = d.position[n] + Point(u[2 * n], u[2 * n + 1]);
        argument.X += point.value[k] * d.position[n];
        argument.x += point.value[k] * x;
        state.tangent += point.slope[k] * x;
      }
      if (traction.pressure)
        state.pressure = (*traction.pressure)(argument);
      else
        state.traction = Point(traction.traction[0](argument), traction.traction[1](argument));
      return state;
    }

    void add_tractions(const Loads &loads, const Discretisation &d, const std::vector<double> &u,
                       const double t, std::vector<double> &force)
    {
      const auto points = side_points(d.degree);
      for (const Loads::Traction &traction : loads.tractions)
        for (const BoundarySide &side : traction.sides)
        {
          if (!d.owned[side.cell])
            continue;
          for (const SidePoint &point : points)
          {
            const SideState state = side_state(traction, side, d, u, t, point);
            const Point density = state.density();
            for (int k = 0; k <= d.degree; ++k)
              for (int c = 0; c < 2; ++c)
                force[2 * side.node[k] + c] += point.weight * point.value[k] * density[c];
          }
        }
    }

    void add_body_force(const Loads &loads, const Discretisation &d, const std::vector<double> &u,
                        const double t, std::vector<double> &force)
    {
      for (int cell = 0; cell < d.cells; ++cell)
      {
        if (!d.owned[cell])
          continue;
        const int *nodes = d.nodes_of(cell);
        for (int q = 0; q < d.points_per_cell; ++q)
        {
          const double *shape = d.shape.data() + q * d.nodes_per_cell;
          scene::Argument argument;
          argument.t = t;
          for (int a = 0; a < d.nodes_per_cell; ++a)
          {
            argument.X += shape[a] * d.position[nodes[a]];
            argument.x += shape[a] * Point(u[2 * nodes[a]], u[2 * nodes[a] + 1]);
          }
          argument.x += argument.X;
          const double mass = loads.density * d.weight[cell * d.points_per_cell + q];
          for (int c = 0; c < 2; ++c)
          {
            const double b = mass * (*loads.acceleration)[c](argument);
            for (int a = 0; a < d.nodes_per_cell; ++a)
              force[2 * nodes[a] + c] += shape[a] * b;
          }
        }
      }
    }
  } // namespace

  Loads make_loads(const scene::Scene &scene, const Discretisation &d)
  {
    Loads loads;
    loads.density = scene.solid->density;
    if (scene.body_force)
      loads.acceleration =
          std::array<scene::Function, 2>{scene::Function(scene.body_force->acceleration[0]),
                                         scene::Function(scene.body_force->acceleration[1])};
    const scene::Box box = scene::bounding_box(scene.bodies);
    const double tolerance = 1e-9 * (box.upper - box.lower).norm();
    for (const scene::Traction &traction : scene.tractions)
    {
      Loads::Traction load{
          {}, {scene::Function(traction.traction[0]), scene::Function(traction.traction[1])}};
      if (traction.pressure)
        load.pressure.emplace(*traction.pressure);
      for (const BoundarySide &side : d.boundary)
        if (std::all_of(side.node.begin(), side.node.begin() + d.degree + 1,
                        [&](const int n)
                        { return scene::contains(traction.where, box, d.position[n], tolerance); }))
          load.sides.push_back(side);
      if (load.sides.empty())
        throw scene::BadScene(traction.place.file + ":" + std::to_string(traction.place.line) +
                              ": traction '" + traction.name +
                              "' acts on no side of the mesh; name an edge or segment that "
                              "covers at least one side of a cell");
      loads.tractions.push_back(std::move(load));
    }
    return loads;
  }

  std::vector<double> external_forces(const Loads &loads, const Discretisation &d,
                                      const std::vector<double> &u, const double t)
  {
    std::vector<double> force(d.unknowns(), 0.);
    if (!loads.tractions.empty())
      add_tractions(loads, d, u, t, force);
    if (loads.acceleration)
      add_body_force(loads, d, u, t, force);
    return force;
  }

  std::vector<double> side_stiffness(const Loads::Traction &traction, const BoundarySide &side,
                                     const Discretisation &d, const std::vector<double> &u,
                                     const double t)
  {
    const int unknowns = 2 * (d.degree + 1);
    std::vector<double> stiffness(unknowns * unknowns, 0.);
    for (const SidePoint &point : side_points(d.degree))
    {
      const SideState state = side_state(traction, side, d, u, t, point);
      Eigen::Matrix2d derivative = state.traction * state.tangent.normalized().transpose();
      derivative(0, 1) -= state.pressure;
      derivative(1, 0) += state.pressure;
      for (int i = 0; i < unknowns; ++i)
        for (int j = 0; j < unknowns; ++j)
          stiffness[i * unknowns + j] +=
              point.weight * point.value[i / 2] * derivative(i % 2, j % 2) * point.slope[j / 2];
    }
    return stiffness;
  }
} // namespace fe
