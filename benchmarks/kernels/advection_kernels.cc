// Advection of one field on 800 x 800 nodes, and the distance in its band.
#include <cmath>
#include <memory>

#include "kernels.h"
#include "medium/advection.h"
#include "medium/distance.h"

namespace kernels
{
  namespace
  {
    struct Carried
    {
      medium::Field<double> f;
      medium::Gradients gradients;
      medium::Velocity velocity;
      std::unique_ptr<medium::Advection> advection;
    };

    medium::Field<double> disc(const medium::Mesh &mesh, double radius)
    {
      medium::Field<double> phi(mesh);
      const medium::Point middle = mesh.position(mesh.nodes[0] / 2, mesh.nodes[1] / 2);
      for (int j = 0; j < mesh.nodes[1]; ++j)
        for (int i = 0; i < mesh.nodes[0]; ++i)
          phi(i, j) = std::tanh((radius - (mesh.position(i, j) - middle).norm()) / std::sqrt(2.));
      medium::fill_ghosts(phi, mesh);
      return phi;
    }

    std::function<void()> carrying(scene::AdvectionScheme scheme)
    {
      const medium::Mesh mesh = mesh_of(800, 800);
      auto carried = std::make_shared<Carried>();
      carried->f = disc(mesh, 60.);
      carried->velocity = medium::Velocity(mesh);
      for (int j = -3; j < 803; ++j)
        for (int i = -3; i < 803; ++i)
        {
          carried->velocity.x(i, j) = -(j - 400) / 400.;
          carried->velocity.y(i, j) = (i - 400) / 400.;
        }
      carried->advection = std::make_unique<medium::Advection>(mesh, scheme);
      return [carried]
      { carried->advection->advect(carried->f, carried->gradients, carried->velocity, 0.05); };
    }
  } // namespace

  void add_advection_kernels()
  {
    using scene::AdvectionScheme;
    constexpr double nodes = 800. * 800.;
    add("advection, cip", {nodes, 12., 7.}, [] { return carrying(AdvectionScheme::cip); });
    add("advection, cip_hermite", {nodes, 24., 14.},
        [] { return carrying(AdvectionScheme::cip_hermite); });
    add("advection, weno5", {nodes, 60., 30.}, [] { return carrying(AdvectionScheme::weno5); });
    constexpr double radius = 60., cells = 12.;
    const double band = 2. * M_PI * radius * 2. * cells / 0.4; // nodes of the band
    const auto measuring = [=](bool afresh)
    {
      const medium::Mesh mesh = mesh_of(800, 800);
      auto phi = std::make_shared<medium::Field<double>>(disc(mesh, radius));
      auto distance = std::make_shared<medium::Distance>(mesh, cells);
      medium::compute_distance(*distance, *phi, mesh);
      return [=]
      {
        afresh ? medium::compute_distance(*distance, *phi, mesh)
               : medium::update_distance(*distance, *phi, mesh);
      };
    };
    // Whole measurements. A differential equation would need some fifty iterations instead.
    add("distance, followed", {band, 60., 12.}, [=] { return measuring(false); });
    add("distance, afresh on 800 x 800", {band, 120., 60.}, [=] { return measuring(true); });
  }
} // namespace kernels
