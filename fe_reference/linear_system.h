// The linear system of one Newton iteration: a sparse matrix in Trilinos and a direct solver.
//
// The tangent of a Jaumann solid is not symmetric and near a limit load nearly singular, so it is
// factorised (MUMPS through Trilinos' Amesos; KLU where MUMPS is not built). The sparsity pattern
// never changes: ordering and symbolic factorisation are done once. Held unknowns keep their rows,
// reduced to the diagonal.
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "discretisation.h"
#include "processes.h"

namespace fe
{
  /// The factors do not fit: nothing is wrong with the tangent.
  struct OutOfMemory : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  class LinearSystem
  {
  public:
    explicit LinearSystem(const Discretisation &);
    ~LinearSystem();
    LinearSystem(const LinearSystem &) = delete;
    LinearSystem &operator=(const LinearSystem &) = delete;

    void clear();
    /// Add the matrix (unknowns^2, row-major, node by node) of a touched cell to the rows that this
    /// process owns: every process evaluates all cells that touch its rows, matrices are never
    /// sent.
    void add(int cell, const double *matrix);

    /// Factorise and solve; `right_side` and the result are whole on every process. Throws
    /// std::runtime_error if the matrix is singular to working precision.
    std::vector<double> solve(const std::vector<double> &right_side);

    /// Sign of the determinant of the last matrix solved: -1 where an odd number of its eigenvalues
    /// is negative, so that the equilibrium is unstable; 0 where the solver does not tell (KLU).
    int determinant_sign() const;

    /// Cost so far of factorisations and solutions, and their number.
    double factorisation_seconds() const;
    double factorisation_cpu_seconds() const;
    long factorisations() const;
    const char *solver_name() const;

    /// Bytes that this process holds for the matrix with its slots and vectors, and for the
    /// factorisation (0 before the first solution; of KLU only what it is given).
    double matrix_bytes() const;
    double factor_bytes() const;

  private:
    struct Trilinos;
    std::unique_ptr<Trilinos> trilinos;
  };
} // namespace fe
