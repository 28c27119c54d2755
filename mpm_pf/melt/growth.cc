#include "melt/growth.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace melt
{
  namespace
  {
    struct Weights
    {
      double edge, edge_excess, corner, ratio;
    };

    /// Weights of dx^2 times the Laplacian, see growth_kernel.h.
    Weights laplacian_weights(const Mesh &mesh, scene::Laplacian kind)
    {
      const double ratio = mesh.spacing[0] / mesh.spacing[1], square = ratio * ratio;
      const double corner = kind == scene::Laplacian::nine_point ? (1. + square) / 12. : 0.;
      return {1. - 2. * corner, square - 1., corner, ratio};
    }

    /// Largest eigenvalue of minus the Laplacian, per length^2. With s = sin^2 of half the phase
    /// along x and r along y it is 4 (s + ratio^2 r) - 16 corner s r, bilinear: largest in a
    /// corner.
    double largest_eigenvalue(const Mesh &mesh, scene::Laplacian kind)
    {
      const Weights w = laplacian_weights(mesh, kind);
      const double x = 4., y = 4. * w.ratio * w.ratio, both = x + y - 16. * w.corner;
      return std::max({x, y, both}) / (mesh.spacing[0] * mesh.spacing[0]);
    }

    template <class Real>
    Coefficients<Real> coefficients(const Mesh &mesh, const Law &law, scene::Laplacian kind,
                                    double h, const Orientation *orientation)
    {
      const Weights w = laplacian_weights(mesh, kind);
      const double square = mesh.spacing[0] * mesh.spacing[0];
      Coefficients<Real> k;
      const double heat = h * law.diffusivity / square, across = w.ratio * w.ratio;
      k.lambda = Real(law.coupling);
      k.rate = Real(h / law.relaxation);
      k.phase = Real(h * law.width * law.width / (law.relaxation * square));
      k.ratio = Real(w.ratio);
      k.flux_x = Real(w.edge), k.flux_y = Real((w.edge + w.edge_excess) / across);
      k.corner = Real(w.corner);
      k.heat_edge = Real(heat * w.edge), k.heat_excess = Real(heat * w.edge_excess);
      k.heat_corner = Real(heat * w.corner);
      k.eps = Real(law.anisotropy);
      k.cosine = Real(law.anisotropy * (orientation ? orientation->uniform_cosine : 1.));
      k.sine = Real(law.anisotropy * (orientation ? orientation->uniform_sine : 0.));
      return k;
    }

    void convert(const Field<double> &from, Field<float> &to)
    {
      for (int j = -medium::ghost_layers; j < from.nodes(1) + medium::ghost_layers; ++j)
        std::copy(from.row(j) - medium::ghost_layers,
                  from.row(j) + from.nodes(0) + medium::ghost_layers,
                  to.row(j) - medium::ghost_layers);
    }
    void convert(const Field<float> &from, Field<double> &to)
    {
      for (int j = -medium::ghost_layers; j < from.nodes(1) + medium::ghost_layers; ++j)
        std::copy(from.row(j) - medium::ghost_layers,
                  from.row(j) + from.nodes(0) + medium::ghost_layers,
                  to.row(j) - medium::ghost_layers);
    }
  } // namespace

  double heat_step_limit(const Mesh &mesh, const Law &law, scene::Laplacian kind)
  {
    if (law.diffusivity == 0.)
      return std::numeric_limits<double>::infinity();
    return 2. / (law.diffusivity * largest_eigenvalue(mesh, kind));
  }

  double phase_step_limit(const Mesh &mesh, const Law &law, scene::Laplacian kind,
                          double undercooling)
  {
    const double stiffest = (1. + 15. * law.anisotropy) / (1. - law.anisotropy);
    const double diffusion =
        law.width * law.width / law.relaxation *
        (largest_eigenvalue(mesh, kind) +
         (stiffest - 1.) * largest_eigenvalue(mesh, scene::Laplacian::five_point));
    // Largest slope of the reaction: 2 in the wells, and of 4 phi (1 - phi^2) between them.
    const double reaction = (2. + 1.5397 * law.coupling * undercooling) / law.relaxation /
                            std::pow(1. - law.anisotropy, 2);
    return 2. / (diffusion + reaction);
  }

  Growth::Growth(const Mesh &m, const Law &law, const GrowthOptions &o, double undercooling)
      : grid(m), parameters(law), options(o),
        limit(o.phase ? std::min(heat_step_limit(m, law, o.laplacian),
                                 phase_step_limit(m, law, o.laplacian, undercooling))
                      : heat_step_limit(m, law, o.laplacian)),
        sweep(Sweep<double>(m, o.tiles))
  {
    if (options.precision == scene::Precision::single_precision)
      sweep.emplace<Sweep<float>>(m, o.tiles);
  }

  void Growth::advance(const Fields &fields, double h, long steps)
  {
    if (h > limit * (1. + 1e-12) && !options.force)
    {
      std::ostringstream text;
      text << "growth step " << h << " exceeds the limit " << limit
           << " of the explicit scheme; give a shorter step or drop growth.step (use --force to "
              "see it fail)";
      throw std::invalid_argument(text.str());
    }
    if (steps <= 0)
      return;
    if (std::holds_alternative<Sweep<double>>(sweep))
      advance_in_double(fields, h, steps);
    else
      advance_in_single(fields, h, steps);
    taken += steps;
  }

  void Growth::advance_in_double(const Fields &fields, double h, long steps)
  {
    AngleFields<double> angle;
    if (fields.orientation && fields.orientation->varying())
      angle = {&fields.orientation->cosine, &fields.orientation->sine};
    std::get<Sweep<double>>(sweep).run(
        {fields.phi, fields.theta, angle, fields.noise, h, fields.cuts},
        coefficients<double>(grid, parameters, options.laplacian, h, fields.orientation), taken,
        steps);
  }

  void Growth::advance_in_single(const Fields &fields, double h, long steps)
  {
    const auto copy = [this](const Field<double> *from, Field<float> &to) -> Field<float> *
    {
      if (!from)
        return nullptr;
      if (to.empty())
        to = Field<float>(grid);
      convert(*from, to);
      return &to;
    };
    Field<float> *phi = copy(fields.phi, copies.phi), *theta = copy(fields.theta, copies.theta);
    AngleFields<float> angle;
    if (fields.orientation && fields.orientation->varying())
      angle = {copy(&fields.orientation->cosine, copies.cosine),
               copy(&fields.orientation->sine, copies.sine)};
    std::get<Sweep<float>>(sweep).run(
        {phi, theta, angle, fields.noise, h, fields.cuts},
        coefficients<float>(grid, parameters, options.laplacian, h, fields.orientation), taken,
        steps);
    if (phi)
      convert(*phi, *fields.phi);
    if (theta)
      convert(*theta, *fields.theta);
  }

  const medium::Tiles &Growth::tiles() const
  {
    return std::visit([](const auto &s) -> const medium::Tiles & { return s.tiles(); }, sweep);
  }

  std::size_t Growth::bytes() const
  {
    return std::visit([](const auto &s) { return s.bytes(); }, sweep) + copies.phi.bytes() +
           copies.theta.bytes() + copies.cosine.bytes() + copies.sine.bytes();
  }
} // namespace melt
