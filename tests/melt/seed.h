// A seed in an undercooled melt, as the tests of growth begin.
#pragma once

#include <cmath>

#include "melt/growth.h"

namespace test
{
  using medium::Boundary;
  using medium::Field;
  using medium::Mesh;
  using medium::Point;

  inline Mesh square_mesh(int nodes, double spacing, Boundary all)
  {
    Mesh mesh;
    mesh.nodes = {nodes, nodes};
    mesh.spacing = {spacing, spacing};
    mesh.boundary = {all, all, all, all};
    return mesh;
  }

  /// The paper's law: W0 = tau0 = 1, d0 = 0.185, D = 3.
  inline melt::Law paper_law(double anisotropy)
  {
    return {1., 1., anisotropy, melt::coupling_constant(0.185, 1.), 3.};
  }

  struct Melt
  {
    Field<double> phi, theta;
    melt::Growth::Fields fields(const melt::Orientation *orientation = nullptr,
                                const melt::Noise *noise = nullptr)
    {
      return {&phi, &theta, orientation, noise};
    }
  };

  inline Melt seeded(const Mesh &mesh, const Point &centre, double radius, double undercooling)
  {
    Melt melt{Field<double>(mesh), Field<double>(mesh, -undercooling)};
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        melt.phi(i, j) =
            std::tanh((radius - (mesh.position(i, j) - centre).norm()) / std::sqrt(2.));
    return melt;
  }

  template <class Value>
  double largest_difference(const Field<double> &a, const Value &b, const Mesh &mesh)
  {
    double largest = 0.;
    for (int j = 0; j < mesh.nodes[1]; ++j)
      for (int i = 0; i < mesh.nodes[0]; ++i)
        largest = std::max(largest, std::abs(a(i, j) - b(i, j)));
    return largest;
  }
} // namespace test
