// The deal.II objects behind a Discretisation; only the files that talk to deal.II include this.
#pragma once

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>

#include "discretisation.h"

namespace fe
{
  struct Discretisation::Library
  {
    explicit Library(const int degree)
        : triangulation(MPI_COMM_WORLD, dealii::Triangulation<2>::none, false,
                        dealii::parallel::shared::Triangulation<2>::partition_metis),
          space(degree), handler(triangulation)
    {
    }
    dealii::parallel::shared::Triangulation<2> triangulation;
    dealii::FE_Q<2> space;
    dealii::DoFHandler<2> handler;
  };
} // namespace fe
