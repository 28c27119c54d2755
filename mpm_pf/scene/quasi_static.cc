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
    constexpr double crossings = 10.;

    bool moves(const Support &support)
    {
      return std::any_of(support.displacement.begin(), support.displacement.end(),
                         [](const auto &component)
                         { return component && component->text.find('t') != std::string::npos; });
    }

    double speed_of(const Expression &displacement, const Box &box, const double end)
    {
      const Function at(displacement);
      double largest = 0.;
      for (const Point &X : {box.lower, box.upper})
        largest = std::max(largest, largest_speed(
                                        [&](const double t) {
                                          return Point(at({X, X, t}), 0.);
                                        },
                                        end));
      return largest;
    }

    double largest_speed(const Scene &s, const Box &box)
    {
      double largest = 0.;
      for (const Wall &wall : s.walls)
        largest = std::max(largest, wall.speed);
      for (const Support &support : s.supports)
        for (const auto &component : support.displacement)
          if (component)
            largest = std::max(largest, speed_of(*component, box, s.clock.end));
      return largest;
    }

    double wave_speed(const Solid &solid)
    {
      const double nu = std::min(solid.poisson_ratio, 0.499);
      return std::sqrt(solid.young_modulus * (1. - nu) /
                       ((1. + nu) * (1. - 2. * nu) * solid.density));
    }
  } // namespace

  bool quasi_static(const Scene &s, const double mach)
  {
    const bool driven =
        !s.walls.empty() || std::any_of(s.supports.begin(), s.supports.end(), moves);
    const bool thrown =
        std::any_of(s.bodies.begin(), s.bodies.end(),
                    [](const Body &body)
                    { return body.velocity[0].text != "0" || body.velocity[1].text != "0"; });
    if (!driven || thrown || !s.solid || !s.tractions.empty() || s.body_force)
      return false;
    const double c = wave_speed(*s.solid);
    const Box box =
        s.bodies.empty() ? Box{s.domain.lower, s.domain.upper()} : bounding_box(s.bodies);
    const double length = (box.upper - box.lower).maxCoeff();
    try
    {
      return s.clock.end * c >= crossings * length && largest_speed(s, box) < mach * c;
    }
    catch (const BadExpression &)
    {
      return false; // refused in earnest when the scene is read
    }
  }
} // namespace scene
