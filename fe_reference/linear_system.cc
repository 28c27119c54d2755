#include "linear_system.h"

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Amesos_Mumps.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <stdexcept>
#include <unordered_map>

#include "library.h"
#include "record/stopwatch.h"

namespace fe
{
  struct LinearSystem::Trilinos
  {
    int unknowns_per_cell = 0;
    std::vector<int> first_slot; // cells: -1 if not touched
    std::vector<double *> slot;  // into the rows of the matrix; null: another process owns the row
    dealii::TrilinosWrappers::SparseMatrix matrix;
    dealii::TrilinosWrappers::MPI::Vector right_side, solution;
    std::vector<int> owned;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver> solver;
    const char *name = "";
    record::Profile::Part cost;
    bool ordered = false;

    Epetra_CrsMatrix &epetra() { return const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix()); }
    void make_matrix(const Discretisation &);
    void make_slots(const Discretisation &);
    void make_solver();
  };

  void LinearSystem::Trilinos::make_matrix(const Discretisation &d)
  {
    const dealii::IndexSet nodes = d.library->handler.locally_owned_dofs();
    dealii::IndexSet rows(d.unknowns());
    for (const auto node : nodes)
    {
      rows.add_range(2 * node, 2 * node + 2);
      owned.push_back(static_cast<int>(2 * node));
      owned.push_back(static_cast<int>(2 * node + 1));
    }
    rows.compress();
    dealii::DynamicSparsityPattern pattern(d.unknowns(), d.unknowns(), rows);
    std::vector<dealii::types::global_dof_index> indices(unknowns_per_cell);
    for (int c = 0; c < d.cells; ++c)
    {
      for (int k = 0; k < unknowns_per_cell; ++k)
        indices[k] = 2 * d.nodes_of(c)[k / 2] + k % 2;
      for (const auto row : indices)
        if (rows.is_element(row))
          pattern.add_entries(row, indices.begin(), indices.end());
    }
    matrix.reinit(rows, rows, pattern, MPI_COMM_WORLD);
    right_side.reinit(rows, MPI_COMM_WORLD);
    solution.reinit(rows, MPI_COMM_WORLD);
  }

  void LinearSystem::Trilinos::make_slots(const Discretisation &d)
  {
    Epetra_CrsMatrix &epetra_matrix = epetra();
    std::vector<std::unordered_map<int, double *>> entry(epetra_matrix.NumMyRows());
    for (int row = 0; row < epetra_matrix.NumMyRows(); ++row)
    {
      int count = 0, *column = nullptr;
      double *value = nullptr;
      epetra_matrix.ExtractMyRowView(row, count, value, column);
      for (int k = 0; k < count; ++k)
        entry[row].emplace(epetra_matrix.GCID(column[k]), value + k);
    }
    first_slot.assign(d.cells, -1);
    for (int c = 0; c < d.cells; ++c)
    {
      const auto unknown = [&](const int k) { return 2 * d.nodes_of(c)[k / 2] + k % 2; };
      if (!d.touched[c])
        continue;
      first_slot[c] = static_cast<int>(slot.size());
      for (int i = 0; i < unknowns_per_cell; ++i)
      {
        const int row = epetra_matrix.LRID(unknown(i));
        for (int j = 0; j < unknowns_per_cell; ++j)
          slot.push_back(row < 0 ? nullptr : entry[row].at(unknown(j)));
      }
    }
  }

  void LinearSystem::Trilinos::make_solver()
  {
    problem = std::make_unique<Epetra_LinearProblem>(&epetra(), &solution.trilinos_vector(),
                                                     &right_side.trilinos_vector());
    Amesos factory;
    for (const char *candidate : {"Amesos_Mumps", "Amesos_Klu"})
      if (factory.Query(candidate))
      {
        name = candidate;
        solver.reset(factory.Create(candidate, *problem));
        break;
      }
    if (!solver)
      throw std::runtime_error("this Trilinos has neither MUMPS nor KLU; install a Trilinos with "
                               "one of them");
    Teuchos::ParameterList parameters;
    parameters.set("OutputLevel", 0);
    parameters.set("PrintTiming", false);
    parameters.set("PrintStatus", false);
    Teuchos::ParameterList &mumps = parameters.sublist("mumps");
    mumps.set("ICNTL(14)", 60); // per cent of spare workspace for pivots that move
    mumps.set("ICNTL(8)", 0);   // rows and columns are of one scale already
    mumps.set("ICNTL(33)", 1);  // the determinant, from the pivots
    solver->SetParameters(parameters);
  }

  namespace
  {
    // INFO(1) of MUMPS' manual: these say that memory is short.
    void complain(Amesos_BaseSolver &solver, const char *otherwise)
    {
      if (auto *mumps = dynamic_cast<Amesos_Mumps *>(&solver))
      {
        const int code = mumps->GetINFO()[0], global = mumps->GetINFOG()[0];
        for (const int short_of_memory : {-7, -13, -19})
          if (code == short_of_memory || global == short_of_memory)
            throw OutOfMemory("MUMPS ran out of memory for the factors of the tangent (its code " +
                              std::to_string(short_of_memory) + ")");
      }
      throw std::runtime_error(otherwise);
    }
  } // namespace

  LinearSystem::LinearSystem(const Discretisation &d) : trilinos(std::make_unique<Trilinos>())
  {
    trilinos->unknowns_per_cell = 2 * d.nodes_per_cell;
    trilinos->make_matrix(d);
    trilinos->make_slots(d);
    trilinos->make_solver();
  }

  LinearSystem::~LinearSystem() = default;

  void LinearSystem::clear()
  {
    trilinos->epetra().PutScalar(0.);
  }

  void LinearSystem::add(const int cell, const double *matrix)
  {
    double *const *slot = trilinos->slot.data() + trilinos->first_slot[cell];
    const int entries = trilinos->unknowns_per_cell * trilinos->unknowns_per_cell;
    for (int k = 0; k < entries; ++k)
      if (slot[k])
        *slot[k] += matrix[k];
  }

  std::vector<double> LinearSystem::solve(const std::vector<double> &right_side)
  {
    const record::Stopwatch stopwatch;
    Trilinos &t = *trilinos;
    Epetra_MultiVector &b = t.right_side.trilinos_vector(), &x = t.solution.trilinos_vector();
    for (std::size_t k = 0; k < t.owned.size(); ++k)
      b[0][k] = right_side[t.owned[k]];
    if (!t.ordered)
    {
      if (t.solver->SymbolicFactorization() != 0)
        complain(*t.solver, "the ordering of the tangent failed");
      t.ordered = true;
    }
    if (t.solver->NumericFactorization() != 0 || t.solver->Solve() != 0)
      complain(*t.solver, "the tangent is singular");
    std::vector<double> result(right_side.size(), 0.);
    for (std::size_t k = 0; k < t.owned.size(); ++k)
      result[t.owned[k]] = x[0][k];
    sum_over_processes(result);
    stopwatch.add_to(t.cost);
    return result;
  }

  int LinearSystem::determinant_sign() const
  {
    auto *const mumps = dynamic_cast<Amesos_Mumps *>(trilinos->solver.get());
    if (!mumps || trilinos->cost.calls == 0)
      return 0;
    const double mantissa = mumps->GetRINFOG()[11]; // RINFOG(12) of MUMPS' manual
    return mantissa > 0. ? 1 : mantissa < 0. ? -1 : 0;
  }

  double LinearSystem::factorisation_seconds() const
  {
    return trilinos->cost.wall_s;
  }
  double LinearSystem::factorisation_cpu_seconds() const
  {
    return trilinos->cost.cpu_s;
  }
  long LinearSystem::factorisations() const
  {
    return trilinos->cost.calls;
  }
  const char *LinearSystem::solver_name() const
  {
    return trilinos->name;
  }

  double LinearSystem::matrix_bytes() const
  {
    const Trilinos &t = *trilinos;
    return static_cast<double>(t.matrix.memory_consumption() + t.right_side.memory_consumption() +
                               t.solution.memory_consumption() +
                               t.slot.capacity() * sizeof(double *) +
                               (t.first_slot.capacity() + t.owned.capacity()) * sizeof(int));
  }

  double LinearSystem::factor_bytes() const
  {
    if (!trilinos->ordered)
      return 0.;
    const double triplets = 16. * static_cast<double>(trilinos->matrix.n_nonzero_elements());
    auto *mumps = dynamic_cast<Amesos_Mumps *>(trilinos->solver.get());
    if (!mumps)
      return triplets;
    // INFO of MUMPS' manual, there counted from 1; negative numbers are millions.
    const auto count = [mumps](const int number)
    {
      const double entries = mumps->GetINFO()[number - 1];
      return entries < 0. ? -1e6 * entries : entries;
    };
    const double reals = count(39), integers = count(10); // workspace allocated; of the factors
    return triplets + sizeof(double) * reals + sizeof(int) * integers;
  }
} // namespace fe
