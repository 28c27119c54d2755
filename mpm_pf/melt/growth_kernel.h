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
// has an isotropic leading error and a step limit 1.5 times as long. It is summed from differences
// to the centre: exactly zero on a constant, and precise in single precision.
// Fluxes through the faces of a row are staged in row buffers that stay in the first-level cache.
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
    Real eps, lambda;
    Real rate;                      // h/tau0
    Real phase;                     // h W0^2/(tau0 dx^2)
    Real heat;                      // h D/dx^2
    Real ratio;                     // dx/dy
    Real edge, edge_excess, corner; // Laplacian: edge (dxx + dyy) + edge_excess dyy + corner (...)
    Real cosine, sine;              // of four times a uniform crystal angle
  };

  /// Three rows of one field round the row to be updated.
  template <class Real>
  struct Rows
  {
    const Real *below, *here, *above;
  };

  /// dx^2 times the Laplacian at node i.
  template <class Real>
  inline Real laplacian(const Rows<Real> &f, int i, const Coefficients<Real> &k)
  {
    const Real c = f.here[i];
    const Real x = (f.here[i + 1] - c) + (f.here[i - 1] - c);
    const Real y = (f.above[i] - c) + (f.below[i] - c);
    const Real corners = ((f.above[i + 1] - c) + (f.below[i - 1] - c)) +
                         ((f.above[i - 1] - c) + (f.below[i + 1] - c));
    return k.edge * (x + y) + k.edge_excess * y + k.corner * corners;
  }

  /// Rows of cos and sin of four times the crystal angle at rows j and j + 1; unused when uniform.
  template <class Real>
  struct Angles
  {
    const Real *cosine, *cosine_above, *sine, *sine_above;
  };

  /// Fluxes through the faces (i, j + 1/2), i = 0 .. count - 1, from rows j and j + 1.
  template <bool varying, class Real>
  inline void flux_up(const Real *here, const Real *above, const Angles<Real> &angle, int count,
                      const Coefficients<Real> &k, Real *flux)
  {
#pragma omp simd
    for (int i = 0; i < count; ++i)
    {
      const Real n = (above[i] - here[i]) * k.ratio;
      const Real t = Real(0.25) * ((here[i + 1] + above[i + 1]) - (here[i - 1] + above[i - 1]));
      const Real c = varying ? Real(0.5) * (angle.cosine[i] + angle.cosine_above[i]) : k.cosine;
      const Real s = varying ? Real(0.5) * (angle.sine[i] + angle.sine_above[i]) : k.sine;
      flux[i] = k.ratio * anisotropic_flux(n, t, c, -s, k.eps);
    }
  }

  /// Fluxes through the faces (i - 1/2, j), i = 0 .. count.
  template <bool varying, class Real>
  inline void flux_right(const Rows<Real> &phi, const Angles<Real> &angle, int count,
                         const Coefficients<Real> &k, Real *flux)
  {
#pragma omp simd
    for (int i = 0; i <= count; ++i)
    {
      const Real n = phi.here[i] - phi.here[i - 1];
      const Real t = Real(0.25) * k.ratio *
                     ((phi.above[i] + phi.above[i - 1]) - (phi.below[i] + phi.below[i - 1]));
      const Real c = varying ? Real(0.5) * (angle.cosine[i] + angle.cosine[i - 1]) : k.cosine;
      const Real s = varying ? Real(0.5) * (angle.sine[i] + angle.sine[i - 1]) : k.sine;
      flux[i] = anisotropic_flux(n, t, c, s, k.eps);
    }
  }

  /// Faces of one row: below and above its nodes, and left and right of them.
  template <class Real>
  struct StagedFluxes
  {
    alignas(64) std::array<Real, run_length> first, second;
    alignas(64) std::array<Real, run_length + 1> across;
    Real *below = first.data(), *above = second.data();
  };

  /// Eqs. (1) and (2) at nodes i = 0 .. count - 1 of one row. `heat` false: no temperature.
  template <bool varying, bool heat, class Real>
  inline void update_row(const Rows<Real> &phi, const Rows<Real> &theta, const Angles<Real> &angle,
                         const StagedFluxes<Real> &flux, int count, const Coefficients<Real> &k,
                         Real *new_phi, Real *new_theta)
  {
    const Real *below = flux.below, *above = flux.above, *across = flux.across.data();
#pragma omp simd
    for (int i = 0; i < count; ++i)
    {
      const Real f = phi.here[i];
      const Real well = 1 - f * f;
      const Real drive = heat ? f - k.lambda * theta.here[i] * well : f;
      const Real diffusion =
          laplacian(phi, i, k) + ((across[i + 1] - across[i]) + (above[i] - below[i]));
      const Real gx = phi.here[i + 1] - phi.here[i - 1];
      const Real gy = k.ratio * (phi.above[i] - phi.below[i]);
      const Real c = varying ? angle.cosine[i] : k.cosine;
      const Real s = varying ? angle.sine[i] : k.sine;
      const Real change = inverse_relaxation(gx, gy, c, s, k.eps) *
                          (k.phase * diffusion + k.rate * (drive * well)); // Eq. (1)
      const Real next = f + change;
      new_phi[i] = next;
      if constexpr (heat)
        new_theta[i] =
            theta.here[i] + (k.heat * laplacian(theta, i, k) + Real(0.5) * (next - f)); // Eq. (2)
    }
  }

  /// Eq. (2) where phi rests.
  template <class Real>
  inline void diffuse_row(const Rows<Real> &theta, int count, const Coefficients<Real> &k,
                          Real *new_theta)
  {
#pragma omp simd
    for (int i = 0; i < count; ++i)
      new_theta[i] = theta.here[i] + k.heat * laplacian(theta, i, k); // Eq. (2)
  }
} // namespace melt
