#include "state_checkpoint.h"

#include <algorithm>
#include <stdexcept>

#include "point_numbers.h"

namespace fe
{
  namespace
  {
    void write(const std::string &path, const scene::Scene &scene, const StateToSave &saved,
               const std::vector<double> &points)
    {
      const auto &[state, stepping, folding, spent] = saved;
      record::CheckpointFile checkpoint(path, scene);
      checkpoint.put("time", state.time);
      checkpoint.put("smallest_jacobian", state.smallest_jacobian);
      checkpoint.put("force_scale", state.force_scale);
      checkpoint.put("u", state.u);
      checkpoint.put("internal", state.internal);
      checkpoint.put("external", state.external);
      checkpoint.put("points", points);
      checkpoint.put("velocity", stepping.velocity);
      checkpoint.put("pace",
                     std::vector<double>{stepping.increment, double(stepping.easy_increments),
                                         double(stepping.steps), double(stepping.retries),
                                         double(stepping.iterations), stepping.energies.external,
                                         stepping.energies.elastic, stepping.energies.plastic});
      checkpoint.put("folding", std::vector<double>{folding.last_valid, folding.time,
                                                    static_cast<double>(folding.cell)});
      record::save(spent, checkpoint);
      checkpoint.finish();
    }
  } // namespace

  void save(const std::string &path, const scene::Scene &scene, const Problem &problem,
            const StateToSave &saved)
  {
    const std::vector<double> points = gather_points(problem.mesh, saved.state.points);
    on_first_process([&] { write(path, scene, saved, points); });
  }

  SavedState load(const std::string &path, const scene::Scene &scene, const Problem &problem,
                  record::RunCost &cost)
  {
    const record::Checkpoint checkpoint = record::Checkpoint::load(path, scene);
    SavedState saved;
    State &state = saved.state;
    state.time = checkpoint.number("time");
    state.smallest_jacobian = checkpoint.number("smallest_jacobian");
    state.force_scale = checkpoint.number("force_scale");
    state.u = checkpoint.get<double>("u");
    state.internal = checkpoint.get<double>("internal");
    state.external = checkpoint.get<double>("external");
    state.points = unpack_points(checkpoint.get<double>("points"));
    const Discretisation &d = problem.mesh;
    if (static_cast<int>(state.u.size()) != d.unknowns() ||
        static_cast<int>(state.points.size()) != d.cells * d.points_per_cell)
      throw std::runtime_error(path + ": made on another mesh; start afresh with --force");
    cost.resume(checkpoint);
    SteppingState &stepping = saved.stepping;
    stepping.velocity = checkpoint.get<double>("velocity");
    const std::vector<double> &numbers = checkpoint.get<double>("pace");
    stepping.increment = numbers.at(0);
    stepping.easy_increments = static_cast<int>(numbers.at(1));
    stepping.steps = static_cast<int>(numbers.at(2));
    stepping.retries = static_cast<int>(numbers.at(3));
    stepping.iterations = static_cast<int>(numbers.at(4));
    stepping.energies = {numbers.at(5), numbers.at(6), numbers.at(7)};
    const std::vector<double> &folding = checkpoint.get<double>("folding");
    saved.folding = {folding.at(0), folding.at(1), static_cast<int>(folding.at(2))};
    return saved;
  }
} // namespace fe
