// The checks behind rules.cc, by the file that holds them; each complains of what breaks its rule.
#pragma once

#include "scene/rules.h"

namespace scene
{
  // rules_domain.cc
  void something_happens(const Inspection &);
  void sections_are_used(const Inspection &);
  void imposed_or_solid(const Inspection &);
  void periodic_sides_are_paired(const Inspection &);
  void cells_are_square(const Inspection &);
  void mesh_holds_stencils(const Inspection &);
  void bodies_lie_in_the_domain(const Inspection &);
  void coupling_step_is_used(const Inspection &);
  void names_are_unique(const Inspection &);

  // rules_solid.cc
  void viscosity_needs_yield_stress(const Inspection &);
  void initial_state_is_of_a_solid(const Inspection &);
  void supports_hold_something(const Inspection &);
  void displacements_are_of_places_at_the_start(const Inspection &);
  void transfer_keys_are_used(const Inspection &);
  void mach_has_a_speed(const Inspection &);
  void fe_cells_are_both_given(const Inspection &);

  // rules_places.cc
  void loads_meet_material(const Inspection &);
  void supports_do_not_compete(const Inspection &);
  void tractions_act_on_outlines(const Inspection &);

  // rules_melt.cc
  void walls_have_room(const Inspection &);
  void walls_stand_on_own_sides(const Inspection &);
  void walls_know_when_to_start(const Inspection &);
  void interface_is_resolved(const Inspection &);
  void anisotropy_is_well_posed(const Inspection &);
  void kinetics_are_consistent(const Inspection &);
  void strong_undercooling_has_kinetics(const Inspection &);
  void first_temperature_is_fixed(const Inspection &);
  void noise_respects_symmetry(const Inspection &);
  void crystal_fits_symmetry(const Inspection &);
  void heat_is_carried(const Inspection &);
  void distance_is_measured_between_maps(const Inspection &);
  void loads_do_not_grow(const Inspection &);

  // rules_probes.cc
  void probes_lie_inside(const Inspection &);
  void quantities_are_known(const Inspection &);
  void reactions_have_a_support(const Inspection &);
  void followed_things_exist(const Inspection &);
  void times_lie_in_the_run(const Inspection &);

  // rules_values.cc
  void expressions_are_finite(const Inspection &);
  void initial_stress_is_within_yield(const Inspection &);
  void overlapping_bodies_start_alike(const Inspection &);
} // namespace scene
