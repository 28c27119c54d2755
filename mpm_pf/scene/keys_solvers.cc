#include "scene/read_value.h"

namespace scene
{
  namespace
  {
    Section mpm()
    {
      return Keys<Mpm>("mpm", "Settings of the material points; read by mpm_pf only.")
          .add("points_per_cell", &Mpm::points_per_cell, between(1, 16),
               "Material points per cell in x and y.",
               "2 x 2 is the paper's; 3 x 3 delays numerical fracture under large stretch")
          .add("shape_function", &Mpm::shape_function, any(), "How points and nodes weigh.",
               "quadratic splines bridge gaps up to two cells where uGIMP breaks up; they are "
               "made interpolating at held lines")
          .add("transfer", &Mpm::transfer, any(), "What goes between points and nodes.",
               "an affine transfer neither tears as FLIP nor damps as PIC: a swinging cantilever "
               "four cells high loses 0.3 % of its energy a period with tpic, 0.6 % with apic, "
               "2.5 % with flip and flip_fraction = 1, 16 % with 0.99, 75 % with xpic2, all with "
               "pic; a collision over few cells wants flip with stress_update = first")
          .add("flip_fraction", &Mpm::flip_fraction, between(0., 1.),
               "Part of FLIP in a FLIP-PIC blend, with transfer = flip.",
               "the usual compromise between noise and damping; a body that spins freely loses "
               "94 % of its kinetic energy in two turns of 6000 steps each with it")
          .add("stress_update", &Mpm::stress_update, any(),
               "Where in a step the stresses change: last, with the nodes' velocities after the "
               "forces, or first, with those before; first goes with flip and xpic2.",
               "last takes one pass each way a step, first two; last damps what flip would keep "
               "(colliding discs on 20 x 20 cells lose 13 % of their energy, with first they end "
               "within 3 %). First is for impacts and waves: under slow loads strains lag behind "
               "the motion (the elastic sheared bar loses 20 % of its force with flip, 94 % with "
               "xpic2)")
          .add("anti_locking", &Mpm::anti_locking, any(),
               "Average the volumetric strain rate over each cell and relax point pressures to "
               "the cell mean.",
               "absent: on for solids with a yield stress or a Poisson's ratio above 0.45, which "
               "deform at nearly constant volume and lock without it")
          .add("pressure_relaxation", &Mpm::pressure_relaxation, between(0., 1.),
               "Part of the way to the cell mean that a point's pressure goes per step.",
               "without it cell averaging leaves pressures that never meet; 0.01 to 1 give the "
               "same answers")
          .add("step_fraction", &Mpm::step_fraction, up_to(1.), "Step as a part of dx/(c_p + |v|).",
               "0.2 to 0.7 give the same answers; 0.4 leaves room for badly filled cells; after a "
               "shorter step, as what is recorded makes them, at most 0.7 is taken, since unlike "
               "steps beyond that can pump a wave")
          .add("node_mass_floor", &Mpm::node_mass_floor, between(0., 0.5),
               "Nodes below this part of a full cell's mass follow those behind them; 0: off, as "
               "always with stress_update = \"first\".",
               "few points reach a rim's nodes, and what these are out of balance by eats the "
               "work: of a cantilever bent far 19 % at 0, 3 % at 0.1. The step does not ask for "
               "the smallest mass, as light nodes follow; at 0 linear functions have no safe step")
          .add("mach", &Mpm::mach, inside(0., 1.),
               "Wanted ratio of the reference speed to the wave speed: the density is scaled to "
               "it, and with it the mass, momentum and kinetic energy that a history tells.",
               "absent: the true density; a stocky body loaded slowly bears 1 % too much at 1e-3 "
               "to 2e-3, a slender one needs less, since it bends in its own period (a beam 8 "
               "times as long as high: 1e-4), and one that yields all over in bending much less "
               "(3 times as long: 5e-6), which no energy tells: halve mach and compare; it "
               "refers to the wave of compression, beside which one of shear is slow as "
               "poisson_ratio nears 0.5; a run whose kinetic energy is too high for it says so")
          .add("reference_speed", &Mpm::reference_speed, positive(Dimension::speed),
               "Speed that mach refers to.", "absent: the largest speed of supports and walls")
          .add("split_points", &Mpm::split_points, any(),
               "Split points that have stretched over more than a cell.",
               "splines hold together without it in all cases of the paper")
          .optional();
    }

    Section fe()
    {
      return Keys<Fe>("fe", "Settings of the finite elements; read by fe_reference only.")
          .add("cells", &Fe::cells, between(0, 10000),
               "Cells in x and y over the bodies' bounding box; 0: as fine as the domain's cells.",
               "comparable resolution without a word")
          .add("degree", &Fe::degree, between(1, 2), "Polynomial degree of the displacement.",
               "quadratic with volume ratios linear in a cell: does not lock, third order")
          .add("load_steps", &Fe::load_steps, between(1, 10000000),
               "Steps to clock.end at the least: none is longer than that part of it, each time "
               "of a probe ends one (a probe without times or every: 200), and one that does not "
               "converge is halved and tried again.",
               "1 % of the way each resolves the yielding of all cases of the paper")
          .add("tolerance", &Fe::tolerance, inside(0., 1.),
               "Relative residual at which Newton's method stops.",
               "far below the discretisation error, above round-off")
          .add("grading", &Fe::grading, Allowed{Dimension::none, {0., 1., true, false}},
               "0: uniform; towards 1: finer near clamped corners.", "only clamped corners need it")
          .add("past_folding", &Fe::past_folding, any(),
               "Go on past the clock's end until a hundredth of the cells has folded, or no "
               "equilibrium is "
               "found.",
               "the few cells at singular corners fold first; folded ones are marked invalid "
               "either way")
          .optional();
    }
  } // namespace

  std::vector<Section> solver_sections()
  {
    return {mpm(), fe()};
  }
} // namespace scene
