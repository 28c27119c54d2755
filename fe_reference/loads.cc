#include "loads.h"

#include <algorithm>
#include <cmath>

#include "outline_lengths.h"
#include "scene/geometry.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    // Three Gauss points on the loaded part: exact for the fifth degree.
    struct SidePoint
    {
      double s, weight;
      std::array<double, 3> value{}, slope{};
    };

    SidePoint side_point(const int degree, const double s, const double weight)
    {
      SidePoint p{s, weight};
      if (degree == 1)
      {
        p.value = {1. - s, s, 0.};
        p.slope = {-1., 1., 0.};
      }
      else
      {
        p.value = {(2. * s - 1.) * (s - 1.), 4. * s * (1. - s), s * (2. * s - 1.)};
        p.slope = {4. * s - 3., 4. - 8. * s, 4. * s - 1.};
      }
      return p;
    }

    std::array<SidePoint, 3> side_points(const int degree, const Loads::LoadedSide &loaded)
    {
      const double half = 0.5 * (loaded.to - loaded.from), middle = loaded.from + half;
      const double offset = std::sqrt(0.6) * half;
      return {side_point(degree, middle - offset, 5. / 9. * half),
              side_point(degree, middle, 8. / 9. * half),
              side_point(degree, middle + offset, 5. / 9. * half)};
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

    // The parts of a side on which the load acts: whole where its nodes are loaded, else found by
    // looking along it and halving where the load begins and ends.
    void add_loaded_parts(const scene::Where &where, const scene::Box &box,
                          const BoundarySide &side, const Discretisation &d, const double tolerance,
                          std::vector<Loads::LoadedSide> &parts)
    {
      const auto in = [&](const double s)
      {
        const SidePoint point = side_point(d.degree, s, 0.);
        Point X = Point::Zero();
        for (int k = 0; k <= d.degree; ++k)
          X += point.value[k] * d.position[side.node[k]];
        return scene::contains(where, box, X, tolerance);
      };
      if (in(0.) && in(0.5) && in(1.))
      {
        parts.push_back({side, 0., 1.});
        return;
      }
      const auto change = [&](double a, double b)
      {
        const bool first = in(a);
        for (int halving = 0; halving < 40; ++halving)
          (in(0.5 * (a + b)) == first ? a : b) = 0.5 * (a + b);
        return 0.5 * (a + b);
      };
      constexpr int intervals = 32;
      bool loaded = in(0.);
      double from = 0.;
      const auto close = [&](const double to)
      {
        if (to - from > 1e-6) // else it only touches the corner of an edge beside it
          parts.push_back({side, from, to});
      };
      for (int k = 0; k < intervals; ++k)
      {
        const double a = k / double(intervals), b = (k + 1) / double(intervals);
        if (in(b) == loaded)
          continue;
        if (loaded)
          close(change(a, b));
        else
          from = change(a, b);
        loaded = !loaded;
      }
      if (loaded)
        close(1.);
    }

    void add_tractions(const Loads &loads, const Discretisation &d, const std::vector<double> &u,
                       const double t, std::vector<double> &force)
    {
      for (const Loads::Traction &traction : loads.tractions)
        for (const Loads::LoadedSide &loaded : traction.sides)
        {
          const BoundarySide &side = loaded.side;
          if (!d.owned[side.cell])
            continue;
          for (const SidePoint &point : side_points(d.degree, loaded))
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
    const double tolerance = matching_tolerance(box);
    std::optional<OutlineLengths> lengths;
    if (!scene.tractions.empty())
      lengths.emplace(scene, d);
    for (const scene::Traction &traction : scene.tractions)
    {
      Loads::Traction load{
          {}, {scene::Function(traction.traction[0]), scene::Function(traction.traction[1])}};
      if (traction.pressure)
        load.pressure.emplace(*traction.pressure);
      for (const BoundarySide &side : d.boundary)
        add_loaded_parts(traction.where, box, side, d, tolerance, load.sides);
      if (load.sides.empty())
        throw scene::BadScene(traction.place.file + ":" + std::to_string(traction.place.line) +
                              ": traction '" + traction.name +
                              "' acts on no side of the mesh; name an edge of the outline or a "
                              "segment on it");
      double length = 0.;
      for (const Loads::LoadedSide &part : load.sides)
        length += (part.to - part.from) *
                  (d.position[part.side.node[d.degree]] - d.position[part.side.node[0]]).norm();
      lengths->check([&](const Point &X)
                     { return scene::contains(traction.where, box, X, tolerance); },
                     length, traction.place, "traction '" + traction.name + "' acts on");
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

  std::vector<double> side_stiffness(const Loads::Traction &traction,
                                     const Loads::LoadedSide &loaded, const Discretisation &d,
                                     const std::vector<double> &u, const double t)
  {
    const int unknowns = 2 * (d.degree + 1);
    std::vector<double> stiffness(unknowns * unknowns, 0.);
    for (const SidePoint &point : side_points(d.degree, loaded))
    {
      const SideState state = side_state(traction, loaded.side, d, u, t, point);
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
