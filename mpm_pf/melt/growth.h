// Growth of the crystal: Eqs. (1) and (2) without their advection, advanced together in explicit
// steps, and the limit of such a step.
//
// The two equations are swept at once (sweep.h), because the latent heat of Eq. (2) is the
// increment of Eq. (1). Fields are double for everyone else; in single precision growth keeps
// private copies, converted at the beginning and the end of advance() (float -> double -> float is
// exact, so cutting a run into calls changes no bit).
#pragma once

#include <variant>

#include "melt/noise.h"
#include "melt/orientation.h"
#include "melt/sweep.h"
#include "melt/thin_interface.h"

namespace melt
{
  struct GrowthOptions
  {
    scene::Laplacian laplacian = scene::Laplacian::nine_point;
    scene::Precision precision = scene::Precision::double_precision;
    bool tiles = true;
    bool phase = true;  // false: of heat alone, so that Eq. (1) limits no step
    bool force = false; // accept a step past the limit (to show the blow-up being caught)
  };

  /// Longest stable explicit step of Eq. (2), 2/(D K), K the largest eigenvalue of the Laplacian:
  /// dx^2/(4 D) for five points, 3 dx^2/(8 D) for nine, on square cells. Time; infinite for D = 0.
  double heat_step_limit(const Mesh &, const Law &, scene::Laplacian);

  /// Longest stable explicit step of Eq. (1): 2/(W0^2/tau0 (K + K5 m) + reaction), time. m bounds
  /// the anisotropic part: along the interface W0^2/tau0 (1 + 15 eps)/(1 - eps) at its stiffest.
  /// `undercooling` bounds |theta| in the reaction's slope, 2 + 1.54 lambda |theta| over tau0.
  double phase_step_limit(const Mesh &, const Law &, scene::Laplacian, double undercooling);

  class Growth
  {
  public:
    /// `law` must come from make_law or be consistent; `undercooling` is the largest |theta|.
    Growth(const Mesh &, const Law &, const GrowthOptions &, double undercooling);

    /// The fields that advance() advances. theta null: growth by curvature alone. phi null: heat
    /// alone. orientation null: crystal angle zero. noise null: none. cuts null: no walls have
    /// moved in; else nodes behind them rest, and no heat or phase passes the walls' true places.
    struct Fields
    {
      Field<double> *phi = nullptr, *theta = nullptr;
      const Orientation *orientation = nullptr;
      const Noise *noise = nullptr;
      const medium::Cuts *cuts = nullptr;
    };

    /// The smaller of the two limits (that of heat alone without a phase), time. The two equations
    /// are coupled by the latent heat at the front: with both, steps up to 0.97 of it are stable
    /// (measured: dx/W0 0.25 to 0.8, eps 0 to 0.06), 1.0 of it are not.
    double step_limit() const { return limit; }

    /// `steps` steps of length `h` (time) of Eqs. (1) and (2), right sides. Ghosts are filled
    /// afterwards. Throws std::invalid_argument if h exceeds step_limit() (unless forced), naming
    /// both; medium::NumericalError if phi leaves its bounds.
    void advance(const Fields &, double h, long steps);

    /// Steps taken so far: the noise counts by them. Part of a checkpoint.
    long steps_taken() const { return taken; }
    void restore_steps_taken(long steps) { taken = steps; }

    const Law &law() const { return parameters; }
    const Mesh &mesh() const { return grid; }
    const medium::Tiles &tiles() const;
    std::size_t bytes() const;

  private:
    struct SingleCopies
    {
      Field<float> phi, theta, cosine, sine;
    };
    void advance_in_double(const Fields &, double h, long steps);
    void advance_in_single(const Fields &, double h, long steps);

    Mesh grid;
    Law parameters;
    GrowthOptions options;
    double limit;
    long taken = 0;
    std::variant<Sweep<double>, Sweep<float>> sweep;
    SingleCopies copies; // empty in double precision
  };
} // namespace melt
