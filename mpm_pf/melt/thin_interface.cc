#include "melt/thin_interface.h"

#include <cmath>
#include <sstream>

#include "scene/reader.h"

namespace melt
{
  namespace
  {
    [[noreturn]] void refuse(const scene::Place &place, const std::string &reason)
    {
      std::ostringstream text;
      text << place.file << ":" << place.line << ": [growth]: " << reason;
      throw scene::BadScene(text.str());
    }
  } // namespace

  double coupling_constant(double capillary_length, double width)
  {
    return a1 * width / capillary_length;
  }

  double kinetic_coefficient(const Law &law)
  {
    return a1 * (law.relaxation / (law.coupling * law.width) - a2 * law.width / law.diffusivity);
  }

  Law make_law(const scene::PhaseField &phase, const scene::Growth &growth, const scene::Heat *heat)
  {
    Law law;
    law.width = phase.width;
    law.relaxation = growth.relaxation_time;
    law.anisotropy = growth.anisotropy;
    if (!(law.anisotropy >= 0. && law.anisotropy < 1. / 15.))
    {
      std::ostringstream text;
      text << "anisotropy = " << law.anisotropy
           << ": allowed is 0 <= anisotropy < 1/15, because the interface stiffness 1 - 15 eps "
              "must stay positive: beyond it orientations are missing and Eq. (1) is ill-posed";
      refuse(growth.place, text.str());
    }
    if (!heat)
      return law;
    law.diffusivity = heat->diffusivity;
    law.coupling = coupling_constant(growth.capillary_length, law.width);
    const double wanted = growth.kinetic_coefficient.value_or(0.);
    const double scale = a1 * a2 * law.width / law.diffusivity;
    if (std::abs(kinetic_coefficient(law) - wanted) > 0.02 * scale)
    {
      std::ostringstream text;
      const double relaxation =
          law.coupling * law.width * (wanted / a1 + a2 * law.width / law.diffusivity);
      text << "relaxation_time = " << law.relaxation << " gives a kinetic coefficient of "
           << kinetic_coefficient(law) << ", but " << wanted << " is asked"
           << (growth.kinetic_coefficient ? "" : " (kinetics-free growth, the default)")
           << "; with capillary_length = " << growth.capillary_length << ", width = " << law.width
           << " and diffusivity = " << law.diffusivity << " set relaxation_time = " << relaxation
           << ", or state kinetic_coefficient = " << kinetic_coefficient(law);
      refuse(growth.place, text.str());
    }
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
