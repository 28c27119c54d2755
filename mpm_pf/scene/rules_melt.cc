#include <algorithm>
#include <cmath>

#include "scene/choices.h"
#include "scene/expression.h"
#include "scene/geometry.h"
#include "scene/rules_list.h"
#include "scene/thin_interface.h"

namespace scene
{
  namespace
  {
    constexpr double tolerance = 0.01; // of the kinetic coefficient, in its first term

    bool sound(const Inspection &in, const char *section)
    {
      return in.present(section) && !in.errors.about(in.at(section));
    }

    int axis_of(const Edge side)
    {
      return side == Edge::left || side == Edge::right ? 0 : 1;
    }
  } // namespace

  void walls_have_room(const Inspection &in)
  {
    std::array<double, 2> travel{0., 0.};
    for (std::size_t i = 0; i < in.scene().walls.size(); ++i)
    {
      const Wall &wall = in.scene().walls[i];
      const Value &at = *in.draft.walls[i];
      if (in.errors.about(at))
        continue;
      if ((wall.speed > 0.) != (wall.travel > 0.))
        in.add_error(at,
                     wall.speed > 0. ? "the wall has a speed but no travel: it would stop before "
                                       "it starts"
                                     : "the wall has a travel but no speed",
                     "speed and travel together", "give both, or neither for a wall at rest");
      const auto axis = static_cast<std::size_t>(axis_of(wall.side));
      double &sum = travel[axis];
      sum += wall.travel;
      if (!sound(in, "domain"))
        continue;
      const Domain &domain = in.scene().domain;
      const double room =
          (domain.cells[axis] - cells_between_walls) * domain.spacing()[axis_of(wall.side)];
      const bool across = sum >= domain.size[axis_of(wall.side)];
      if (across || sum > room)
        in.add_error(at,
                     "the walls travel " + number_text(sum) +
                         (across ? ", across the whole domain"
                                 : ", which leaves fewer than five cells between them"),
                     "at most " + number_text(std::max(0., room)) + " in all",
                     "shorten travel, or refine [domain] cells");
    }
  }

  void walls_stand_on_own_sides(const Inspection &in)
  {
    const auto &walls = in.scene().walls;
    for (std::size_t i = 0; i < walls.size(); ++i)
    {
      const Value &at = *in.draft.walls[i];
      if (!at.find("side") || in.errors.about(at))
        continue;
      if (in.scene().domain.boundary[static_cast<std::size_t>(walls[i].side)] == Boundary::periodic)
        in.add_error(at, "a wall on the periodic side \"" + word(walls[i].side) + "\"",
                     "walls on sides that bound the domain", "make the sides no_flux");
      if (in.scene().domain.boundary[static_cast<std::size_t>(walls[i].side)] == Boundary::fixed)
        in.add_error(at,
                     "a wall on the fixed side \"" + word(walls[i].side) +
                         "\": fields end at the wall, without flux",
                     "walls on no_flux or symmetry sides", "make the side no_flux");
      for (std::size_t j = 0; j < i; ++j)
        if (walls[j].side == walls[i].side)
          in.add_error(at, "a second wall on the side \"" + word(walls[i].side) + "\"",
                       "one wall a side", "remove one");
    }
  }

  void walls_know_when_to_start(const Inspection &in)
  {
    for (std::size_t i = 0; i < in.scene().walls.size(); ++i)
      if (!in.scene().walls[i].start_time && !in.present("phase_field"))
        in.add_error(*in.draft.walls[i],
                     "the wall starts at a distance to phi = 0, but there is no phase field",
                     "start_time, or [phase_field]", "add start_time = 0");
    for (std::size_t i = 0; i < in.scene().walls.size(); ++i)
    {
      const Wall &wall = in.scene().walls[i];
      if (const Value *at = in.draft.walls[i]->find("start_time");
          at && sound(in, "clock") && wall.speed > 0. && *wall.start_time >= in.scene().clock.end)
        in.add_error(
            *at, "the wall starts at " + number_text(*wall.start_time) + ", when the run has ended",
            "before the end, " + number_text(in.scene().clock.end),
            "start it earlier, or run longer");
    }
  }

  void interface_is_resolved(const Inspection &in)
  {
    // At half a cell from the contour 1 - phi is 2e-3 for a tenth: below it no node knows of it.
    constexpr double least = 0.1;
    if (!sound(in, "domain") || !sound(in, "phase_field"))
      return;
    const double spacing = in.scene().domain.spacing().maxCoeff();
    const double width = in.scene().phase_field->width;
    if (width >= least * spacing)
      return;
    in.add_error(in.at("phase_field", "width"),
                 "read " + number_text(width) + ", which is " + number_text(width / spacing) +
                     " cells of " + number_text(spacing) +
                     ": phi is 1 or -1 at every node, and nothing tells where between two of them "
                     "its contour is",
                 "a tenth of a cell at least; half a cell follows a marker, a whole one a growing "
                 "front",
                 "width = " + number_text(spacing) + ", or more [domain] cells");
  }

  void anisotropy_is_well_posed(const Inspection &in)
  {
    if (in.written("growth", "anisotropy") && in.scene().growth &&
        in.scene().growth->anisotropy >= ill_posed_anisotropy)
      in.add_error(in.at("growth", "anisotropy"),
                   "read " + number_text(in.scene().growth->anisotropy) +
                       ": from 1/15 on the interface stiffness 1 - 15 eps cos(4 angle) is not "
                       "positive, orientations go missing and Eq. (1) is ill-posed",
                   "less than 1/15 = 0.0667", "lower the anisotropy");
  }

  void kinetics_are_consistent(const Inspection &in)
  {
    if (!sound(in, "growth") || !sound(in, "heat") || !sound(in, "phase_field"))
      return;
    const Growth &growth = *in.scene().growth;
    const double W0 = in.scene().phase_field->width, D = in.scene().heat->diffusivity;
    const double d0 = growth.capillary_length, tau0 = growth.relaxation_time;
    const double lambda = coupling_constant(d0, W0);
    const double beta = kinetic_coefficient({lambda, W0, tau0, D});
    const double wanted = growth.kinetic_coefficient.value_or(0.);
    if (std::abs(beta - wanted) <= tolerance * a1 * tau0 / (lambda * W0))
      return;
    const double right_tau0 = lambda * W0 * (wanted / a1 + a2 * W0 / D);
    const double right_D = a2 * W0 / (tau0 / (lambda * W0) - wanted / a1);
    const double right_lambda = tau0 / (W0 * (wanted / a1 + a2 * W0 / D));
    in.add_error(in.at("growth", "relaxation_time"),
                 "tau0 = " + number_text(tau0) + ", d0 = " + number_text(d0) +
                     ", W0 = " + number_text(W0) + ", D = " + number_text(D) +
                     " give the kinetic coefficient " + number_text(beta) + ", but " +
                     (growth.kinetic_coefficient ? number_text(wanted) + " is asked"
                                                 : "growth is kinetics-free unless one is given"),
                 "tau0 = 0.6267 lambda W0^2/D with lambda = 0.8839 W0/d0, to 1 %",
                 "relaxation_time = " + number_text(right_tau0) +
                     (right_D > 0. ? ", or diffusivity = " + number_text(right_D) : "") +
                     ", or capillary_length = " + number_text(a1 * W0 / right_lambda) +
                     (beta > 0. ? ", or kinetic_coefficient = " + number_text(beta) : ""));
  }

  void strong_undercooling_has_kinetics(const Inspection &in)
  {
    if (!sound(in, "growth") || !sound(in, "heat") || in.scene().heat->undercooling < 1. ||
        in.scene().growth->kinetic_coefficient.value_or(0.) > 0.)
      return;
    in.add_error(in.at("heat", "undercooling"),
                 "read " + number_text(in.scene().heat->undercooling) +
                     ": the heat sink takes all latent heat, and without kinetics nothing limits "
                     "the speed of the front",
                 "less than 1, or a kinetic_coefficient greater than 0 in [growth]",
                 "lower it, or give kinetics (a planar front then moves at (Delta - 1)/beta)");
  }

  void first_temperature_is_fixed(const Inspection &in)
  {
    if (!in.written("heat", "initial") || !sound(in, "heat"))
      return;
    if (Function(*in.scene().heat->initial).depends_on_time())
      in.add_error(in.at("heat", "initial"), "an initial value that depends on t",
                   "an expression of X and Y", "remove t");
  }

  void noise_respects_symmetry(const Inspection &in)
  {
    if (!in.scene().noise || !sound(in, "domain"))
      return;
    const Domain &domain = in.scene().domain;
    const bool mirrored = in.scene().noise->mirrored;
    const auto has = [&](const Boundary boundary)
    {
      return std::find(domain.boundary.begin(), domain.boundary.end(), boundary) !=
             domain.boundary.end();
    };
    if (has(Boundary::symmetry) && !mirrored)
      in.add_error(in.at("noise", "mirrored"),
                   "noise on a domain with symmetry sides: the missing part would have to be noisy "
                   "in just the mirrored way",
                   "mirrored = true, or the whole domain",
                   "add mirrored = true to [noise] and say so with the results");
    if (mirrored && !has(Boundary::symmetry) && !has(Boundary::periodic) &&
        (domain.cells[0] % 2 != 0 || domain.cells[1] % 2 != 0))
      in.add_error(in.at("noise", "mirrored"),
                   "noise mirrored about the middle of an odd number of cells",
                   "even numbers of cells", "change [domain] cells");
  }

  void crystal_fits_symmetry(const Inspection &in)
  {
    if (!in.scene().orientation || !in.scene().growth || !sound(in, "orientation") ||
        !in.geometry_known)
      return;
    const Domain &domain = in.scene().domain;
    const double eighths = in.scene().orientation->angle_degrees / 45.;
    const Box box = bounding_box(in.scene().bodies);
    const double slack = 1e-6 * domain.spacing().minCoeff();
    const auto sides = {Edge::left, Edge::right, Edge::bottom, Edge::top};
    const bool whole = std::none_of(sides.begin(), sides.end(),
                                    [&](const Edge side)
                                    { return reaches_over_symmetry(domain, side, box, -slack); });
    if (whole || std::abs(eighths - std::nearbyint(eighths)) < 1e-9)
      return;
    in.add_error(in.at("orientation", "angle_degrees"),
                 "a crystal at " + number_text(in.scene().orientation->angle_degrees) +
                     " degrees, cut by a symmetry side: its mirror image is tilted the other way",
                 "a multiple of 45 degrees, or the whole crystal", "grow the whole crystal");
  }

  void distance_is_measured_between_maps(const Inspection &in)
  {
    if (!in.written("extension", "interval") || !sound(in, "extension"))
      return;
    const Extension &extension = *in.scene().extension;
    if (extension.interval > extension.map_interval)
      in.add_error(in.at("extension", "interval"),
                   "read " + std::to_string(extension.interval) +
                       ", but the distance is measured with every map, every " +
                       std::to_string(extension.map_interval) + " extensions",
                   "at most map_interval", "lower interval, or raise map_interval");
  }

  void heat_is_carried(const Inspection &in)
  {
    if (in.scene().solid && in.scene().heat && !in.present("phase_field"))
      in.add_error(in.at("heat"),
                   "heat beside a solid: theta is carried with the velocity that is extended from "
                   "the solid across phi = 0, and there is no [phase_field]",
                   "[phase_field] beside [solid] and [heat]", "add [phase_field]");
  }

  void loads_do_not_grow(const Inspection &in)
  {
    if (!in.present("growth"))
      return;
    for (const auto *list : {&in.draft.supports, &in.draft.tractions})
      for (const Value *at : *list)
        in.add_error(*at,
                     "a support or traction beside [growth]: a crystal has no material points and "
                     "no outline of its own before something moves it",
                     "[[wall]], or a scene without [growth]",
                     "press it by walls, or start a body from the record's contour (record = ...)");
  }
} // namespace scene
