#include "findings.h"

#include <iostream>

namespace fe
{
  namespace
  {
    void tell_of_folding(record::Writer &writer, const Problem &problem, const Observer &observer)
    {
      writer.attribute("folded_cells", static_cast<double>(observer.folded_cells_at_end()));
      writer.attribute("first_folding", observer.first_folding());
      if (!observer.first_folding().empty())
        std::cerr << "fe_reference: the mesh folds at a node from " << observer.first_folding()
                  << "; " << observer.folded_cells_at_end() << " of " << problem.mesh.cells
                  << " cells are marked invalid at the end\n";
    }

    void tell_of_overlap(record::Writer &writer, Observer &observer, const State &last)
    {
      const std::string where = observer.self_overlap(last);
      if (where.empty())
        return;
      writer.attribute("self_overlap", where);
      std::cerr << "fe_reference: the body lies in itself at the end, " << where
                << ": there is no contact here, and nothing holds it apart\n";
    }

    void tell_of_instability(record::Writer &writer, const double since)
    {
      writer.attribute("unstable_since", since);
      std::cerr << "fe_reference: the equilibria from t = " << since
                << " on are unstable: a bifurcation or a limit point has been passed, beyond which "
                   "this is one of several; lead it with a small imperfection\n";
    }
  } // namespace

  void write_findings(record::Writer &writer, const Problem &problem, Observer &observer,
                      const Outcome &outcome, const double end)
  {
    writer.attribute("largest_load_factor", outcome.last.time / end);
    writer.attribute("largest_valid_load_factor", observer.folding().last_valid / end);
    writer.attribute("smallest_jacobian", outcome.last.smallest_jacobian);
    writer.attribute("smallest_nodal_jacobian", observer.smallest_nodal_jacobian());
    tell_of_folding(writer, problem, observer);
    tell_of_overlap(writer, observer, outcome.last);
    if (outcome.unstable_since)
      tell_of_instability(writer, *outcome.unstable_since);
  }
} // namespace fe
