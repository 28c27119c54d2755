#include "melt/thin_interface.h"

#include <sstream>

namespace melt
{
  Law make_law(const scene::PhaseField &phase, const scene::Growth &growth, const scene::Heat *heat)
  {
    Law law;
    law.width = phase.width;
    law.relaxation = growth.relaxation_time;
    law.anisotropy = growth.anisotropy;
    if (!heat)
      return law;
    law.diffusivity = heat->diffusivity;
    law.coupling = coupling_constant(growth.capillary_length, law.width);
    return law;
  }

  std::string width_warning(const double capillary_length, const double width)
  {
    constexpr double most = 8.;
    if (width <= most * capillary_length)
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "under-resolved: the interface width W0 is " << width / capillary_length
         << " capillary lengths d0; the thin-interface relations are shown to hold up to about "
         << most << ": use a smaller W0";
    return text.str();
  }

  std::string profile_warning(const double width, const double spacing, const bool grows)
  {
    if (width >= (grows ? 0.999 : 0.5) * spacing)
      return {};
    std::ostringstream text;
    text.precision(3);
    text << "under-resolved: the interface width W0 is " << width / spacing
         << " cells; phi is a step from node to node, its contour may be off by half a cell and a "
            "growing front is pinned: use a W0 of a cell or more";
    return text.str();
  }
} // namespace melt
