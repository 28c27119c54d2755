#include "run.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "banner.h"
#include "findings.h"
#include "memory.h"
#include "observer.h"
#include "plan.h"
#include "record/cannot_write.h"
#include "record/progress.h"
#include "record/run_cost.h"
#include "scene/value.h"
#include "state_checkpoint.h"
#include "versions.h"

namespace fe
{
  namespace
  {
    constexpr double seconds_between_checkpoints = 300.;
    constexpr double seconds_between_flushes = 60.; // so long a row may wait to be seen
    // Of the cells: those at singular corners fold long before the rest of the mesh does.
    constexpr double overlooked_folds = 0.01;

    Problem make_problem(const scene::Scene &scene, const QuadMesh &mesh, const int threads)
    {
      const scene::Fe settings = scene.fe.value_or(scene::Fe{});
      Problem problem;
      problem.mesh = discretise(mesh, settings.degree);
      problem.material = make_material(scene.solid->young_modulus, scene.solid->poisson_ratio);
      problem.material.yield_stress = scene.solid->yield_stress;
      problem.material.viscosity = scene.solid->viscosity.value_or(0.);
      problem.material.density = scene.solid->density;
      problem.supports = make_supports(scene, problem.mesh);
      problem.loads = make_loads(scene, problem.mesh);
      problem.tolerance = settings.tolerance;
      problem.threads = threads;
      return problem;
    }

    std::string pins(const Problem &problem)
    {
      return problem.supports.pinned.empty()
                 ? ""
                 : "  pinned   nothing holds the body in " + problem.supports.pinned +
                       ": its middle stays where it is in that direction\n";
    }

    // A coarse mesh of a fine outline leaves corners out: said, since nothing else shows it.
    std::string missing_area(const scene::Scene &scene, const QuadMesh &mesh)
    {
      const double ratio = filled_fraction(scene, mesh);
      return std::abs(ratio - 1.) < 1e-3
                 ? ""
                 : "  mesh     has " + scene::number_text(1e-3 * std::round(1e5 * ratio)) +
                       " % of the bodies' area; finer [fe] cells come nearer\n";
    }

    // Everything of one run that outlives its functions.
    struct Run
    {
      const scene::Scene &scene;
      const record::CommandLine &command;
      record::RunCost cost = {};
      std::unique_ptr<record::Writer> writer = nullptr; // process 0 only
      bool first = process_number() == 0;

      std::string checkpoint_path() const { return record::checkpoint_path(command.record_path()); }
      void open_record(const std::optional<double> &resumed_at);
      record::Profile profile(const Problem &, const LinearSystem &, const Observer &,
                              const SteppingState &) const;
      int conclude(const Problem &, const LinearSystem &, Observer &, const Outcome &);
    };

    void Run::open_record(const std::optional<double> &resumed_at)
    {
      const int processes = number_of_processes();
      on_first_process(
          [&]
          {
            std::filesystem::create_directories(command.output);
            auto provenance =
                record::collect_provenance("fe_reference", command.joined, command.threads);
            add_versions(provenance, scene);
            provenance["processes"] = std::to_string(processes);
            if (resumed_at)
              writer = std::make_unique<record::Writer>(command.record_path(), provenance, scene,
                                                        record::Writer::Resume{*resumed_at});
            else
              writer = std::make_unique<record::Writer>(command.record_path(), provenance, scene,
                                                        command.force);
          });
    }

    record::Profile Run::profile(const Problem &problem, const LinearSystem &system,
                                 const Observer &observer, const SteppingState &stepping) const
    {
      record::SolverCost solver;
      solver.output = observer.cost();
      solver.steps = stepping.steps;
      solver.parts = {{"factorisations", system.factorisation_seconds(),
                       system.factorisation_cpu_seconds(), system.factorisations()}};
      solver.numbers = {{"steps", stepping.steps},
                        {"retries", stepping.retries},
                        {"newton_iterations", stepping.iterations},
                        {"cells", problem.mesh.cells},
                        {"points", problem.mesh.cells * problem.mesh.points_per_cell},
                        {"unknowns", problem.mesh.unknowns()},
                        {"processes", number_of_processes()}};
      for (const auto &[what, bytes] : memory(problem, system))
        solver.numbers["bytes " + what] = bytes;
      return cost.profile(std::move(solver));
    }

    int Run::conclude(const Problem &problem, const LinearSystem &system, Observer &observer,
                      const Outcome &outcome)
    {
      const bool diverged = outcome.kind == Outcome::Kind::diverged;
      if (outcome.last.time < scene.clock.end * (1. - 1e-9) ||
          outcome.last.time > scene.clock.end * (1. + 1e-9))
        observer.observe_last({outcome.last, outcome.last, outcome.stepping, {}});
      if (!first)
        return diverged ? record::numerical_trouble : record::all_right;
      writer->attribute("linear_solver", system.solver_name());
      write_findings(*writer, problem, observer, outcome, scene.clock.end);
      if (!outcome.message.empty())
      {
        writer->attribute("ended_by", outcome.message);
        std::cerr << "fe_reference: " << outcome.message << "\nrepeat with: " << command.joined
                  << '\n';
      }
      writer->finish(profile(problem, system, observer, outcome.stepping),
                     diverged ? "failed: " + outcome.message : "complete");
      std::filesystem::remove(checkpoint_path());
      std::cout << command.record_path() << ": " << (diverged ? "failed" : "complete") << ", "
                << outcome.stepping.steps << " steps, " << outcome.stepping.iterations
                << " iterations, largest load factor " << outcome.last.time / scene.clock.end
                << ", smallest Jacobian " << outcome.last.smallest_jacobian << '\n';
      return diverged ? record::numerical_trouble : record::all_right;
    }

    // How far and in what steps to march; `observe` is left to the caller.
    SteppingOptions make_options(const scene::Scene &scene, const Problem &problem,
                                 const Observer &observer, const std::function<bool()> &stop_asked)
    {
      const scene::Fe settings = scene.fe.value_or(scene::Fe{});
      SteppingOptions options;
      options.end = scene.clock.end;
      options.load_steps = settings.load_steps;
      options.sampling_times = observer.times();
      options.until_folding = settings.past_folding;
      options.folded = [&problem, &observer]
      { return observer.folded_cells_at_end() > overlooked_folds * problem.mesh.cells; };
      options.interrupted = [&stop_asked]
      { return sum_over_processes(stop_asked() ? 1. : 0.) > 0.; };
      options.refused = [&observer] { return observer.overlap(); };
      return options;
    }
  } // namespace

  int show_plan(const scene::Scene &scene, const int threads)
  {
    refuse_active_sections(scene);
    const Problem problem = make_problem(scene, make_mesh(scene), threads);
    const Plan plan = make_plan(problem, scene, Observer(scene, problem, nullptr).times());
    if (process_number() == 0)
      std::cout << banner(scene) << describe(plan);
    if (!plan.trouble.empty())
      throw Stopped("the run will meet trouble: " + plan.trouble);
    return record::all_right;
  }

  namespace
  {
    int exit_code_of(const std::exception &error)
    {
      return record::is_of_writing(error) ? record::not_written : record::numerical_trouble;
    }

    // From the start or from what was saved.
    Outcome run_together(const scene::Scene &scene, const Problem &problem, LinearSystem &system,
                         const SteppingOptions &options, std::optional<SavedState> saved)
    {
      try
      {
        return saved ? run_load_steps(problem, system, std::move(saved->state), options,
                                      std::move(saved->stepping))
                     : run_load_steps(problem, system, initial_state(problem, scene), options);
      }
      catch (const std::exception &error) // here, since the processes part together with `system`
      {
        abort_all_processes(error.what(), exit_code_of(error));
        throw;
      }
    }

    // What is done by the clock, and more often on a slow machine. A function of its own, and never
    // part of another: tests/instructions leaves it out of what a step costs.
    [[gnu::noinline]] void keep_house(const std::function<void()> &work)
    {
      work();
    }

    // Sets `under_way` once the record is open.
    int march(const scene::Scene &scene, const record::CommandLine &command,
              const std::function<bool()> &stop_asked, bool &under_way)
    {
      refuse_active_sections(scene);
      Run run{scene, command};
      const QuadMesh mesh = make_mesh(scene);
      const Problem problem = make_problem(scene, mesh, command.threads);
      if (run.first)
        std::cerr << banner(scene) << pins(problem) << missing_area(scene, mesh);
      LinearSystem system(problem.mesh);

      std::optional<SavedState> saved;
      if (command.resume)
        saved = load(run.checkpoint_path(), scene, problem, run.cost);
      run.open_record(saved ? std::optional<double>(saved->state.time) : std::nullopt);
      under_way = true;
      Observer observer(scene, problem, run.writer.get());
      if (saved)
        observer.resume(saved->folding);
      run.cost.set_up_done();

      const double begin = saved ? saved->state.time : 0.;
      record::Progress progress(std::cerr, record::Progress::style_of_stderr(!run.first),
                                "fe_reference " + scene.title, {begin, scene.clock.end});
      record::Stopwatch since_checkpoint;
      const auto checkpoint = [&](const State &state, const SteppingState &stepping)
      {
        on_first_process([&] { run.writer->flush(); });
        save(run.checkpoint_path(), scene, problem,
             {state, stepping, observer.folding(),
              run.profile(problem, system, observer, stepping)});
        since_checkpoint = {};
      };

      SteppingOptions options = make_options(scene, problem, observer, stop_asked);
      options.observe = [&](const Step &step)
      {
        observer.observe(step);
        keep_house(
            [&]
            {
              std::ostringstream now;
              now << "step " << step.stepping.steps << ", " << step.newton.iterations
                  << " iterations, smallest Jacobian " << step.state.smallest_jacobian;
              progress.update(step.state.time, now.str());
              const double waited = -minimum_over_processes(-since_checkpoint.wall_seconds());
              if (waited > seconds_between_checkpoints)
                checkpoint(step.state, step.stepping);
              on_first_process([&] { run.writer->flush_after(seconds_between_flushes); });
            });
      };

      const Outcome outcome = run_together(scene, problem, system, options, std::move(saved));
      if (outcome.kind == Outcome::Kind::interrupted)
      {
        checkpoint(outcome.last, outcome.stepping);
        progress.finish("interrupted; go on with --resume");
        return record::interrupted;
      }
      progress.finish(outcome.kind == Outcome::Kind::complete ? "done" : "failed");
      return run.conclude(problem, system, observer, outcome);
    }
  } // namespace

  int run(const scene::Scene &scene, const record::CommandLine &command,
          const std::function<bool()> &stop_asked)
  {
    bool under_way = false;
    try
    {
      return march(scene, command, stop_asked, under_way);
    }
    catch (const std::exception &error)
    {
      if (!under_way)
        throw;
      throw Stopped(error.what(), exit_code_of(error));
    }
  }
} // namespace fe
