#include "scene/read_value.h"

namespace scene
{
  namespace
  {
    Section wall()
    {
      return Keys<Wall>("wall", "A rigid wall that starts at a side and moves inward.")
          .require("side", &Wall::side, any(), "The side of the domain it starts from.", "")
          .add("speed", &Wall::speed, not_negative(Dimension::speed), "Inward speed.",
               "a wall at rest")
          .add("travel", &Wall::travel, not_negative(Dimension::length),
               "Inward travel at which it stops.", "a wall at rest")
          .add("start_distance", &Wall::start_distance, not_negative(Dimension::length),
               "Gap between wall and phi = 0 at which it starts. Contact itself comes early by up "
               "to "
               "a cell: a gap of less than that is not resolved.",
               "absent: 8 phase_field.width, unless start_time is given; a tip never touches a "
               "wall at rest, since its heat fills the gap")
          .add("start_time", &Wall::start_time, not_negative(Dimension::time),
               "Time at which it starts, instead.", "absent: start_distance says when")
          .add("ramp", &Wall::ramp, not_negative(Dimension::time),
               "Time over which the speed rises smoothly.",
               "absent: 10 transits of an elastic wave through the solid before it, which keep "
               "waves small; none with a start_time or without a solid")
          .add("contact_ramp", &Wall::contact_ramp, not_negative(Dimension::time),
               "At first contact the wall stops and its speed rises once more, over this time; 0: "
               "it goes on, and the contact is a blow of rho c V that no ramp before it softens.",
               "absent: 10 transits as well; 0 with a start_time or without a solid")
          .add("grip", &Wall::grip, any(),
               "grip: what touches it sticks, also when pulled away; slip: it slides along and "
               "lets go.",
               "the paper's walls hold the arms")
          .exclusive({"start_distance", "start_time"})
          .repeated();
    }

    Section imposed()
    {
      return Keys<Imposed>("imposed", "A given motion instead of a solid, Sec. 2.3.2.")
          .require("velocity", &Imposed::velocity, any(Dimension::speed),
                   "Velocity in x and y, of x, y and t, over the whole domain.", "")
          .optional();
    }

    Section advection()
    {
      return Keys<Advection>("advection", "How phi, theta and the crystal angle are carried.")
          .add("scheme", &Advection::scheme, any(), "Advection scheme.",
               "CIP keeps a tanh profile at third order from one cell of neighbours")
          .add("step_fraction", &Advection::step_fraction, up_to(1.),
               "Cells that the motion may cross per step and axis; beyond 0.5 only cip_hermite is "
               "stable.",
               "the paper's; accuracy hardly depends on it")
          .add("interval", &Advection::interval, between(1, 1000),
               "Coupling steps from one advection to the next. In between the way of every node "
               "adds up, and phi, theta and the angle lag behind the material by it. They are "
               "carried sooner where one more step would take the way beyond 0.9 of what the "
               "scheme can bear (0.45 cells, 0.9 with cip_hermite), where a probe is sampled, and "
               "at the end.",
               "the fields are where the material is; where the coupling step is shorter than "
               "the motion asks for (growth, clock.step) fewer advections cost less and smear "
               "less")
          .add("analytic_gradients", &Advection::analytic_gradients, any(),
               "Start CIP's gradient fields from the exact profile.",
               "differences would spend the third order on the first step")
          .optional();
    }

    Section extension()
    {
      return Keys<Extension>("extension", "How the solid's velocity is carried into the melt.")
          .add("method", &Extension::method, any(), "Closest point, or a PDE in pseudo-time.",
               "second order beside the front, where the PDE is of first order; cheaper, and "
               "without a count of iterations to choose")
          .add("band", &Extension::band, at_least(3.),
               "Width of the band along the front in cells. Melt beyond it moves as the piece of "
               "front nearest to it. Cells cut by the front and their neighbours need a distance.",
               "wider than the diffuse interface")
          .add("interval", &Extension::interval, between(1, 1000),
               "Extensions (one a coupling step) from one measurement of the distance to the next; "
               "it is measured sooner where the front has moved on by a cell, and with every map. "
               "In between the melt takes the velocity of the solid where the front was.",
               "the distance is that of the present front")
          .add("map_interval", &Extension::map_interval, between(1, 1000),
               "Extensions from one search of the whole mesh to the next: which piece of the front "
               "is nearest beyond the band, and pieces that have appeared away from the front; in "
               "between the front is followed.",
               "beyond the band the nearest piece changes slowly, and the map numbers pieces that "
               "still move with the front")
          .optional();
    }
  } // namespace

  std::vector<Section> motion_sections()
  {
    return {wall(), imposed(), advection(), extension()};
  }
} // namespace scene
