// The solid of a growing crystal: material points made from phi, Sec. 2.2 (end) of the paper.
//
// Before anything presses on the crystal it moves nowhere, so no point exists. activate() fills
// {phi > 0} with points; from then on seed_new_points() adds what Eq. (1) grows, stress-free, at
// the phi = 0 contour, "so as to match the amount of new solid for each cell", and takes away what
// melts. Only the right side of Eq. (1) counts, measured just before and just after it: the drift
// of the contour against the points under advection is never made up for, but reported.
//
// The paper's rule alone gives points of vanishing mass. So a cell keeps account of the area it
// owes to the points until that is a quarter of a cell (the share of one of 2 x 2 points); what a
// cell owes when the contour has left it goes to the nearest cell that the contour crosses. Points
// + owed area = area at activation + grown - melted, always. Areas of this header are those of
// stress-free solid, mass over density. Only what is owed by the points is an area of the strained
// solid, since that is what phi melts; once it has been paid it is booked as melted without stress.
#pragma once

#include <optional>

#include "medium/field.h"
#include "solid/solid.h"

namespace solid
{
  /// Where phi is, and the rectangle between moving walls if it is smaller than the domain.
  struct Crystal
  {
    const medium::Field<double> &phi;
    const medium::Mesh &mesh;
    std::optional<scene::Box> between_walls;
  };

  /// True once activate() has been called.
  bool active(const Solid &);

  /// Points in {phi > 0} at rest and free of stress, and the solid's clock set to `time`. Slivers
  /// below a quarter of a point's share are owed. Throws std::logic_error if the solid already has
  /// points.
  void activate(Solid &, const Crystal &, double time);
  /// What the bodies start with, velocity and stress, for the points just made from them.
  void set_initial_state(Solid &, const std::vector<scene::Body> &);

  /// Remember the areas from which growth starts. Nothing happens before activation.
  void begin_growth(Solid &, const Crystal &);
  /// After growth: record what each cell has gained or lost since, add or remove points. Nothing
  /// happens before activation.
  void seed_new_points(Solid &, const Crystal &);

  /// Areas since activation (length^2) and numbers of points. activated + grown - melted = points +
  /// owed, to round-off.
  struct AreaBudget
  {
    double activated = 0., grown = 0., melted = 0.;
    double seeded = 0., removed = 0.; // of the points added and taken away since activation
    double points = 0., owed = 0.;    // of all points; not yet given to any
    double phi = 0.;                  // of {phi > 0} when last measured
    long seeded_points = 0, removed_points = 0, split_points = 0;
    double imbalance() const { return activated + grown - melted - points - owed; }
  };
  /// All zero before activation.
  AreaBudget area_budget(const Solid &);

  /// Columns for a history of a growing solid: grown_area, melted_area, owed_area, area_imbalance,
  /// area_drift ((current area of the points + owed)/(area of phi > 0) - 1), seeded_points,
  /// removed_points, split_points.
  History growth_history(const Solid &);
} // namespace solid
