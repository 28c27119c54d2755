// Everything that moves, in one place: what solid.h hands out only by name.
#pragma once

#include <chrono>

#include "solid/constitutive.h"
#include "solid/light_nodes.h"
#include "solid/loads.h"
#include "solid/solid.h"
#include "solid/supports.h"

namespace solid
{
  struct Growing; // area_budget.h

  struct Energy
  {
    double start = 0.;         // kinetic and elastic, at the start and with what growth has added
    double kinetic = 0.;       // now
    double dissipated = 0.;    // by plastic flow since the start
    double largest = 0.;       // start and work so far, when that was most
    double strained = 0.;      // work of the stresses on the strains since the start
    double elastic_start = 0.; // the elastic part of `start`
    // Integrals over time, of the kinetic energy and of what the stresses hold or have dissipated:
    double kinetic_time = 0., internal_time = 0.;
  };

  /// Of the calls of advance in which walls pressed, by axis: sums of the absolute changes of the
  /// solid's momentum and of the absolute impulses of the walls.
  struct WallBalance
  {
    Point change = Point::Zero(), impulse = Point::Zero();
  };

  struct Solid
  {
    Scheme scheme;
    Material material;
    Fraction fraction;
    scene::Domain domain;
    Points points;
    Grid grid;
    CellMeans cells;
    Supports supports;
    LightNodes light_nodes;
    Loads loads;
    Tracers tracers;
    Energy energy;
    WallBalance wall_balance;
    SortScratch scratch;
    std::vector<Share> shares; // of the blocks
    std::array<int, 2> points_per_cell{2, 2};
    std::shared_ptr<Growing> growing;                   // once a crystal's points exist
    long split_points = 0;                              // so far
    std::map<std::string, record::Profile::Part> spent; // by part of a step
    double time = 0., speed = 0.;                       // largest speed of a point
    double call_duration = 0.;                          // of the last call of advance
    double reference_speed = 0.;                        // that the Mach number refers to
    double bin = 0.; // side of the bins of a sampled line unless it says otherwise
    long steps = 0;
    double last_step = 0.; // its length; 0 before the first
    int threads = 1;

    Interpolation interpolation() const { return {scheme, grid, supports.folds}; }
    MomentumSource momentum_source() const
    {
      return {points, loads.acceleration, 1. / material.density};
    }

    explicit Solid(const scene::Scene &scene) : fraction(scene.domain), domain(scene.domain) {}
  };

  /// Arrays beside the grid take its size, those of incremental transfers that of the points.
  void resize_with_grid(Solid &);
} // namespace solid
