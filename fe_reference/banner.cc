#include "banner.h"

#include <sstream>

#include "scene/expression.h"
#include "scene/presets.h"
#include "scene/quantities.h"
#include "scene/reader.h"

namespace fe
{
  namespace
  {
    std::string at(const scene::SourceLocation &place)
    {
      return place.file + ":" + std::to_string(place.line);
    }

    template <class Section>
    void refuse(const std::optional<Section> &section, const char *name, std::string &errors)
    {
      if (section)
        errors += at(section->place) + ": [" + name +
                  "]: fe_reference solves the solid alone and cannot include it; remove the "
                  "section or run this scene with mpm_pf\n";
    }

    template <class Section>
    void skip(const std::optional<Section> &section, const char *name, std::string &lines)
    {
      if (section)
        lines += std::string("  skipped  [") + name + "] (" + at(section->place) +
                 "): does not concern the solid's equilibrium\n";
    }

    /// What of a probe is of the melt; "" if nothing.
    std::string of_the_melt(const scene::Probe &probe)
    {
      if (std::holds_alternative<scene::TipProbe>(probe.kind))
        return "the tip";
      if (const auto *outline = std::get_if<scene::OutlineProbe>(&probe.kind))
        return outline->of == scene::OutlineProbe::Of::phase ? "the contour of phi" : "";
      std::string names;
      for (const std::string &name : probe.of)
        if (scene::is_melt_quantity(name))
          names += (names.empty() ? "" : ", ") + name;
      return names;
    }

    bool moves(const scene::Body &body)
    {
      for (const scene::Expression &component : body.velocity)
      {
        const scene::Function velocity(component);
        if (!velocity.is_constant() || velocity(scene::Argument{}) != 0.)
          return true;
      }
      return false;
    }
  } // namespace

  void refuse_active_sections(const scene::Scene &scene)
  {
    std::string errors;
    refuse(scene.growth, "growth", errors);
    refuse(scene.heat, "heat", errors);
    refuse(scene.noise, "noise", errors);
    refuse(scene.imposed, "imposed", errors);
    for (const scene::Wall &wall : scene.walls)
      errors += at(wall.place) +
                ": [[wall]]: fe_reference knows no contact; describe the motion of the end by a "
                "[[support]] or run this scene with mpm_pf\n";
    if (!scene.solid)
      errors += scene.file + ": there is no [solid]; fe_reference has nothing to solve\n";
    if (scene.bodies.empty())
      errors += scene.file + ": there is no [[body]]; fe_reference has nothing to mesh\n";
    if (!errors.empty())
      throw scene::BadScene(errors.substr(0, errors.size() - 1));
  }

  std::string banner(const scene::Scene &scene)
  {
    std::string skipped;
    skip(scene.mpm, "mpm", skipped);
    skip(scene.phase_field, "phase_field", skipped);
    skip(scene.advection, "advection", skipped);
    skip(scene.extension, "extension", skipped);
    skip(scene.orientation, "orientation", skipped);
    for (const scene::Probe &probe : scene.probes)
      if (const std::string what = of_the_melt(probe); !what.empty())
        skipped += "  skipped  " + what + " of [[probe]] \"" + probe.name + "\" (" +
                   at(probe.place) + "): only mpm_pf follows phi; this record has none of it\n";
    for (const scene::Body &body : scene.bodies)
      if (moves(body))
        skipped += "  skipped  initial velocity (" + at(body.place) +
                   "): the finite elements are quasi-static\n";

    std::ostringstream text;
    text << "fe_reference: " << scene.title << "\n  on       [solid] (" << at(scene.solid->place)
         << "): "
         << (scene.solid->yield_stress
                 ? (scene.solid->viscosity ? "elastic, Perzyna viscoplastic"
                                           : "elastic, perfectly plastic, rate-independent")
                 : "elastic")
         << "\n  on       " << scene.bodies.size() << " [[body]], " << scene.supports.size()
         << " [[support]], " << scene.tractions.size() << " [[traction]], "
         << (scene.body_force ? "[body_force], " : "") << scene.probes.size() << " [[probe]]\n";
    if (!scene.fe)
      text << "  on       [fe] with its defaults\n";
    text << skipped << scene::describe_preset(scene);
    return text.str();
  }
} // namespace fe
