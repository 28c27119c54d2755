#include "melt/tip.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <Eigen/Dense>

namespace melt
{
  namespace
  {
    /// psi at a node of any index: mirrored or wrapped where it lies outside the mesh.
    double psi_at(const Field<double> &phi, const Mesh &mesh, int i, int j, double width)
    {
      using medium::Edge;
      const int a =
          medium::source_index(i, mesh.nodes[0], mesh.side(Edge::left), mesh.side(Edge::right));
      const int b =
          medium::source_index(j, mesh.nodes[1], mesh.side(Edge::bottom), mesh.side(Edge::top));
      constexpr double clip = 0.99999;
      return std::sqrt(2.) * width * std::atanh(std::clamp(phi(a, b), -clip, clip));
    }

    /// Lagrange weights of the places -1, 0, 1, 2 at s in [0, 1].
    std::array<double, 4> cubic_weights(double s)
    {
      return {-s * (s - 1.) * (s - 2.) / 6., (s + 1.) * (s - 1.) * (s - 2.) / 2.,
              -(s + 1.) * s * (s - 2.) / 2., (s + 1.) * s * (s - 1.) / 6.};
    }

    double interpolated_psi(const Field<double> &phi, const Mesh &mesh, const Point &x,
                            double width)
    {
      const Point cell = (x - mesh.lower).cwiseQuotient(mesh.spacing);
      const int i = std::clamp(static_cast<int>(std::floor(cell[0])), 0, mesh.nodes[0] - 2);
      const int j = std::clamp(static_cast<int>(std::floor(cell[1])), 0, mesh.nodes[1] - 2);
      const auto wx = cubic_weights(cell[0] - i), wy = cubic_weights(cell[1] - j);
      double value = 0.;
      for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a)
          value += wx[static_cast<std::size_t>(a)] * wy[static_cast<std::size_t>(b)] *
                   psi_at(phi, mesh, i + a - 1, j + b - 1, width);
      return value;
    }

    /// How far the ray runs inside the mesh.
    double length_inside(const Mesh &mesh, const Point &origin, const Point &unit)
    {
      double length = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 2; ++axis)
      {
        const double low = mesh.lower[axis];
        const double high =
            low + (mesh.nodes[static_cast<std::size_t>(axis)] - 1) * mesh.spacing[axis];
        const double slack = 1e-9 * mesh.spacing[axis];
        if (origin[axis] < low - slack || origin[axis] > high + slack)
          throw std::invalid_argument("tip probe: its origin lies outside the domain");
        if (unit[axis] != 0.)
          length = std::min(length, ((unit[axis] > 0. ? high : low) - origin[axis]) / unit[axis]);
      }
      return length;
    }

    /// Cubic polynomial of two variables: the ten terms at (s, t).
    Eigen::Matrix<double, 1, 10> cubic_terms(double s, double t)
    {
      Eigen::Matrix<double, 1, 10> row;
      row << 1., s, t, s * s, s * t, t * t, s * s * s, s * s * t, s * t * t, t * t * t;
      return row;
    }

    void fit_radius(Tip &tip, const Field<double> &phi, const Mesh &mesh, const Point &at,
                    double width)
    {
      const double spacing = mesh.spacing.maxCoeff();
      tip.window = std::max(2.5 * spacing, width);
      const Point cell = (at - mesh.lower).cwiseQuotient(mesh.spacing);
      const int reach_x = static_cast<int>(tip.window / mesh.spacing[0]) + 1;
      const int reach_y = static_cast<int>(tip.window / mesh.spacing[1]) + 1;
      const int i0 = static_cast<int>(std::lround(cell[0]));
      const int j0 = static_cast<int>(std::lround(cell[1]));
      std::vector<Point> place;
      std::vector<double> psi;
      for (int j = j0 - reach_y; j <= j0 + reach_y; ++j)
        for (int i = i0 - reach_x; i <= i0 + reach_x; ++i)
          if (const Point x = mesh.position(i, j) - at; x.norm() <= tip.window)
          {
            place.push_back(x / tip.window);
            psi.push_back(psi_at(phi, mesh, i, j, width));
          }
      const auto count = static_cast<Eigen::Index>(psi.size());
      tip.nodes = static_cast<int>(count);
      tip.radius = std::numeric_limits<double>::quiet_NaN();
      if (count < 12)
        return;
      Eigen::MatrixXd terms(count, 10);
      Eigen::VectorXd values(count);
      for (Eigen::Index k = 0; k < count; ++k)
      {
        const auto n = static_cast<std::size_t>(k);
        terms.row(k) = cubic_terms(place[n][0], place[n][1]);
        values[k] = psi[n];
      }
      const Eigen::VectorXd c = terms.colPivHouseholderQr().solve(values);
      tip.residual = (terms * c - values).norm() / std::sqrt(static_cast<double>(count));
      const double gx = c[1], gy = c[2], xx = 2. * c[3], xy = c[4], yy = 2. * c[5];
      const double size = std::hypot(gx, gy);
      const double curvature =
          -(xx * gy * gy - 2. * xy * gx * gy + yy * gx * gx) / (size * size * size) / tip.window;
      tip.radius = 1. / curvature;
    }
  } // namespace

  std::optional<Tip> find_tip(const Field<double> &phi, const Mesh &mesh, const Ray &ray,
                              double width)
  {
    if (!(ray.direction.norm() > 0.))
      throw std::invalid_argument("tip probe: its direction is zero");
    const Point unit = ray.direction.normalized();
    const double end = length_inside(mesh, ray.origin, unit);
    const auto psi = [&](double s)
    { return interpolated_psi(phi, mesh, ray.origin + s * unit, width); };
    const double stride = 0.5 * mesh.spacing.minCoeff();
    double outside = end, inside = end;
    while (inside > 0. && psi(inside) <= 0.)
    {
      outside = inside;
      inside = std::max(0., inside - stride);
    }
    if (inside == end || psi(inside) <= 0.)
      return std::nullopt;
    for (int step = 0; step < 60 && outside - inside > 1e-14 * end; ++step)
    {
      const double middle = 0.5 * (inside + outside);
      (psi(middle) > 0. ? inside : outside) = middle;
    }
    Tip tip;
    tip.position = 0.5 * (inside + outside);
    fit_radius(tip, phi, mesh, ray.origin + tip.position * unit, width);
    return tip;
  }

  void add_sample(TipTrack &track, double time, double position, double travel)
  {
    track.time.push_back(time);
    track.position.push_back(position);
    std::size_t first = 0; // the last sample that a full window still needs
    while (first + 1 < track.time.size() &&
           std::abs(position - track.position[first + 1]) >= travel)
      ++first;
    const auto drop = static_cast<std::ptrdiff_t>(first);
    track.time.erase(track.time.begin(), track.time.begin() + drop);
    track.position.erase(track.position.begin(), track.position.begin() + drop);
  }

  TipVelocity tip_velocity(const TipTrack &track, double travel)
  {
    TipVelocity slope;
    slope.value = std::numeric_limits<double>::quiet_NaN();
    std::size_t first = track.time.size();
    while (first > 0 && (first == track.time.size() ||
                         std::abs(track.position.back() - track.position[first]) < travel))
      --first;
    const std::size_t end = track.time.size();
    slope.samples = static_cast<int>(end - first);
    if (slope.samples < 3)
      return slope;
    slope.travel = track.position.back() - track.position[first];
    double t = 0., x = 0., tt = 0., tx = 0., rest = 0.;
    for (std::size_t k = first; k < end; ++k)
      t += track.time[k] / slope.samples, x += track.position[k] / slope.samples;
    for (std::size_t k = first; k < end; ++k)
    {
      tt += (track.time[k] - t) * (track.time[k] - t);
      tx += (track.time[k] - t) * (track.position[k] - x);
    }
    slope.value = tx / tt;
    for (std::size_t k = first; k < end; ++k)
      rest += std::pow(track.position[k] - x - slope.value * (track.time[k] - t), 2);
    slope.residual = std::sqrt(rest / slope.samples);
    return slope;
  }

  double default_travel(const Mesh &mesh)
  {
    return 10. * mesh.spacing.maxCoeff();
  }

  std::string resolution_warning(double radius, const Mesh &mesh, double width)
  {
    const double spacing = mesh.spacing.maxCoeff();
    std::ostringstream text;
    text.precision(3);
    if (radius < 2. * spacing)
      text << "under-resolved: the tip radius " << radius << " is only " << radius / spacing
           << " cells; refine to a spacing of " << radius / 2. << " or less";
    else if (radius < width)
      text << "under-resolved: the tip radius " << radius
           << " is below the interface width W0 = " << width
           << "; the thin-interface relations need a smaller W0";
    return text.str();
  }
} // namespace melt
