#include "quantities.h"

#include <map>
#include <stdexcept>

#include "scene/units.h"

namespace fe
{
  namespace
  {
    double determinant(const Matrix2 &F)
    {
      return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    }

    template <int component>
    double stress(const Material &, const Sample &s)
    {
      return s.point->stress[component];
    }

    double pressure(const Material &, const Sample &s)
    {
      const Vector4 &sigma = s.point->stress;
      return -(sigma[xx] + sigma[yy] + sigma[zz]) / 3.;
    }

    double yielded(const Material &material, const Sample &s)
    {
      return material.yield_stress && von_mises(s.point->stress) > 0.99 * *material.yield_stress
                 ? 1.
                 : 0.;
    }

    const std::map<std::string, Quantity> &table()
    {
      static const std::map<std::string, Quantity> quantities{
          {"von_mises",
           [](const Material &, const Sample &s) { return von_mises(s.point->stress); }},
          {"plastic_strain",
           [](const Material &, const Sample &s) { return s.point->plastic_strain; }},
          {"pressure", pressure},
          {"stress_xx", stress<xx>},
          {"stress_yy", stress<yy>},
          {"stress_zz", stress<zz>},
          {"stress_xy", stress<xy>},
          {"displacement_x", [](const Material &, const Sample &s) { return s.displacement[0]; }},
          {"displacement_y", [](const Material &, const Sample &s) { return s.displacement[1]; }},
          {"velocity_x", [](const Material &, const Sample &s) { return s.velocity[0]; }},
          {"velocity_y", [](const Material &, const Sample &s) { return s.velocity[1]; }},
          {"jacobian", [](const Material &, const Sample &s) { return determinant(s.point->F); }},
          {"yielded", yielded},
          {"log_strain_xx",
           [](const Material &, const Sample &s) { return logarithmic_strain(s.point->F)[xx]; }},
          {"log_strain_yy",
           [](const Material &, const Sample &s) { return logarithmic_strain(s.point->F)[yy]; }},
          {"area", [](const Material &, const Sample &s) { return s.area; }}};
      return quantities;
    }
  } // namespace

  Quantity quantity(const std::string &name)
  {
    const auto found = table().find(name);
    if (found == table().end())
      throw std::invalid_argument("the finite elements know no quantity '" + name + "'");
    return found->second;
  }

  bool is_binned(const std::string &name)
  {
    return name.rfind("displacement_", 0) != 0 && name.rfind("velocity_", 0) != 0;
  }

  record::Columns columns_of(const std::vector<std::string> &names, const scene::Units units)
  {
    record::Columns columns{names, {}};
    for (const std::string &name : names)
      columns.units.push_back(scene::column_unit(scene::dimension_of(name), units));
    return columns;
  }
} // namespace fe
