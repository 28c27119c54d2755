#include "scene/inputs.h"
#include "scene/read_value.h"

namespace scene
{
  namespace
  {
    Section body()
    {
      return Keys<BodyInput>("body",
                             "One body; the solid, the first phase field and the finite-element "
                             "mesh are the union of all. It may reach over a symmetry side.")
          .add("name", &BodyInput::name, any(), "Name of the body.", "absent: body 1, body 2, ...")
          .require("shape", &BodyInput::shape, any(),
                   "rectangle (corner, size), disc (centre, radius), ring (centre, inner_radius, "
                   "outer_radius), polygon (vertices, holes), outline (file), record (record, "
                   "probe, time, cut_above, cut_below).",
                   "")
          .add("corner", &BodyInput::corner, any(Dimension::length),
               "Lower left corner of a rectangle.", "needed by rectangles")
          .add("size", &BodyInput::size, positive(Dimension::length),
               "Width and height of a rectangle.", "needed by rectangles")
          .add("centre", &BodyInput::centre, any(Dimension::length), "Centre of a disc or ring.",
               "needed by discs and rings")
          .add("radius", &BodyInput::radius, positive(Dimension::length), "Radius of a disc.",
               "needed by discs")
          .add("inner_radius", &BodyInput::inner_radius, positive(Dimension::length),
               "Inner radius of a ring.", "needed by rings")
          .add("outer_radius", &BodyInput::outer_radius, positive(Dimension::length),
               "Outer radius of a ring.", "needed by rings")
          .add("vertices", &BodyInput::vertices, any(Dimension::length),
               "Outer boundary of a polygon, without repeating the first vertex.",
               "needed by polygons")
          .add("holes", &BodyInput::holes, any(Dimension::length),
               "Outlines of the holes of a polygon.", "absent: no holes")
          .add("file", &BodyInput::file, any(),
               "CSV of x,y lines relative to the scene file; blank lines separate outlines, of "
               "which one inside another is a hole.",
               "needed by outlines")
          .add("record", &BodyInput::record, any(),
               "Record of an earlier run, relative to the scene file, whose outline is the body.",
               "needed by records")
          .add("probe", &BodyInput::probe, any(), "Name of the outline probe in that record.",
               "needed by records")
          .add("time", &BodyInput::time, not_negative(Dimension::time),
               "Time of the outline in that record.", "absent: the last one recorded")
          .add("cut_above", &BodyInput::cut_above, any(Dimension::length),
               "Cut a recorded outline flat: keep only what is below this y.", "absent: no cut")
          .add("cut_below", &BodyInput::cut_below, any(Dimension::length),
               "Cut a recorded outline flat: keep only what is above this y.", "absent: no cut")
          .add("velocity", &BodyInput::velocity, any(Dimension::speed),
               "Initial velocity, of X and Y.", "most scenes start at rest")
          .add("initial_stress", &BodyInput::initial_stress, any(Dimension::stress),
               "Initial Cauchy stress xx, yy, zz, xy, of X and Y.", "absent: free of stress")
          .repeated();
    }

    Section solid()
    {
      return Keys<Solid>("solid",
                         "Elasto-viscoplastic material of all bodies, Eqs. (4)-(6), plane strain.")
          .require("young_modulus", &Solid::young_modulus, positive(Dimension::stress),
                   "Young's modulus E.", "")
          .require("poisson_ratio", &Solid::poisson_ratio, inside(-1., 0.5), "Poisson's ratio nu.",
                   "")
          .require("density", &Solid::density, positive(Dimension::density),
                   "Mass per volume, before any density scaling.", "")
          .add("yield_stress", &Solid::yield_stress, positive(Dimension::stress),
               "von Mises stress sigma_Y at which the solid yields, perfectly plastic.",
               "absent: elastic")
          .add("viscosity", &Solid::viscosity, positive(Dimension::viscosity),
               "Viscosity eta of Perzyna's overstress law, Eq. (6).", "absent: rate-independent")
          .optional();
    }

    template <class Input>
    Keys<Input> placed(const std::string &name, const std::string &sentence,
                       const std::string &region)
    {
      Keys<Input> keys(name, sentence);
      keys.add("name", &Input::name, any(), "Name, for probes and overrides.",
               "absent: the word after `on`; with segment or region " + name + " 1, " + name +
                   " 2, ... by its place among all [[" + name + "]]")
          .add("on", &Input::on, any(), "A side of the bodies' common bounding box.",
               "absent: segment or region says where")
          .add("segment", &Input::segment, any(Dimension::length),
               "The part of the outline on this segment. A support of mpm_pf takes only segments "
               "along "
               "x or y, a slanted one by a region; tractions take any.",
               "absent: on or region says where")
          .add("region", &Input::region, any(Dimension::length), region,
               "absent: on or segment says where")
          .exclusive({"on", "segment", "region"}, true);
      return keys;
    }

    Section support()
    {
      return placed<SupportInput>("support",
                                  "Material held or driven; its reaction is always recorded.",
                                  "All material that starts in this box (a grip).")
          .require(
              "displacement", &SupportInput::displacement, any(Dimension::length),
              "Displacement in x and y, of X, Y (where the material started) and t; \"free\" "
              "leaves a component free. An edge that is "
              "free across itself may turn and bend; mpm_pf refuses to bend one by its own "
              "displacement, by "
              "more than a quarter of a cell. Where two edges meet and move one "
              "component differently the stress has no bound: forces there follow the cells. What "
              "lies at a corner of two supports counts for one of them.",
              "")
          .repeated();
    }

    Section traction()
    {
      return placed<TractionInput>("traction", "A load on a part of the outline.",
                                   "The part of the outline that starts in this box.")
          .add("traction", &TractionInput::traction, any(Dimension::stress),
               "Force per deformed length and unit depth, in x and y.",
               "absent: pressure gives the load")
          .add("pressure", &TractionInput::pressure, any(Dimension::stress),
               "Force per deformed length and unit depth, pressing on the outline at a right angle "
               "wherever it moves.",
               "absent: traction gives the load")
          .exclusive({"traction", "pressure"}, true)
          .repeated();
    }

    Section body_force()
    {
      return Keys<BodyForce>("body_force", "A force on all material, as gravity.")
          .require("acceleration", &BodyForce::acceleration, any(Dimension::acceleration),
                   "Force per mass of the true density, in x and y: with mpm.mach the weight stays "
                   "what it is, and what falls freely falls more slowly.",
                   "")
          .optional();
    }
  } // namespace

  std::vector<Section> solid_sections()
  {
    return {body(), solid(), support(), traction(), body_force()};
  }
} // namespace scene
