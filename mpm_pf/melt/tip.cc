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

    /// Radius of x = a + b t + c t^2 + d t^3 + e t^4 at t = 0, and the fit's residual.
    void fit_radius(Tip &tip, const std::vector<Crossing> &front)
    {
      tip.crossings = static_cast<int>(front.size());
      tip.radius = std::numeric_limits<double>::quiet_NaN();
      if (tip.crossings < 5)
        return;
      Eigen::MatrixXd terms(tip.crossings, 5);
      Eigen::VectorXd along(tip.crossings);
      for (int k = 0; k < tip.crossings; ++k)
      {
        const Crossing &point = front[static_cast<std::size_t>(k)];
        const double t = point.aside / tip.window;
        terms.row(k) << 1., t, t * t, t * t * t, t * t * t * t;
        along[k] = point.along;
      }
      const Eigen::VectorXd c = terms.colPivHouseholderQr().solve(along);
      tip.residual = (terms * c - along).norm() / std::sqrt(static_cast<double>(tip.crossings));
      const double slope = c[1] / tip.window, bend = 2. * c[2] / (tip.window * tip.window);
      tip.radius = -std::pow(1. + slope * slope, 1.5) / bend;
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
    // Seven parallels at least for the five coefficients of the fit: fewer leave no residual.
    tip.window = std::max(3. * mesh.spacing.maxCoeff(), 0.75 * width);
    // One parallel a mesh line: what lies between them is interpolated, and its curvature with it.
    const int each_side = static_cast<int>(std::lround(tip.window / mesh.spacing.minCoeff()));
    const Point aside(-unit[1], unit[0]);
    std::vector<Crossing> front;
    for (int k = -each_side; k <= each_side; ++k)
    {
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
