#include "solid/seeding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scene/expression.h"
#include "scene/geometry.h"
#include "scene/reader.h"

namespace solid
{
  namespace
  {
    using SourceLocation = scene::SourceLocation;

    [[noreturn]] void refuse(const SourceLocation &place, const std::string &cause)
    {
      throw scene::BadScene(place.file + ":" + std::to_string(place.line) + ": body " + cause);
    }

    // A share of the body: where its point is to stand and how large it is.
    struct Lattice
    {
      Point lower, spacing;
      std::array<int, 2> count;
      Point centre(const int i, const int j) const
      {
        return lower + Point((i + 0.5) * spacing[0], (j + 0.5) * spacing[1]);
      }
      double area() const { return spacing[0] * spacing[1]; }
    };

    Lattice lattice_of(const scene::Domain &domain, const std::array<int, 2> &per_cell)
    {
      const Point dx = domain.spacing();
      return {domain.lower,
              {dx[0] / per_cell[0], dx[1] / per_cell[1]},
              {domain.cells[0] * per_cell[0], domain.cells[1] * per_cell[1]}};
    }

    // What of a rectangle lies in the domain: its symmetry sides cut bodies.
    scene::Rectangle cut(const scene::Rectangle &whole, const scene::Domain &domain)
    {
      const Point lower = whole.corner.cwiseMax(domain.lower);
      const Point upper = (whole.corner + whole.size).cwiseMin(domain.upper());
      return {lower, (upper - lower).cwiseMax(0.)};
    }

    bool on_lattice(const scene::Body &body, const Lattice &lattice, const scene::Domain &domain)
    {
      const auto *whole = std::get_if<scene::Rectangle>(&body.shape);
      if (!whole)
        return false;
      const scene::Rectangle rectangle = cut(*whole, domain);
      for (int k = 0; k < 2; ++k)
        for (const double x : {rectangle.corner[k], rectangle.corner[k] + rectangle.size[k]})
        {
          const double s = (x - lattice.lower[k]) / lattice.spacing[k];
          if (std::abs(s - std::round(s)) > 1e-6)
            return false;
        }
      return true;
    }

    Lattice tiling(const scene::Rectangle &rectangle, const Lattice &wanted)
    {
      Lattice own{rectangle.corner, wanted.spacing, {1, 1}};
      for (int k = 0; k < 2; ++k)
      {
        own.count[k] =
            std::max(1, static_cast<int>(std::lround(rectangle.size[k] / wanted.spacing[k])));
        own.spacing[k] = rectangle.size[k] / own.count[k];
      }
      return own;
    }

    // What of a lattice cell lies inside the bodies.
    struct Share
    {
      Point centre;
      double fraction = 0.;
      void take(const Share &other)
      {
        const double sum = fraction + other.fraction;
        centre = (fraction * centre + other.fraction * other.centre) / sum;
        fraction = sum;
      }
    };

    Share inside(const std::vector<scene::Body> &bodies, const Lattice &lattice, const int i,
                 const int j)
    {
      constexpr int samples = 8;
      const Point centre = lattice.centre(i, j);
      const double distance = scene::signed_distance(bodies, centre);
      const double reach = 0.5 * lattice.spacing.norm() * (1. + 1e-9);
      if (distance > reach || distance < -reach)
        return {centre, distance > 0. ? 1. : 0.};
      // Of a part that the outline crosses, what lies inside: exact for sides along the lattice.
      const Point part = lattice.spacing / samples;
      const double width = std::sqrt(part.prod());
      Point sum = Point::Zero();
      double weight = 0.;
      for (int b = 0; b < samples; ++b)
        for (int a = 0; a < samples; ++a)
        {
          const Point x = centre + Point(lattice.spacing[0] * ((a + 0.5) / samples - 0.5),
                                         lattice.spacing[1] * ((b + 0.5) / samples - 0.5));
          const double w = std::clamp(0.5 + scene::signed_distance(bodies, x) / width, 0., 1.);
          sum += w * x, weight += w;
        }
      return {weight > 0. ? Point(sum / weight) : centre, weight / (samples * samples)};
    }

    // The lattice cells that the bodies reach.
    struct Patch
    {
      std::array<int, 2> first, count;
      std::vector<Share> shares;
      Share *at(const int i, const int j)
      {
        const bool has = i >= 0 && i < count[0] && j >= 0 && j < count[1];
        return has ? &shares[static_cast<std::size_t>(j) * count[0] + i] : nullptr;
      }
    };

    Patch patch_of(const std::vector<scene::Body> &bodies, const Lattice &lattice)
    {
      Patch patch;
      const scene::Box box = scene::bounding_box(bodies);
      for (int k = 0; k < 2; ++k)
      {
        const auto index = [&](const double x)
        { return static_cast<int>(std::floor((x - lattice.lower[k]) / lattice.spacing[k])); };
        patch.first[k] = std::max(0, index(box.lower[k]) - 1);
        patch.count[k] =
            std::min(lattice.count[k] - 1, index(box.upper[k]) + 1) - patch.first[k] + 1;
      }
      for (int j = 0; j < patch.count[1]; ++j)
        for (int i = 0; i < patch.count[0]; ++i)
          patch.shares.push_back(inside(bodies, lattice, patch.first[0] + i, patch.first[1] + j));
      return patch;
    }

    // A point of hardly any mass would be as large as others for the grid. What a sliver holds goes
    // to the neighbour next to it, with its centre of mass: neither mass nor moment is moved.
    void join_slivers(Patch &patch)
    {
      constexpr double least = 0.2;
      for (int j = 0; j < patch.count[1]; ++j)
        for (int i = 0; i < patch.count[0]; ++i)
        {
          Share &sliver = *patch.at(i, j);
          if (sliver.fraction <= 0. || sliver.fraction >= least)
            continue;
          Share *nearest = nullptr;
          double least_distance = std::numeric_limits<double>::infinity();
          for (int b = -1; b <= 1; ++b)
            for (int a = -1; a <= 1; ++a)
              if (Share *other = patch.at(i + a, j + b); other && other->fraction >= least)
                if (const double d = (other->centre - sliver.centre).norm(); d < least_distance)
                  nearest = other, least_distance = d;
          if (nearest)
            nearest->take(sliver), sliver.fraction = 0.; // else thin all over: it stays
        }
    }

    void fill(Points &points, const Fraction &fraction, const std::vector<scene::Body> &bodies,
              const Lattice &lattice, const double density)
    {
      Patch patch = patch_of(bodies, lattice);
      join_slivers(patch);
      for (const Share &share : patch.shares)
        if (share.fraction > 0.)
          add_point(points, fraction, share.centre, density * lattice.area() * share.fraction);
    }

    void tile(Points &points, const Fraction &fraction, const Lattice &lattice,
              const std::vector<scene::Body> &earlier, const double density)
    {
      for (int j = 0; j < lattice.count[1]; ++j)
        for (int i = 0; i < lattice.count[0]; ++i)
          if (const Point x = lattice.centre(i, j);
              earlier.empty() || scene::signed_distance(earlier, x) < 0.)
            add_point(points, fraction, x, density * lattice.area());
    }

    void check_inside(const scene::Domain &domain, const scene::Body &body)
    {
      const scene::Box box = scene::bounding_box({body});
      for (int k = 0; k < 2; ++k)
      {
        const int low =
            k == 0 ? static_cast<int>(scene::Edge::left) : static_cast<int>(scene::Edge::bottom);
        const bool low_open = domain.boundary[low] == scene::Boundary::symmetry;
        const bool high_open = domain.boundary[low + 1] == scene::Boundary::symmetry;
        const double small = 1e-9 * domain.size[k];
        if ((!low_open && box.lower[k] < domain.lower[k] - small) ||
            (!high_open && box.upper[k] > domain.upper()[k] + small))
          refuse(body.place, "\"" + body.name + "\" reaches out of the domain; enlarge the domain");
      }
    }

    // d f/dX_k by central difference.
    double slope(const scene::Function &f, const Point &X, const int k, const double h)
    {
      if (!f.depends_on_position())
        return 0.;
      const Point right = X + h * Point::Unit(k), left = X - h * Point::Unit(k);
      return (f({right, right, 0.}) - f({left, left, 0.})) / (2. * h);
    }
  } // namespace

  void initialise(Points &points, const Fraction &fraction, const std::size_t begin,
                  const std::vector<scene::Body> &bodies, const double h)
  {
    for (const scene::Body &body : bodies)
    {
      const scene::Function vx(body.velocity[0]), vy(body.velocity[1]);
      std::vector<scene::Function> stress;
      if (body.initial_stress)
        for (const scene::Expression &component : *body.initial_stress)
          stress.emplace_back(component);
      for (std::size_t p = begin; p < points.size(); ++p)
      {
        const Point X = fraction.initial(points, p);
        if (bodies.size() > 1 &&
            scene::signed_distance(body, X) < scene::signed_distance(bodies, X) - 1e-9 * h)
          continue;
        const scene::Argument at{X, X, 0.};
        points.vx[p] = vx(at), points.vy[p] = vy(at);
        points.lxx[p] = slope(vx, X, 0, h), points.lxy[p] = slope(vx, X, 1, h);
        points.lyx[p] = slope(vy, X, 0, h), points.lyy[p] = slope(vy, X, 1, h);
        if (!stress.empty())
          points.sxx[p] = stress[0](at), points.syy[p] = stress[1](at),
          points.szz[p] = stress[2](at), points.sxy[p] = stress[3](at);
      }
    }
  }

  Points make_points(const scene::Scene &scene, const Material &material,
                     const std::array<int, 2> &per_cell)
  {
    Points points;
    points.may_split = scene.mpm && scene.mpm->split_points;
    const Fraction fraction(scene.domain);
    const Lattice lattice = lattice_of(scene.domain, per_cell);
    bool aligned = true;
    for (const scene::Body &body : scene.bodies)
      check_inside(scene.domain, body),
          aligned = aligned && on_lattice(body, lattice, scene.domain);
    const bool single =
        scene.bodies.size() == 1 && std::holds_alternative<scene::Rectangle>(scene.bodies[0].shape);
    if (aligned || single)
    {
      std::vector<scene::Body> earlier;
      for (const scene::Body &body : scene.bodies)
      {
        const scene::Rectangle seen = cut(std::get<scene::Rectangle>(body.shape), scene.domain);
        if (seen.size.minCoeff() > 0.)
          tile(points, fraction, tiling(seen, lattice), earlier, material.density);
        earlier.push_back(body);
      }
    }
    else
    {
      // The distance to a seam between bodies would leave out material along it.
      const auto joined =
          scene::joined_where_they_touch(scene.bodies, 0.1 * lattice.spacing.minCoeff());
      fill(points, fraction, joined ? std::vector<scene::Body>{*joined} : scene.bodies, lattice,
           material.density);
    }
    if (points.size() == 0)
      refuse(scene.bodies.empty() ? SourceLocation{} : scene.bodies[0].place,
             "without a material point: it is smaller than a point's share of a cell; refine "
             "domain.cells");
    initialise(points, fraction, 0, scene.bodies, 1e-4 * scene.domain.spacing()[0]);
    points.active = points.size();
    return points;
  }
} // namespace solid
