// Elements, nodes and integration tables on the initial mesh, made by deal.II once and then plain.
//
// deal.II numbers and partitions a scalar Lagrange space FE_Q(degree); node n carries the two
// displacements 2n and 2n + 1. Every process holds the whole mesh (parallel::shared) and works on
// the cells it owns; displacement vectors are small in two dimensions and are kept whole
// everywhere, so that probes see one body whatever the number of processes.
#pragma once

#include <memory>
#include <vector>

#include "mesh.h"

namespace fe
{
  /// A side of the outline: the cell it belongs to and its nodes, first to last counter-clockwise
  /// around the material (2 nodes for degree 1, 3 for degree 2).
  struct BoundarySide
  {
    int cell = 0;
    std::array<int, 3> node{};
  };

  struct Discretisation
  {
    int degree = 0, nodes_per_cell = 0, points_per_cell = 0, modes = 0;
    int cells = 0, nodes = 0;
    std::vector<Point> position;   // nodes, initial
    std::vector<int> cell_node;    // cells x nodes_per_cell
    std::vector<double> gradient;  // cells x points x nodes x 2, d/dX
    std::vector<double> weight;    // cells x points, initial area
    std::vector<double> mode;      // cells x points x modes, see element.h
    std::vector<double> shape;     // points x nodes (the same in every cell)
    std::vector<Point> unit_point; // points, in the unit square
    std::vector<Point> unit_node;  // nodes_per_cell, in the unit square
    std::vector<char> owned;       // cells: by this process
    std::vector<char> touched;     // cells: with a node of this process, and the owned ones
    std::vector<BoundarySide> boundary;

    struct Library; // deal.II objects that the linear system needs
    std::shared_ptr<const Library> library;

    const int *nodes_of(const int cell) const { return cell_node.data() + cell * nodes_per_cell; }
    int unknowns() const { return 2 * nodes; }
  };

  /// Throws std::runtime_error for a mesh that deal.II rejects (a cell of no area), and for a
  /// degree other than 1 or 2.
  Discretisation discretise(const QuadMesh &, int degree);

  /// Values (nodes_per_cell) and unit-square gradients (nodes_per_cell x 2) of the shape functions
  /// of a cell at `unit`; either may be null.
  void shape_functions(int degree, const std::vector<Point> &unit_nodes, const Point &unit,
                       double *value, double *gradient);
} // namespace fe
