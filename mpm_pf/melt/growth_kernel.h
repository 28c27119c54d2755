// Eqs. (1) and (2) on a run of neighbouring nodes of a few rows: the inner loops of growth.
//
//   tau0 xi^2 d phi/dt = W0^2 [ lap phi + div J ] + (phi - lambda theta (1 - phi^2)) (1 - phi^2)
//   d theta/dt         = D lap theta + 1/2 d phi/dt
//
// J is the anisotropic part of the flux (anisotropy.h), evaluated once on every face, so that a
// crystal angle that varies in space brings its own terms. In Eq. (1) as printed it is the two
// |grad phi|^2 W dW/d phi_x,y terms together with div((W^2 - W0^2) grad phi). Explicit Euler in
// time; both right sides use the old fields, and the latent heat uses the very increment of phi, so
// that the weighted sum of theta - phi/2 is conserved to rounding.
//
// The Laplacian is five-point or nine-point; the latter,
//   dxx + dyy + (dx^2 + dy^2)/12 dxx dyy,
// has an isotropic leading error and a step limit 1.5 times as long. Its part along the mesh lines
// goes with the fluxes in Eq. (1). Sums are taken so that a constant gives exactly zero.
// Multiplications bound these loops on machines of today: slopes and fluxes that nodes and faces
// share are staged in row buffers, which stay in the first-level cache.
#pragma once

#include <algorithm>
#include <array>

#include "melt/anisotropy.h"

namespace melt
{
  /// Longest run of nodes handled at once: its staged faces fit into the first-level cache.
  inline constexpr int run_length = 256;

  /// The numbers of one step. Lengths in units of dx.
  template <class Real>
  struct Coefficients
  {
    Real lambda;
    Real rate;  // h/tau0
    Real phase; // h W0^2/(tau0 dx^2)
    Real ratio; // dx/dy
    // Laplacian: flux_x dxx + ratio^2 flux_y dyy + corner (sum over the corners - 4 f).
    Real flux_x, flux_y, corner;
    // The same for heat, times h D/dx^2: edge (dxx + dyy) + excess dyy + corner (...).
    Real heat_edge, heat_excess, heat_corner;
    Real eps;
    Real cosine, sine; // eps times those of four times a uniform crystal angle
  };

  /// Three rows of one field round the row to be updated.
  template <class Real>
  struct Rows
  {
    const Real *below, *here, *above;
  };

  /// Sum over the four corners round node i, minus four times its own value: the same bits for a
  /// mirrored or transposed field, and exactly zero on a constant.
  template <class Real>
  inline Real corners(const Rows<Real> &f, int i)
  {
    return ((f.above[i + 1] + f.below[i - 1]) + (f.above[i - 1] + f.below[i + 1])) - 4 * f.here[i];
  }

  /// h D times the Laplacian at node i.
  template <class Real>
  inline Real heat_diffusion(const Rows<Real> &f, int i, const Coefficients<Real> &k)
  {
    const Real c = f.here[i], x = f.here[i + 1] + f.here[i - 1], y = f.above[i] + f.below[i];
    return k.heat_edge * ((x + y) - 4 * c) +
           (k.heat_corner * corners(f, i) + k.heat_excess * (y - 2 * c));
  }

  /// Rows of cos and sin of four times the crystal angle at rows j and j + 1; unused when uniform.
  template <class Real>
  struct Angles
  {
    const Real *cosine, *cosine_above, *sine, *sine_above;
  };

  /// What the nodes and faces of one row share with their neighbours: slopes (a quarter of the
  /// difference of both neighbours' values) at nodes and fluxes through faces.
  template <class Real>
  struct Staged
  {
    static constexpr int lead = 64 / sizeof(Real);
    using Row = std::array<Real, run_length + 2 * lead>;
    alignas(64) Row rows[6];
    Real *along = row(0), *along_above = row(1); // slopes along x in rows j and j + 1
    Real *upward = row(2);                       // slopes along y in row j; from -1 to count
    Real *below = row(3), *above = row(4);       // fluxes through the faces (i, j -+ 1/2)
    Real *left = row(5);                         // fluxes through the faces (i - 1/2, j)

    /// Before the next row is taken.
    void advance()
    {
      std::swap(along, along_above);
      std::swap(below, above);
    }

  private:
    Real *row(int n) { return rows[n].data() + lead; }
  };

  /// Slopes along x of a row's nodes i = 0 .. count - 1.
  template <class Real>
  inline void slopes_along(const Real *f, int count, Real *slope)
  {
#pragma omp simd
    for (int i = 0; i < count; ++i)
      slope[i] = Real(0.25) * (f[i + 1] - f[i - 1]);
  }

  /// Slopes of row j along y, and of row j + 1 along x; fluxes through the faces (i, j + 1/2),
  /// i = 0 .. count - 1.
  template <bool varying, class Real>
  inline void flux_up(Rows<Real> phi, Angles<Real> angle, int count, Coefficients<Real> k,
                      Staged<Real> &staged)
  {
    Real *along_above = staged.along_above, *upward = staged.upward, *flux = staged.above;
    const Real *along = staged.along;
    const Real quarter = Real(0.25) * k.ratio, half = Real(0.5) * k.eps;
    for (const int end : {-1, count})
      upward[end] = quarter * (phi.above[end] - phi.below[end]);
#pragma omp simd
    for (int i = 0; i < count; ++i)
    {
      const Real n = (phi.above[i] - phi.here[i]) * k.ratio;
      const Real slope = Real(0.25) * (phi.above[i + 1] - phi.above[i - 1]);
      const Real c = varying ? half * (angle.cosine[i] + angle.cosine_above[i]) : k.cosine;
      const Real s = varying ? -half * (angle.sine[i] + angle.sine_above[i]) : -k.sine;
      upward[i] = quarter * (phi.above[i] - phi.below[i]);
      along_above[i] = slope;
      flux[i] = face_flux(n, along[i] + slope, c, s, k.flux_y);
    }
  }

  /// Fluxes through the faces (i - 1/2, j), i = 0 .. count.
  template <bool varying, class Real>
  inline void flux_right(const Real *here, Angles<Real> angle, int count, Coefficients<Real> k,
                         Staged<Real> &staged)
  {
    Real *flux = staged.left;
    const Real *upward = staged.upward;
    const Real half = Real(0.5) * k.eps;
#pragma omp simd
    for (int i = 0; i <= count; ++i)
    {
      const Real c = varying ? half * (angle.cosine[i] + angle.cosine[i - 1]) : k.cosine;
      const Real s = varying ? half * (angle.sine[i] + angle.sine[i - 1]) : k.sine;
      flux[i] = face_flux(here[i] - here[i - 1], upward[i] + upward[i - 1], c, s, k.flux_x);
    }
  }

  /// Eqs. (1) and (2) at nodes i = 0 .. count - 1 of one row. `heat` false: no temperature.
  template <bool varying, bool heat, class Real>
  inline void update_row(Rows<Real> phi, Rows<Real> theta, Angles<Real> angle,
                         const Staged<Real> &staged, int count, Coefficients<Real> k, Real *new_phi,
                         Real *new_theta)
  {
    const Real *below = staged.below, *above = staged.above, *left = staged.left;
    const Real *along = staged.along, *upward = staged.upward;
#pragma omp simd
    for (int i = 0; i < count; ++i)
    {
      const Real f = phi.here[i];
      const Real well = 1 - f * f;
      const Real drive = heat ? f - k.lambda * theta.here[i] * well : f;
      const Real diffusion =
          ((left[i + 1] - left[i]) + k.ratio * (above[i] - below[i])) + k.corner * corners(phi, i);
      const Real c = varying ? k.eps * angle.cosine[i] : k.cosine;
      const Real s = varying ? k.eps * angle.sine[i] : k.sine;
      const Real change = inverse_relaxation(along[i], upward[i], c, s) *
                          (k.phase * diffusion + k.rate * (drive * well)); // Eq. (1)
      const Real next = f + change;
      new_phi[i] = next;
      if constexpr (heat)
        new_theta[i] =
            theta.here[i] + (heat_diffusion(theta, i, k) + Real(0.5) * (next - f)); // Eq. (2)
    }
  }

  /// Eq. (2) where phi rests.
  template <class Real>
  inline void diffuse_row(Rows<Real> theta, int count, Coefficients<Real> k, Real *new_theta)
  {
#pragma omp simd
    for (int i = 0; i < count; ++i)
      new_theta[i] = theta.here[i] + heat_diffusion(theta, i, k); // Eq. (2)
  }
} // namespace melt
