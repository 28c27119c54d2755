#include "scene/units.h"

#include <array>

namespace scene
{
  std::string unit_text(const Dimension dimension, const Units units)
  {
    // Indexed by Dimension: SI, then lengths in W0, times in tau0, stresses in sigma_Y.
    static const std::array<std::array<const char *, 2>, 16> texts{
        {{"", ""},
         {"m", "W0"},
         {"m^2", "W0^2"},
         {"s", "tau0"},
         {"m/s", "W0/tau0"},
         {"s/m", "tau0/W0"},
         {"m/s^2", "W0/tau0^2"},
         {"Pa", "sigma_Y"},
         {"kg/m^3", "sigma_Y tau0^2/W0^2"},
         {"Pa s", "sigma_Y tau0"},
         {"m^2/s", "W0^2/tau0"},
         {"degrees", "degrees"},
         {"N/m", "sigma_Y W0"},
         {"J/m", "sigma_Y W0^2"},
         {"kg/s", "sigma_Y tau0 W0"},
         {"kg/m", "sigma_Y tau0^2"}}};
    return texts.at(static_cast<std::size_t>(dimension)).at(units == Units::si ? 0 : 1);
  }

  std::string column_unit(const Dimension dimension, const Units units)
  {
    const std::string unit = unit_text(dimension, units);
    return unit.empty() ? "1" : unit;
  }

  Dimension dimension_of(const std::string_view quantity)
  {
    const auto starts = [&](const std::string_view text) { return quantity.rfind(text, 0) == 0; };
    if (quantity == "von_mises" || quantity == "pressure" || starts("stress_"))
      return Dimension::stress;
    if (starts("displacement_"))
      return Dimension::length;
    if (starts("velocity_"))
      return Dimension::speed;
    return quantity == "area" ? Dimension::area : Dimension::none;
  }
} // namespace scene
