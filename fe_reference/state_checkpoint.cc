#include "state_checkpoint.h"

#include <algorithm>
#include <stdexcept>

#include "point_numbers.h"

namespace fe
{
  namespace
  {
    void write(const std::string &path, const scene::Scene &scene, const State &state,
               const std::vector<double> &points, const Pace &pace, const Folding &folding)
    {
      record::CheckpointFile checkpoint(path, scene);
      checkpoint.put("time", state.time);
      checkpoint.put("smallest_jacobian", state.smallest_jacobian);
      checkpoint.put("force_scale", state.force_scale);
      checkpoint.put("u", state.u);
      checkpoint.put("internal", state.internal);
      checkpoint.put("external", state.external);
      checkpoint.put("points", points);
      checkpoint.put("velocity", pace.velocity);
      checkpoint.put("pace", std::vector<double>{pace.increment, double(pace.easy),
                                                 double(pace.steps), double(pace.retries),
                                                 double(pace.iterations), pace.energies.external,
                                                 pace.energies.elastic, pace.energies.plastic});
      checkpoint.put("folding", std::vector<double>{folding.last_valid, folding.time,
                                                    static_cast<double>(folding.cell)});
      checkpoint.finish();
    }
  } // namespace

  void save(const std::string &path, const scene::Scene &scene, const Problem &problem,
            const State &state, const Pace &pace, const Folding &folding)
  {
    const std::vector<double> points = whole_points(problem.mesh, state.points);
    on_first_process([&] { write(path, scene, state, points, pace, folding); });
  }

  Saved load(const std::string &path, const scene::Scene &scene, const Problem &problem)
  {
    const record::Checkpoint checkpoint = record::Checkpoint::load(path, scene);
    Saved saved;
    State &state = saved.state;
    state.time = checkpoint.number("time");
    state.smallest_jacobian = checkpoint.number("smallest_jacobian");
    state.force_scale = checkpoint.number("force_scale");
    state.u = checkpoint.get<double>("u");
    state.internal = checkpoint.get<double>("internal");
    state.external = checkpoint.get<double>("external");
    state.points = points_from(checkpoint.get<double>("points"));
    const Discretisation &d = problem.mesh;
    if (static_cast<int>(state.u.size()) != d.unknowns() ||
        static_cast<int>(state.points.size()) != d.cells * d.points_per_cell)
      throw std::runtime_error(path + ": made on another mesh; start afresh with --force");
    Pace &pace = saved.pace;
    pace.velocity = checkpoint.get<double>("velocity");
    const std::vector<double> &numbers = checkpoint.get<double>("pace");
    pace.increment = numbers.at(0);
    pace.easy = static_cast<int>(numbers.at(1));
    pace.steps = static_cast<int>(numbers.at(2));
    pace.retries = static_cast<int>(numbers.at(3));
    pace.iterations = static_cast<int>(numbers.at(4));
    pace.energies = {numbers.at(5), numbers.at(6), numbers.at(7)};
    const std::vector<double> &folding = checkpoint.get<double>("folding");
    saved.folding = {folding.at(0), folding.at(1), static_cast<int>(folding.at(2))};
    return saved;
  }
} // namespace fe
