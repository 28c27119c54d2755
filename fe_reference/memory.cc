#include "memory.h"

#include "library.h"

namespace fe
{
  namespace
  {
    template <class T>
    double held(const std::vector<T> &values)
    {
      return static_cast<double>(values.capacity() * sizeof(T));
    }

    double mesh_bytes(const Discretisation &d)
    {
      return held(d.position) + held(d.cell_node) + held(d.gradient) + held(d.weight) +
             held(d.mode) + held(d.shape) + held(d.unit_point) + held(d.unit_node) + held(d.owned) +
             held(d.touched) + held(d.boundary) +
             static_cast<double>(d.library->triangulation.memory_consumption() +
                                 d.library->handler.memory_consumption());
    }

    /// Of one equilibrium: displacement, two vectors of forces, and the points of all cells.
    double state_bytes(const Discretisation &d)
    {
      return 3. * 8. * d.unknowns() +
             static_cast<double>(d.cells * d.points_per_cell) * sizeof(PointState);
    }
  } // namespace

  std::map<std::string, double> memory(const Problem &problem, const LinearSystem &system)
  {
    // The last equilibrium, the one that is tried, and the best try of a line search; beside them
    // velocity, correction, jump and residual.
    const double vectors = 4. * 8. * problem.mesh.unknowns();
    return {{"mesh", mesh_bytes(problem.mesh)},
            {"states", 3. * state_bytes(problem.mesh) + vectors},
            {"tangent", system.matrix_bytes()},
            {"factors", system.factor_bytes()}};
  }
} // namespace fe
