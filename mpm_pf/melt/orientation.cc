#include "melt/orientation.h"

#include <algorithm>
#include <cmath>

namespace melt
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    /// cos and sin of four times an angle: the angle is reduced to within 45 degrees of a multiple
    /// of 90, its Taylor series summed (16th and 17th order: below 1e-18 there), and doubled twice.
    inline void four_fold(double angle, double &cosine, double &sine)
    {
      const double quarter = std::nearbyint(angle * (2. / pi));
      const double x = (angle - quarter * 1.5707963267341256) - quarter * 6.077100506506192e-11;
      const double q = x * x;
      double s = 1. / 355687428096000.;
      s = s * q - 1. / 1307674368000.;
      s = s * q + 1. / 6227020800.;
      s = s * q - 1. / 39916800.;
      s = s * q + 1. / 362880.;
      s = s * q - 1. / 5040.;
      s = s * q + 1. / 120.;
      s = s * q - 1. / 6.;
      s = x + x * q * s;
      double c = 1. / 20922789888000.;
      c = c * q - 1. / 87178291200.;
      c = c * q + 1. / 479001600.;
      c = c * q - 1. / 3628800.;
      c = c * q + 1. / 40320.;
      c = c * q - 1. / 720.;
      c = c * q + 1. / 24.;
      c = 1. - 0.5 * q + q * q * c;
      const double c2 = (c - s) * (c + s), s2 = 2. * c * s;
      cosine = (c2 - s2) * (c2 + s2);
      sine = 2. * c2 * s2;
    }

    /// Eq. (3), spin: dt/2 (dv/dx - du/dy) from centred differences along one row.
    struct Spin
    {
      const double *v, *above, *below; // v of the row; u of the rows beside it
      double x, y;                     // dt/(4 h)
      Spin(const medium::Velocity &velocity, const int j, const double dt, const Mesh &mesh)
          : v(velocity.y.row(j)), above(velocity.x.row(j + 1)), below(velocity.x.row(j - 1)),
            x(dt / (4. * mesh.spacing[0])), y(dt / (4. * mesh.spacing[1]))
      {
      }
      double at(const int i) const { return x * (v[i + 1] - v[i - 1]) - y * (above[i] - below[i]); }
    };

    /// Does the difference at node (i, j) of the solid reach into the melt? Sides are mirrors.
    bool reaches_out(const Field<double> &psi, const int i, const int j)
    {
      const int left = std::max(i - 1, 0), right = std::min(i + 1, psi.nodes(0) - 1);
      const int below = std::max(j - 1, 0), above = std::min(j + 1, psi.nodes(1) - 1);
      return psi(i, j) >= 0. &&
             std::min({psi(left, j), psi(right, j), psi(i, below), psi(i, above)}) < 0.;
    }

    /// Extended without slope across the front, the velocity of the melt says nothing of how the
    /// solid turns: a difference over the front loses up to half of the normal derivative, and the
    /// melt inherits what comes of it. Solid nodes there take the spin of the line that was fitted
    /// to the solid alone; a piece that knows no gradient (a tip of one row of nodes) leaves them
    /// the difference.
    void spin_of_the_solid(Field<double> &angle, const medium::Velocity &velocity, const double dt,
                           const Mesh &mesh, const medium::Extension &front)
    {
      const medium::Distance &distance = front.distance;
      const medium::Tiles &tiles = distance.close;
#pragma omp parallel for schedule(static)
      for (int j = 0; j < mesh.nodes[1]; ++j)
      {
        const Spin across(velocity, j, dt, mesh);
        for (int column = 0; column < tiles.columns; ++column)
          if (tiles.at(column, j / medium::Tiles::height) == medium::Activity::active)
            for (int i = tiles.first_node(column); i < tiles.end_node(column); ++i)
            {
              const int owner = distance.piece(i, j);
              if (owner < 0 || !reaches_out(distance.psi, i, j))
                continue;
              const medium::PieceValue &u = front.at_pieces[0][static_cast<std::size_t>(owner)],
                                       &v = front.at_pieces[1][static_cast<std::size_t>(owner)];
              if (u.slope_x != 0. || u.slope_y != 0. || v.slope_x != 0. || v.slope_y != 0.)
                angle(i, j) += 0.5 * dt * (v.slope_x - u.slope_y) - across.at(i);
            }
      }
    }
  } // namespace

  std::size_t Orientation::bytes() const
  {
    return angle.bytes() + cosine.bytes() + sine.bytes() + gradients.bytes();
  }

  Orientation make_orientation(double angle_degrees)
  {
    Orientation made;
    made.gradients.image = medium::Image::angle;
    made.uniform_angle = angle_degrees * pi / 180.;
    const double eighths = angle_degrees / 22.5; // four times 22.5 degrees is a right angle
    const double whole = std::nearbyint(eighths);
    const int quadrant = ((static_cast<int>(whole) % 4) + 4) % 4;
    constexpr double cosines[] = {1., 0., -1., 0.}, sines[] = {0., 1., 0., -1.};
    const double rest = (eighths - whole) * pi / 2.; // of four times the angle
    const double c = std::cos(rest), s = std::sin(rest);
    made.uniform_cosine = cosines[quadrant] * c - sines[quadrant] * s;
    made.uniform_sine = sines[quadrant] * c + cosines[quadrant] * s;
    return made;
  }

  void allocate_angle_field(Orientation &orientation, const Mesh &mesh)
  {
    if (orientation.varying())
      return;
    orientation.angle = Field<double>(mesh, orientation.uniform_angle);
    orientation.cosine = Field<double>(mesh, orientation.uniform_cosine);
    orientation.sine = Field<double>(mesh, orientation.uniform_sine);
  }

  void cos_sin_of_four_times(const Field<double> &angle, Field<double> &cosine, Field<double> &sine)
  {
    constexpr int ghosts = medium::ghost_layers;
#pragma omp parallel for schedule(static)
    for (int j = -ghosts; j < angle.nodes(1) + ghosts; ++j)
    {
      const double *a = angle.row(j);
      double *c = cosine.row(j), *s = sine.row(j);
#pragma omp simd
      for (int i = -ghosts; i < angle.nodes(0) + ghosts; ++i)
        four_fold(a[i], c[i], s[i]);
    }
  }

  void refresh(Orientation &orientation, const Mesh &mesh)
  {
    medium::fill_ghosts(orientation.angle, mesh, medium::Parity::even, medium::Image::angle);
    cos_sin_of_four_times(orientation.angle, orientation.cosine, orientation.sine);
  }

  void advance_orientation(Orientation &orientation, const medium::Velocity &velocity, double dt,
                           const Mesh &mesh, medium::Advection &advection,
                           const medium::Extension *const front)
  {
    allocate_angle_field(orientation, mesh);
    advection.advect(orientation.angle, orientation.gradients, velocity, dt);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < mesh.nodes[1]; ++j)
    {
      const Spin spin(velocity, j, dt, mesh);
      double *angle = orientation.angle.row(j);
#pragma omp simd
      for (int i = 0; i < mesh.nodes[0]; ++i)
        angle[i] += spin.at(i);
    }
    if (front)
      spin_of_the_solid(orientation.angle, velocity, dt, mesh, *front);
    refresh(orientation, mesh);
  }
} // namespace melt
