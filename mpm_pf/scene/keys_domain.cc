#include "scene/inputs.h"
#include "scene/read_value.h"

namespace scene
{
  namespace
  {
    Section top()
    {
      return Keys<Header>("", "Keys before the first section.")
          .add("title", &Header::title, any(), "One line that says what this scene is.",
               "printed in the banner, the record and the report")
          .add("accuracy", &Header::accuracy, any(),
               "A preset of settings by wanted accuracy; explicit keys override it.",
               "absent: every setting has its own default")
          .add("include", &Header::include, any(),
               "Scene file, or list of them, relative to this file, on which this file is laid: "
               "sections merge key by key, [[...]] entries merge by name, new ones are appended.",
               "a quick or rotated variant then states only what differs")
          .optional();
    }

    Section units()
    {
      return Keys<UnitsInput>("units", "Unit system of all numbers; it changes what is printed.")
          .add("system", &UnitsInput::system, any(),
               "SI, or lengths in W0, times in tau0 and stresses in sigma_Y.",
               "mechanics is usually stated in SI, crystal growth in W0 and tau0")
          .optional();
    }

    Section domain()
    {
      return Keys<Domain>("domain", "The regular mesh on which everything happens.")
          .add("origin", &Domain::lower, any(Dimension::length), "Lower left corner.",
               "most scenes start at the origin")
          .require("size", &Domain::size, positive(Dimension::length), "Width and height.", "")
          .require("cells", &Domain::cells, between(1, 100000),
                   "Number of cells in x and y (cells, not nodes); fields and walls want three at "
                   "least, two moving walls five between them; square ones wherever a solid or a "
                   "growing crystal is on.",
                   "")
          .chosen_by("accuracy")
          .add("boundary", &Domain::boundary, any(),
               "Condition on all sides, or side by side: no_flux (no gradient across, material "
               "must not arrive), symmetry (the same, material slides), periodic (for fields; "
               "material must not arrive), fixed (fields keep the values with which they start; "
               "material must not arrive, nor may a wall stand there).",
               "a closed box conserves heat")
          .required();
    }

    Section clock()
    {
      return Keys<Clock>("clock", "How long, and in what coupling steps.")
          .require("end", &Clock::end, positive(Dimension::time),
                   "Time at which the run ends; earlier where all walls that move have travelled "
                   "their way.",
                   "")
          .add("step", &Clock::step, positive(Dimension::time),
               "Longest coupling step between solid, advection and growth, for mpm_pf with "
               "[phase_field] or [heat]; a module's own limit shortens it.",
               "absent: as long as the limits of all modules allow")
          .required();
    }
  } // namespace

  std::vector<Section> domain_sections()
  {
    return {top(), units(), domain(), clock()};
  }
} // namespace scene
