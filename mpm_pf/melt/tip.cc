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
      const int i = static_cast<int>(std::floor(cell[0]));
      const int j = static_cast<int>(std::floor(cell[1]));
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

    /// Where psi changes from positive at `inside` to negative at `outside` along the ray.
    template <class Psi>
    double bisect(const Psi &psi, double inside, double outside)
    {
      for (int step = 0; step < 48; ++step)
      {
        const double middle = 0.5 * (inside + outside);
        (psi(middle) > 0. ? inside : outside) = middle;
      }
      return 0.5 * (inside + outside);
    }

    /// Outermost crossing at or inside of `start` along the ray, not deeper than `end`.
    template <class Psi>
    std::optional<double> crossing_inwards(const Psi &psi, double start, double end, double stride)
    {
      double outside = start, inside = start;
      while (inside > end && psi(inside) <= 0.)
      {
        outside = inside;
        inside = std::max(end, inside - stride);
      }
      if (inside == start || psi(inside) <= 0.)
        return std::nullopt;
      return bisect(psi, inside, outside);
    }

    struct Crossing
    {
      double aside, along; // of the tip, length
    };

    /// Radius at the tip of the curve t^2 + a t + b t s = 2 rho s + q s^2 + r s^3 through it, s the
    /// depth behind the tip and t the distance from the ray, and the fit's residual. Both are taken
    /// in windows: in metres a crystal of some nanometres would have columns of 1e-9 and of 1e-27,
    /// and the solver would take the latter for dependent.
    void fit_radius(Tip &tip, const std::vector<Crossing> &front)
    {
      constexpr int coefficients = 5;
      tip.crossings = static_cast<int>(front.size());
      tip.radius = std::numeric_limits<double>::quiet_NaN();
      if (tip.crossings < coefficients + 2)
        return;
      Eigen::MatrixXd terms(tip.crossings, coefficients);
      Eigen::VectorXd square(tip.crossings), weight(tip.crossings);
      for (int k = 0; k < tip.crossings; ++k)
      {
        const double t = front[static_cast<std::size_t>(k)].aside / tip.window,
                     s = -front[static_cast<std::size_t>(k)].along / tip.window;
        terms.row(k) << s, s * s, s * s * s, -t, -t * s;
        square[k] = t * t;
        weight[k] = 1. / (t * t);
      }
      const Eigen::VectorXd c =
          (weight.asDiagonal() * terms).colPivHouseholderQr().solve(weight.cwiseProduct(square));
      // F(s, t) = t^2 + a t + b t s - 2 rho s - q s^2 - ... = 0 and its derivatives at the tip
      const double by_s = -c[0], by_t = c[3], size = std::hypot(by_s, by_t);
      const double bend = 2. * by_s * by_s - 2. * c[4] * by_s * by_t - 2. * c[1] * by_t * by_t;
      tip.residual = tip.window * (terms * c - square).norm() / std::abs(by_s) /
                     std::sqrt(static_cast<double>(tip.crossings));
      tip.radius = std::copysign(tip.window * size * size * size / bend, c[0]);
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
    const auto position = crossing_inwards(psi, end, 0., stride);
    if (!position)
      return std::nullopt;
    Tip tip;
    tip.position = *position;
    // Four mesh lines on each side at least: fewer leave no residual. What lies between mesh lines
    // is interpolated, and its curvature with it, so it is not asked.
    tip.window = std::max(4. * mesh.spacing.maxCoeff(), 0.75 * width);
    const int each_side = static_cast<int>(std::lround(tip.window / mesh.spacing.minCoeff()));
    const Point aside(-unit[1], unit[0]);
    std::vector<Crossing> front;
    for (int k = -each_side; k <= each_side; ++k)
    {
      if (k == 0)
        continue;
      const double t = k * tip.window / each_side;
      const auto beside = [&](double s)
      { return interpolated_psi(phi, mesh, ray.origin + s * unit + t * aside, width); };
      if (const auto s = crossing_inwards(beside, tip.position + tip.window,
                                          tip.position - 4. * tip.window, stride))
        front.push_back({t, *s - tip.position});
    }
    fit_radius(tip, front);
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
