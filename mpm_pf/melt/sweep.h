// Many explicit steps of Eqs. (1) and (2) over the whole mesh: fused rows, ping-pong, tiles,
// threads.
//
// Each field has a second copy; a step reads one and writes the other. Rows are cut into bands of
// one tile's height, the unit of work of a thread: every node is computed by the same expression
// from the same old values, so that the result has the same bits for any number of threads. Bands
// go on to the next step as soon as their neighbours let them (melt/band_scheduler.h). Tiles
// (medium/tiles.h) are classified anew every 16 steps. phi counts as resting in a well within
// `flatness`; theta counts as resting only where it is one constant to the last bit, so that
// skipping changes nothing and loses no heat. Tiles on and off differ by no more than the flatness.
#pragma once

#include <vector>

#include "medium/cuts.h"
#include "medium/tiles.h"
#include "melt/growth_kernel.h"

namespace melt
{
  class Noise;
  using medium::Field;
  using medium::Mesh;

  /// cos and sin of four times the crystal angle as nodal fields; null pointers where it is
  /// uniform.
  template <class Real>
  struct AngleFields
  {
    const Field<Real> *cosine = nullptr, *sine = nullptr;
  };

  template <class Real>
  class Sweep
  {
  public:
    /// How far phi may be from its well in a tile that is skipped. In single precision phi stalls a
    /// few roundings before its well, so the flatness must lie above that.
    static constexpr Real flatness = sizeof(Real) == 8 ? Real(1e-10) : Real(1e-5);
    /// Steps between two updates of the tiles.
    static constexpr int steps_between_updates = 16;

    /// `tiles` false: every tile is always active.
    Sweep(const Mesh &, bool tiles);

    struct Fields
    {
      Field<Real> *phi, *theta; // either may be null: an absent equation
      AngleFields<Real> angle;
      const Noise *noise;                 // null: none
      double step;                        // its length, time; the noise needs it
      const medium::Cuts *cuts = nullptr; // moving walls; null: the domain ends at its borders
    };
    /// `steps` steps with the coefficients of one step; `first_step` numbers them for the noise.
    /// Ghosts are filled before and after. Throws medium::NumericalError where phi stops being
    /// finite (|phi| > 2), naming step and node.
    void run(const Fields &, const Coefficients<Real> &, long first_step, long steps);

    const medium::Tiles &tiles() const { return map; }
    std::size_t bytes() const;

  private:
    struct Run
    {
      int begin, end;
      medium::Activity activity;
    };
    struct Pair
    {
      Field<Real> *phi[2], *theta[2];
    };
    struct RowRange
    {
      int first, end;
    };
    RowRange rows_of(int band, const medium::Cuts *) const;
    void fill_behind_walls(const Fields &, const Pair &, int old, RowRange) const;
    void step_band(const Fields &, const Pair &, int old, const Coefficients<Real> &, int band,
                   long step) const;
    void step_active(const Fields &, const Pair &, int old, const Coefficients<Real> &, Run,
                     RowRange) const;
    void step_heat(const Pair &, int old, const Coefficients<Real> &, Run, RowRange) const;
    void finish_row(Field<Real> &next, const Field<Real> &last, int j, const medium::Cuts *) const;
    bool classify_band(const Fields &, const Pair &, int now, int band);
    void update_tiles(const Pair &, int now);
    void rest_in_both(const Pair &, int now, int column, int row, medium::Activity) const;

    Mesh mesh;
    bool skipping;
    medium::Tiles map;
    std::vector<medium::TileState<Real>> states;
    std::vector<std::vector<Run>> runs; // of each band
    Field<Real> spare_phi, spare_theta;
  };
} // namespace melt
