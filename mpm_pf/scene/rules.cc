#include "scene/rules.h"

#include "scene/rules_list.h"

namespace scene
{
  namespace
  {
    std::vector<Rule> of_the_domain()
    {
      return {
          // Modules
          {"A scene has a solid, a phase field or heat.", something_happens},
          {"A section that no module reads is refused: see the needs of each.", sections_are_used},
          {"A motion is imposed instead of a solid, never beside one.", imposed_or_solid},
          // Domain
          {"Periodic sides come in opposite pairs.", periodic_sides_are_paired},
          {"Cells are square where a solid moves or a crystal grows.", cells_are_square},
          {"Fields and walls have a mesh of three cells each way at least.", mesh_holds_stencils},
          {"A body lies inside the domain; it may reach over symmetry sides only.",
           bodies_lie_in_the_domain},
          {"A coupling step needs a phase field or heat.", coupling_step_is_used},
          // Names
          {"Names are unique among bodies, supports, tractions and probes, and hold no slash.",
           names_are_unique}};
    }

    std::vector<Rule> of_the_solid()
    {
      return {
          // Solid
          {"A viscosity needs a yield stress.", viscosity_needs_yield_stress},
          {"Initial velocity and stress need a solid and do not depend on t.",
           initial_state_is_of_a_solid},
          {"Bodies that overlap start with the same velocity and stress.",
           overlapping_bodies_start_alike},
          {"Initial stresses are within yield unless viscous.", initial_stress_is_within_yield},
          {"A support or traction is where material is.", loads_meet_material},
          {"A support holds at least one component, and starts from zero displacement.",
           supports_hold_something},
          {"The displacement of a support is told of X, Y and t.",
           displacements_are_of_places_at_the_start},
          {"Two supports do not hold one component of one place.", supports_do_not_compete},
          {"A traction acts on the outline: an edge, a segment, or what of it starts in a region.",
           tractions_act_on_outlines},
          // Walls
          {"A wall moves if it has both a speed and a travel, and leaves five cells before the "
           "next.",
           walls_have_room},
          {"Each side has one wall at most, and none if it is periodic or fixed.",
           walls_stand_on_own_sides},
          {"A wall that starts by distance needs a phase field.", walls_know_when_to_start},
          // Solvers
          {"flip_fraction belongs to transfer = \"flip\", stress_update = \"first\" to flip and "
           "xpic2, pressure_relaxation to anti-locking.",
           transfer_keys_are_used},
          {"A Mach number needs a speed to refer to, a reference speed a Mach number.",
           mach_has_a_speed},
          {"Both numbers of fe.cells are 0, or none.", fe_cells_are_both_given}};
    }

    std::vector<Rule> of_the_melt()
    {
      return {
          // Melt
          {"The interface width is a tenth of a cell at least.", interface_is_resolved},
          {"The anisotropy is less than 1/15.", anisotropy_is_well_posed},
          {"d0, tau0, W0, D and the kinetic coefficient satisfy the thin-interface relations to 1 "
           "%.",
           kinetics_are_consistent},
          {"Growth at an undercooling of 1 or more has kinetics.",
           strong_undercooling_has_kinetics},
          {"The first temperature does not depend on t.", first_temperature_is_fixed},
          {"Noise on a domain with symmetry sides is mirrored.", noise_respects_symmetry},
          {"A crystal that a symmetry side cuts is its own mirror image: its angle is a multiple "
           "of 45.",
           crystal_fits_symmetry},
          {"Supports and tractions are of bodies that stand at the start, not of what grows.",
           loads_do_not_grow},
          {"Heat beside a solid is carried by it, which takes a phase field.", heat_is_carried},
          {"The distance's interval is no longer than that of its map.",
           distance_is_measured_between_maps},
          // Expressions
          {"An expression is a finite number wherever and whenever it is used.",
           expressions_are_finite},
          // Probes
          {"A probe lies inside the domain, a point or region of the solid where material is.",
           probes_lie_inside},
          {"A probe asks for quantities that its modules know.", quantities_are_known},
          {"A reaction probe names a support, or a wall as \"wall top\".",
           reactions_have_a_support},
          {"Outline and tip probes need what they follow.", followed_things_exist},
          {"Times increase and do not pass the end; compressions need a wall.",
           times_lie_in_the_run}};
    }
  } // namespace

  const std::vector<Rule> &rules()
  {
    static const std::vector<Rule> list = []
    {
      std::vector<Rule> all = of_the_domain();
      for (const auto &more : {of_the_solid(), of_the_melt()})
        all.insert(all.end(), more.begin(), more.end());
      return all;
    }();
    return list;
  }

  bool Inspection::present(const std::string &section) const
  {
    return draft.root.find(section) != nullptr;
  }

  bool Inspection::written(const std::string &section, const std::string &key) const
  {
    const Value *table = draft.root.find(section);
    return table && table->find(key);
  }

  const Value &Inspection::at(const std::string &section, const std::string &key) const
  {
    const Value *table = draft.root.find(section);
    if (!table)
      return draft.root;
    if (const Value *value = table->find(key))
      return *value;
    // Of a list the first entry stands for all.
    return table->is_list_of_tables() ? table->items.front() : *table;
  }

  void Inspection::add_error(const Value &at, const std::string &cause, const std::string &allowed,
                             const std::string &remedy) const
  {
    if (at.place.key.empty() || !errors.about(at))
      errors.add(at, cause, allowed, remedy);
  }

  void check_rules(const Draft &draft, ErrorList &errors)
  {
    const Value *domain = draft.root.find("domain"), *bodies = draft.root.find("body");
    const auto sound = [&](const Value *value) { return !value || !errors.about(*value); };
    bool known = domain && sound(domain) && sound(bodies) && !draft.bodies.empty();
    for (const Body &body : draft.scene.bodies)
      known = known && !std::holds_alternative<RecordedOutline>(body.shape);
    const Inspection inspection{draft, errors, known};
    for (const Rule &rule : rules())
      rule.check(inspection);
  }
} // namespace scene
