#include <cmath>
#include <stdexcept>

#include "medium/walls.h"

namespace medium
{
  namespace
  {
    /// The cut that belongs to the wall's position: none before it has moved at all.
    std::optional<Cut> cut_of(const Wall &wall, const std::optional<Cut> &before, const Mesh &mesh)
    {
      const int axis = wall.axis(), inward = wall.inward();
      if (wall.travel <= 0.)
        return std::nullopt;
      const double line = (wall.position - mesh.lower[axis]) / mesh.spacing[axis];
      int last = before ? before->last : (inward > 0 ? 1 : mesh.nodes[axis] - 2);
      // Opposite walls pass the middle of their cells in the same step, whatever rounding says.
      while (inward * (last - line) < 0.5 - 1e-9)
        last += inward;
      return Cut{last, inward * (last - line)};
    }

    /// Lines of nodes across one axis, `last` included.
    struct Lines
    {
      int axis, first, last;
    };

    /// Integral of `field` over these lines, with the present cuts.
    double integral(const Field<double> &field, const Lines &lines, const Cuts &cuts,
                    const Mesh &mesh)
    {
      const auto &[axis, first, last] = lines;
      double sum = 0.;
      for (int line = first; line <= last; ++line)
      {
        double along = 0.;
        for (int n = cuts.first(1 - axis); n < cuts.end(1 - axis, mesh.nodes[1 - axis]); ++n)
          along += cuts.size(1 - axis, n, mesh.nodes[1 - axis]) *
                   (axis == 0 ? field(line, n) : field(n, line));
        sum += cuts.size(axis, line, mesh.nodes[axis]) * along;
      }
      return sum * mesh.spacing[0] * mesh.spacing[1];
    }

    void continue_behind(const WalledField &field, const Cuts &cuts, const Mesh &mesh)
    {
      const Image image = field.gradients ? field.gradients->image : Image::scalar;
      fill_behind(*field.value, cuts, mesh, Parity::even, image);
      if (!field.gradients || field.gradients->x.empty())
        return;
      Gradients &gradients = *field.gradients;
      fill_behind(gradients.x, cuts, mesh, Parity::odd_in_x, image);
      fill_behind(gradients.y, cuts, mesh, Parity::odd_in_y, image);
      if (!gradients.xy.empty())
        fill_behind(gradients.xy, cuts, mesh, Parity::odd_in_both, image);
      if (!gradients.last.empty())
        fill_behind(gradients.last, cuts, mesh, Parity::even, image);
    }

    /// One component behind one wall: through `value` at the wall in the next line, `value` beyond;
    /// evenly if `slides`.
    void continue_velocity(Field<double> &component, const Wall &wall, const Cut &cut, double value,
                           bool slides, const Mesh &mesh)
    {
      const int axis = wall.axis(), outward = -wall.inward();
      const int behind = outward > 0 ? mesh.nodes[axis] - 1 - cut.last : cut.last;
      const double share = (cut.gap - 1.) / cut.gap;
      for (int n = 0; n < mesh.nodes[1 - axis]; ++n)
        for (int k = 1; k <= behind; ++k)
        {
          const int line = cut.last + outward * k;
          const double at_last = axis == 0 ? component(cut.last, n) : component(n, cut.last);
          const double through = k == 1 ? value + share * (at_last - value) : value;
          (axis == 0 ? component(line, n) : component(n, line)) = slides ? at_last : through;
        }
    }
  } // namespace

  void update_cuts(Walls &walls, const Mesh &mesh, const std::vector<WalledField> &fields)
  {
    for (const Wall &wall : walls.walls)
    {
      std::optional<Cut> &cut = walls.cuts.at(wall.side);
      const std::optional<Cut> next = cut_of(wall, cut, mesh);
      if (!next)
        continue;
      const int axis = wall.axis(), inward = wall.inward();
      const int from = cut ? cut->last : (inward > 0 ? 0 : mesh.nodes[axis] - 1);
      const Lines passed{axis, std::min(from, next->last), std::max(from, next->last)};
      std::vector<double> before;
      for (const WalledField &field : fields)
        before.push_back(integral(*field.value, passed, walls.cuts, mesh));
      cut = next;
      for (std::size_t f = 0; f < fields.size(); ++f)
        if (fields[f].swept)
          *fields[f].swept += before[f] - integral(*fields[f].value, passed, walls.cuts, mesh);
    }
    for (const WalledField &field : fields)
      continue_behind(field, walls.cuts, mesh);
  }

  void fill_behind(Velocity &velocity, const Walls &walls, const Mesh &mesh)
  {
    for (const Wall &wall : walls.walls)
    {
      const auto &cut = walls.cuts.at(wall.side);
      if (!cut)
        continue;
      Field<double> &across = wall.axis() == 0 ? velocity.x : velocity.y;
      Field<double> &along = wall.axis() == 0 ? velocity.y : velocity.x;
      continue_velocity(across, wall, *cut, wall.velocity, false, mesh);
      continue_velocity(along, wall, *cut, 0., wall.grip == WallGrip::slip, mesh);
    }
    fill_ghosts(velocity.x, mesh, Parity::odd_in_x);
    fill_ghosts(velocity.y, mesh, Parity::odd_in_y);
  }

  std::vector<double> pack(const Walls &walls)
  {
    std::vector<double> state{walls.swept_heat, walls.swept_phase};
    for (const Wall &wall : walls.walls)
    {
      const auto &cut = walls.cuts.at(wall.side);
      for (const double number :
           {wall.position, wall.velocity, wall.travel, wall.started ? 1. : 0.,
            wall.started.value_or(0.), wall.touched ? 1. : 0., wall.touched.value_or(0.),
            wall.travel_at_touch, wall.span_at_touch, cut ? 1. : 0.,
            cut ? static_cast<double>(cut->last) : 0., cut ? cut->gap : 0.})
        state.push_back(number);
    }
    return state;
  }

  void unpack(Walls &walls, const std::vector<double> &state)
  {
    if (state.size() != 2 + 12 * walls.walls.size())
      throw std::runtime_error("the checkpoint holds the state of other walls than the scene's");
    walls.swept_heat = state[0], walls.swept_phase = state[1];
    const double *at = state.data() + 2;
    for (Wall &wall : walls.walls)
    {
      wall.position = at[0], wall.velocity = at[1], wall.travel = at[2];
      wall.started = at[3] != 0. ? std::optional<double>(at[4]) : std::nullopt;
      wall.touched = at[5] != 0. ? std::optional<double>(at[6]) : std::nullopt;
      wall.travel_at_touch = at[7], wall.span_at_touch = at[8];
      walls.cuts.at(wall.side) =
          at[9] != 0. ? std::optional<Cut>(Cut{static_cast<int>(at[10]), at[11]}) : std::nullopt;
      at += 12;
    }
  }
} // namespace medium
