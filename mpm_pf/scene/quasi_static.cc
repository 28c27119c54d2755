#include "scene/quasi_static.h"

#include <algorithm>
#include <cmath>

#include "scene/expression.h"
#include "scene/geometry.h"
#include "scene/speed.h"

namespace scene
{
  namespace
  {
    // Largest speed of supports and walls, and how far they go.
    struct Drive
    {
      double speed = 0., stroke = 0.;

      void add(const Expression &displacement, const Box &box, const double end)
      {
        constexpr int samples = 400;
        const Function u(displacement);
        for (const Point &X : {box.lower, box.upper})
        {
          const auto at = [&](const double t) { return Point(u({X, X, t}), 0.); };
          speed = std::max(speed, largest_speed(at, end));
          for (int k = 0; k <= samples; ++k)
            stroke = std::max(stroke, at(end * k / samples).norm());
        }
      }
    };

    Drive drive_of(const Scene &s, const Box &box)
    {
      Drive drive;
      for (const Wall &wall : s.walls)
      {
        drive.speed = std::max(drive.speed, wall.speed);
        drive.stroke = std::max(drive.stroke, wall.travel);
      }
      for (const Support &support : s.supports)
        for (const auto &component : support.displacement)
          if (component)
            drive.add(*component, box, s.clock.end);
      return drive;
    }

    double wave_speed(const Solid &solid)
    {
      const double nu = std::min(solid.poisson_ratio, 0.499);
      return std::sqrt(solid.young_modulus * (1. - nu) /
                       ((1. + nu) * (1. - 2. * nu) * solid.density));
    }
  } // namespace

  bool is_driven(const Support &support)
  {
    return std::any_of(support.displacement.begin(), support.displacement.end(),
                       [](const auto &component)
                       { return component && Function(*component).depends_on_time(); });
  }

  bool has_initial_velocity(const Body &body)
  {
    return std::any_of(body.velocity.begin(), body.velocity.end(),
                       [](const Expression &component)
                       {
                         const Function v(component);
                         return !v.is_constant() || v({}) != 0.;
                       });
  }

  std::optional<double> scaled_mach(const Scene &s, const double wanted, const double crossings)
  {
    if (!s.solid || !s.tractions.empty() || s.body_force)
      return {};
    const double c = wave_speed(*s.solid);
    const Box box =
        s.bodies.empty() ? Box{s.domain.lower, s.domain.upper()} : bounding_box(s.bodies);
    const double length = (box.upper - box.lower).maxCoeff();
    try
    {
      const bool driven =
          !s.walls.empty() || std::any_of(s.supports.begin(), s.supports.end(), is_driven);
      if (!driven || std::any_of(s.bodies.begin(), s.bodies.end(), has_initial_velocity))
        return {};
      const Drive drive = drive_of(s, box);
      const double mach = std::min(wanted, drive.stroke / (crossings * length));
      if (!(mach > 0.) || s.clock.end * c < crossings * length || drive.speed >= mach * c)
        return {};
      return mach;
    }
    catch (const BadExpression &)
    {
      return {}; // refused in earnest when the scene is read
    }
  }
} // namespace scene
