#include <stdexcept>

#include "solid/area_budget.h"
#include "solid/energy.h"
#include "solid/seeding.h"
#include "solid/splitting.h"

namespace solid
{
  namespace
  {
    struct Filling
    {
      Solid &solid;
      const medium::CellAreas &areas;
      medium::CellValues &owed;

      Point share() const
      {
        return {solid.grid.dx / solid.points_per_cell[0], solid.grid.dx / solid.points_per_cell[1]};
      }
    };

    // A point in each share that is filled well enough, at the centroid of what fills it.
    void fill_cell(Filling &fill, const int i, const int j)
    {
      Solid &solid = fill.solid;
      const medium::CellPart part = fill.areas.part(i, j);
      const Point share = fill.share();
      const Point corner(solid.grid.node_x(i), solid.grid.node_y(j));
      double owed = part.area();
      for (int b = 0; b < solid.points_per_cell[1]; ++b)
        for (int a = 0; a < solid.points_per_cell[0]; ++a)
        {
          const Point lower = corner + share.cwiseProduct(Point(a, b));
          const Point upper = corner + share.cwiseProduct(Point(a + 1, b + 1));
          double area = 0.;
          Point moment = Point::Zero();
          for (int k = 0; k < part.pieces; ++k)
          {
            const medium::ConvexPolygon piece = medium::clip(part.piece[k], {lower, upper});
            const double of_piece = medium::area(piece);
            if (of_piece > 0.)
              area += of_piece, moment += of_piece * medium::centroid(piece);
          }
          if (area < least_share * share.prod())
            continue;
          add_point(solid.points, solid.fraction, moment / area, solid.material.density * area);
          owed -= area;
        }
      if (owed != 0.)
        fill.owed.push_back({static_cast<long>(j) * solid.grid.cells[0] + i, owed});
    }

    void fill_whole_cell(Solid &solid, const int i, const int j)
    {
      const auto &[nx, ny] = solid.points_per_cell;
      const double mass = solid.material.density * solid.grid.dx * solid.grid.dx / (nx * ny);
      for (int b = 0; b < ny; ++b)
        for (int a = 0; a < nx; ++a)
          add_point(solid.points, solid.fraction,
                    {solid.grid.node_x(i) + (a + 0.5) / nx * solid.grid.dx,
                     solid.grid.node_y(j) + (b + 0.5) / ny * solid.grid.dx},
                    mass);
    }
  } // namespace

  bool active(const Solid &solid)
  {
    return solid.growing != nullptr;
  }

  void activate(Solid &solid, const Crystal &crystal, const double time)
  {
    if (solid.points.size() > 0 || solid.growing)
      throw std::logic_error("a solid that has material points cannot be made from phi again");
    solid.growing = std::make_unique<Growing>(solid.domain);
    Growing &growing = *solid.growing;
    growing.map.measure(crystal.phi, crystal.mesh, crystal.between_walls);
    growing.budget.activated = growing.map.total();
    const medium::CellAreas areas(crystal.phi, crystal.mesh, crystal.between_walls);
    Filling fill{solid, areas, growing.owed};
    constexpr double grows_on = 1.05;
    reserve(solid.points,
            static_cast<std::size_t>(grows_on * growing.map.total() / fill.share().prod()));
    for (int j = areas.first_cell(1); j < areas.end_cell(1); ++j)
      for (int i = areas.first_cell(0); i < areas.end_cell(0); ++i)
      {
        const unsigned corners = areas.corners(i, j);
        if (corners == 15u && !areas.cut(0, i) && !areas.cut(1, j))
          fill_whole_cell(solid, i, j);
        else if (corners != 0u)
          fill_cell(fill, i, j);
      }
    solid.points.active = solid.points.size();
    square_edges(solid.points, solid.material.density, 0);
    solid.time = time;
    solid.grid.drift = solid.grid.dx; // sort before anything moves
  }

  void set_initial_state(Solid &solid, const std::vector<scene::Body> &bodies)
  {
    initialise(solid.points, solid.fraction, 0, bodies, 1e-4 * solid.grid.dx);
    start_energy_account(solid);
  }
} // namespace solid
