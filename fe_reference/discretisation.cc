#include "discretisation.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "library.h"

namespace fe
{
  namespace
  {
    void create(dealii::parallel::shared::Triangulation<2> &triangulation, const QuadMesh &mesh)
    {
      std::vector<dealii::Point<2>> vertices;
      for (const Point &p : mesh.vertices)
        vertices.emplace_back(p[0], p[1]);
      std::vector<dealii::CellData<2>> cells(mesh.cells.size(), dealii::CellData<2>(4));
      for (std::size_t c = 0; c < cells.size(); ++c)
      {
        // deal.II counts lexicographically: lower left, lower right, upper left, upper right.
        const auto &v = mesh.cells[c];
        const std::array<int, 4> order{v[0], v[1], v[3], v[2]};
        for (int k = 0; k < 4; ++k)
          cells[c].vertices[k] = static_cast<unsigned int>(order[k]);
      }
      dealii::GridTools::consistently_order_cells(cells);
      triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
    }

    // Monomials 1 (and X, Y about the centre), made orthonormal in the weights of the cell.
    void make_modes(Discretisation &d, const int cell, const std::vector<Point> &points)
    {
      const double *weight = d.weight.data() + cell * d.points_per_cell;
      double *mode = d.mode.data() + cell * d.points_per_cell * d.modes;
      Point centre = Point::Zero();
      double area = 0.;
      for (int q = 0; q < d.points_per_cell; ++q)
      {
        centre += weight[q] * points[q];
        area += weight[q];
      }
      centre /= area;
      const double length = std::sqrt(area);
      for (int m = 0; m < d.modes; ++m)
      {
        for (int q = 0; q < d.points_per_cell; ++q)
          mode[q * d.modes + m] = m == 0 ? 1. : (points[q][m - 1] - centre[m - 1]) / length;
        for (int n = 0; n <= m; ++n) // n == m: normalise
        {
          double product = 0.;
          for (int q = 0; q < d.points_per_cell; ++q)
            product += weight[q] * mode[q * d.modes + m] * mode[q * d.modes + n];
          for (int q = 0; q < d.points_per_cell; ++q)
            if (n < m)
              mode[q * d.modes + m] -= product * mode[q * d.modes + n];
            else
              mode[q * d.modes + m] /= std::sqrt(product);
        }
      }
    }

    void resize(Discretisation &d)
    {
      const std::size_t cells = d.cells, points = cells * d.points_per_cell;
      d.cell_node.resize(cells * d.nodes_per_cell);
      d.gradient.resize(points * d.nodes_per_cell * 2);
      d.weight.resize(points);
      d.mode.resize(points * d.modes);
      d.owned.resize(cells);
      d.touched.resize(cells);
      d.position.resize(d.nodes);
    }

    void tabulate_unit_cell(Discretisation &d, const dealii::FE_Q<2> &space,
                            const dealii::Quadrature<2> &quadrature)
    {
      for (const auto &p : space.get_unit_support_points())
        d.unit_node.emplace_back(p[0], p[1]);
      for (int q = 0; q < d.points_per_cell; ++q)
      {
        d.unit_point.emplace_back(quadrature.point(q)[0], quadrature.point(q)[1]);
        for (int a = 0; a < d.nodes_per_cell; ++a)
          d.shape.push_back(space.shape_value(a, quadrature.point(q)));
      }
    }

    // Nodes of side `face` of a cell in the order of the unit square, turned counter-clockwise.
    BoundarySide side_of(const Discretisation &d, const dealii::FE_Q<2> &space, const int cell,
                         const unsigned int face)
    {
      BoundarySide side;
      side.cell = cell;
      const int count = d.degree + 1;
      for (int k = 0; k < count; ++k)
      {
        // face numbering: the two vertices first, then what lies between.
        const int slot = k == 0 ? 0 : (k == 1 ? count - 1 : k - 1);
        side.node[slot] = d.nodes_of(cell)[space.face_to_cell_index(k, face)];
      }
      // deal.II's faces run along +x or +y: left (0) and top (3) run clockwise.
      if (face == 0 || face == 3)
        std::reverse(side.node.begin(), side.node.begin() + count);
      return side;
    }
  } // namespace

  Discretisation discretise(const QuadMesh &mesh, const int degree)
  {
    if (degree != 1 && degree != 2)
      throw std::runtime_error("fe.degree: read " + std::to_string(degree) +
                               ", allowed are 1 (Q1/P0) and 2 (Q2/P-1)");
    const auto library = std::make_shared<Discretisation::Library>(degree);
    create(library->triangulation, mesh);
    library->handler.distribute_dofs(library->space);
    const dealii::QGauss<2> quadrature(degree + 1);

    Discretisation d;
    d.degree = degree;
    d.nodes_per_cell = static_cast<int>(library->space.n_dofs_per_cell());
    d.points_per_cell = static_cast<int>(quadrature.size());
    d.modes = degree == 1 ? 1 : 3;
    d.cells = static_cast<int>(library->triangulation.n_active_cells());
    d.nodes = static_cast<int>(library->handler.n_dofs());
    resize(d);
    tabulate_unit_cell(d, library->space, quadrature);

    const dealii::MappingQ1<2> mapping;
    dealii::FEValues<2> values(mapping, library->space, quadrature,
                               dealii::update_gradients | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
    const dealii::Quadrature<2> at_nodes(library->space.get_unit_support_points());
    dealii::FEValues<2> node_values(mapping, library->space, at_nodes,
                                    dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> indices(d.nodes_per_cell);
    for (const auto &cell : library->handler.active_cell_iterators())
    {
      const int c = static_cast<int>(cell->active_cell_index());
      values.reinit(cell);
      node_values.reinit(cell);
      cell->get_dof_indices(indices);
      d.owned[c] = d.touched[c] = cell->is_locally_owned();
      for (int a = 0; a < d.nodes_per_cell; ++a)
      {
        d.cell_node[c * d.nodes_per_cell + a] = static_cast<int>(indices[a]);
        d.touched[c] |= library->handler.locally_owned_dofs().is_element(indices[a]);
        const auto &p = node_values.quadrature_point(a);
        d.position[indices[a]] = Point(p[0], p[1]);
      }
      std::vector<Point> points;
      for (int q = 0; q < d.points_per_cell; ++q)
      {
        const int k = c * d.points_per_cell + q;
        d.weight[k] = values.JxW(q);
        points.emplace_back(values.quadrature_point(q)[0], values.quadrature_point(q)[1]);
        for (int a = 0; a < d.nodes_per_cell; ++a)
          for (int j = 0; j < 2; ++j)
            d.gradient[(k * d.nodes_per_cell + a) * 2 + j] = values.shape_grad(a, q)[j];
      }
      make_modes(d, c, points);
      for (const unsigned int face : cell->face_indices())
        if (cell->at_boundary(face))
          d.boundary.push_back(side_of(d, library->space, c, face));
    }
    d.library = library;
    return d;
  }

  void shape_functions(const int degree, const std::vector<Point> &unit_nodes, const Point &unit,
                       double *value, double *gradient)
  {
    // One-dimensional Lagrange polynomials on 0, (1/2,) 1 and their slopes, at both coordinates.
    double polynomial[2][3] = {}, slope[2][3] = {};
    for (int d = 0; d < 2; ++d)
    {
      const double s = unit[d];
      if (degree == 1)
      {
        polynomial[d][0] = 1. - s, polynomial[d][2] = s;
        slope[d][0] = -1., slope[d][2] = 1.;
      }
      else
      {
        polynomial[d][0] = (2. * s - 1.) * (s - 1.), slope[d][0] = 4. * s - 3.;
        polynomial[d][1] = 4. * s * (1. - s), slope[d][1] = 4. - 8. * s;
        polynomial[d][2] = s * (2. * s - 1.), slope[d][2] = 4. * s - 1.;
      }
    }
    for (std::size_t a = 0; a < unit_nodes.size(); ++a)
    {
      const int i = static_cast<int>(std::lround(2. * unit_nodes[a][0]));
      const int j = static_cast<int>(std::lround(2. * unit_nodes[a][1]));
      if (value)
        value[a] = polynomial[0][i] * polynomial[1][j];
      if (gradient)
      {
        gradient[2 * a] = slope[0][i] * polynomial[1][j];
        gradient[2 * a + 1] = polynomial[0][i] * slope[1][j];
      }
    }
  }
} // namespace fe
