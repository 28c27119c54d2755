#include "scene/inputs.h"
#include "scene/read_value.h"

namespace scene
{
  std::vector<Section> probe_sections()
  {
    using P = ProbeInput;
    return {
        Keys<P>("probe", "Something to observe; both solvers answer the same probes.")
            .require("name", &P::name, any(), "Name of the table in the record.", "")
            .add("line", &P::line, any(Dimension::length),
                 "Kind: values along a segment between two points.", "absent: another kind")
            .add("at", &P::at, any(Dimension::length), "Kind: values at one point over time.",
                 "absent: another kind")
            .add("region", &P::region, any(Dimension::length),
                 "Kind: volume mean over all material, or over that which started in a box.",
                 "absent: another kind")
            .add("reaction", &P::reaction, any(),
                 "Kind: force on and displacement of the support of this name, a wall being \"wall "
                 "top\" "
                 "and so on. mpm_pf gives the mean force over half an interval before and after; "
                 "the first and the last row are extrapolated from their half means.",
                 "absent: another kind")
            .add("outline", &P::outline, any(),
                 "Kind: closed polylines, of the material or of phi = 0.", "absent: another kind")
            .add("snapshot", &P::snapshot, any(), "Kind: whole fields.", "absent: another kind")
            .add("tip", &P::tip, any(Dimension::length),
                 "Kind: dendrite tip along a ray: position, velocity, radius.",
                 "absent: another kind")
            .add("history", &P::history, any(),
                 "Kind: scalar diagnostics of the whole run (energy, momentum, area, heat).",
                 "absent: another kind")
            .add("points", &P::points, between(2, 1000000), "Number of points of a line.",
                 "needed by lines")
            .add("bin", &P::bin, positive(Dimension::length),
                 "Side of the square round a point, or a point of a line, over which stresses, "
                 "strains and the like are averaged there; displacements and velocities are not. "
                 "fe_reference gives its nearest integration point's where the square holds none.",
                 "absent: a twentieth of the shorter side of the bodies' bounding box, the same at "
                 "every resolution, yet a cell of the domain at least; four cells where a solid "
                 "grows")
            .add("frame", &P::frame, any(),
                 "Are the positions of a line or point current (x, y), or material (X, Y)? Fields "
                 "of the melt are always taken at current positions.",
                 "absent: current for lines, material for points of a solid")
            .add("of", &P::of, any(),
                 "Quantities to record; a snapshot of mpm_pf always has the melt's fields.",
                 "absent: all that the modules of the scene know")
            .add("times", &P::times, not_negative(Dimension::time), "Times to record, increasing.",
                 "absent, and every too: the end for lines, outlines and snapshots, 200 samples "
                 "for others")
            .add("every", &P::every, positive(Dimension::time), "Interval between records.",
                 "absent: see times")
            .exclusive(
                {"line", "at", "region", "reaction", "outline", "snapshot", "tip", "history"}, true)
            .add("compressions", &P::compressions, between(0., 1.),
                 "Relative compressions by walls at which to record, increasing; 0 is first "
                 "contact.",
                 "absent: see times")
            .exclusive({"times", "every", "compressions"})
            .repeated()};
  }
} // namespace scene
