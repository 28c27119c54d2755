#include "load_stepping.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fe
{
  namespace
  {
    constexpr double smallest_fraction = 1. / 16384.; // of the nominal increment
    constexpr int easy_iterations = 6;
    constexpr double longest_course = 10.; // times the end, where a mesh never folds

    // Reactions and loads over the motion of an increment, trapezoidal.
    double work(const Problem &problem, const State &old, const State &now)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < now.u.size(); ++k)
      {
        const auto driving = [&](const State &s)
        { return problem.supports.is_held[k] ? s.internal[k] : s.external[k]; };
        sum += 0.5 * (driving(old) + driving(now)) * (now.u[k] - old.u[k]);
      }
      return sum;
    }

    std::string describe(const Problem &problem, const State &last, const State &tried,
                         const NewtonReport &report, const SteppingOptions &options, const int step)
    {
      const Discretisation &d = problem.mesh;
      const bool folds = !(tried.smallest_jacobian > 0.);
      const Point &X = folds ? d.position[d.nodes_of(tried.worst_cell)[0]]
                             : d.position[report.worst_unknown / 2];
      std::ostringstream text;
      text << "no equilibrium beyond t = " << last.time << " (" << 100. * last.time / options.end
           << " % of the load) after " << step << " steps: " << report.failure << ", near X = ("
           << X[0] << ", " << X[1] << "); smallest Jacobian of the last equilibrium "
           << last.smallest_jacobian << ". Remedy: "
           << (report.remedy.empty()
                   ? "more [fe] load_steps, other [fe] cells, or [fe] grading towards "
                     "the corners"
                   : report.remedy);
      return text.str();
    }

    // The march itself: what it knows between increments.
    struct March
    {
      const Problem &problem;
      LinearSystem &system;
      const SteppingOptions &options;
      double nominal;
      State last, now;
      SteppingState stepping;
      NewtonReport report;
      // Time of an unstable equilibrium that none but such have followed; of the first of two.
      std::optional<double> suspect = {}, unstable_since = {};

      double target_time(double wanted) const;
      bool attempt(double time, bool carried);
      bool advance();
      void accept();
      void watch_stability();
      bool finished() const { return last.time > options.end - 1e-9 * nominal; }
      bool goes_on_past_the_end() const
      {
        return options.until_folding && !options.folded() &&
               last.time < longest_course * options.end;
      }
    };

    // One tangent alone may be that of an iterate on which points switch between yielding or not.
    void March::watch_stability()
    {
      if (report.determinant_sign >= 0)
        suspect.reset();
      else if (!suspect)
        suspect = now.time;
      else if (!unstable_since)
        unstable_since = suspect;
    }

    // Not past the next sampling time or the end, nor just short of it.
    double March::target_time(const double wanted) const
    {
      const double t = last.time, tolerance = 1e-9 * nominal;
      double stop = options.until_folding && finished() ? HUGE_VAL : options.end;
      for (const double sample : options.sampling_times)
        if (sample > t + tolerance)
        {
          stop = std::min(stop, sample);
          break;
        }
      if (stop - t <= wanted * (1. + 1e-6))
        return stop;
      return stop - t < 2. * wanted ? t + 0.5 * (stop - t) : t + wanted;
    }

    bool March::attempt(const double time, const bool carried)
    {
      now.time = time;
      now.u = last.u;
      if (carried)
        for (std::size_t k = 0; k < now.u.size(); ++k)
          now.u[k] += stepping.velocity[k] * (time - last.time);
      report = find_equilibrium(problem, system, last, now);
      stepping.iterations += report.iterations;
      stepping.retries += report.converged ? 0 : 1;
      return report.converged;
    }

    bool March::advance()
    {
      while (stepping.increment > smallest_fraction * nominal && report.remedy.empty())
      {
        const double time = target_time(stepping.increment);
        if (!stepping.velocity.empty() && attempt(time, true))
          return true;
        if (report.remedy.empty() && attempt(time, false))
          return true;
        stepping.increment = 0.5 * std::min(stepping.increment, time - last.time);
        stepping.easy_increments = 0;
      }
      return false;
    }

    void March::accept()
    {
      const double dt = now.time - last.time;
      stepping.velocity.resize(now.u.size());
      for (std::size_t k = 0; k < now.u.size(); ++k)
        stepping.velocity[k] = (now.u[k] - last.u[k]) / dt;
      const double external = stepping.energies.external + work(problem, last, now);
      stepping.energies = stored_energies(problem, now);
      stepping.energies.external = external;
      ++stepping.steps;
      stepping.easy_increments =
          report.iterations <= easy_iterations ? stepping.easy_increments + 1 : 0;
      if (stepping.easy_increments >= 2)
        stepping.increment = std::min(nominal, 1.5 * stepping.increment);
      options.observe({now, last, stepping, report});
      watch_stability();
      std::swap(last, now);
    }
  } // namespace

  Energies stored_energies(const Problem &problem, const State &state)
  {
    const Discretisation &d = problem.mesh;
    std::vector<double> sums(2, 0.);
    for (int cell = 0; cell < d.cells; ++cell)
      if (d.owned[cell])
        for (int q = 0; q < d.points_per_cell; ++q)
        {
          const int k = cell * d.points_per_cell + q;
          const PointState &point = state.points[k];
          const double J = point.F(0, 0) * point.F(1, 1) - point.F(0, 1) * point.F(1, 0);
          sums[0] += d.weight[k] * J * elastic_energy(problem.material, point.stress);
          sums[1] += d.weight[k] * point.plastic_work;
        }
    sum_over_processes(sums);
    return {0., sums[0], sums[1]};
  }

  Outcome run_load_steps(const Problem &problem, LinearSystem &system, State initial,
                         const SteppingOptions &options, SteppingState stepping)
  {
    const double nominal = options.end / options.load_steps;
    March march{problem, system, options, nominal, std::move(initial), {}, std::move(stepping), {}};
    march.now = march.last;
    if (march.stepping.steps == 0)
    {
      march.stepping.energies = stored_energies(problem, march.last);
      march.stepping.increment = nominal;
      options.observe({march.last, march.last, march.stepping, {}});
    }
    Outcome outcome;
    while (!march.finished() || march.goes_on_past_the_end())
    {
      if (options.interrupted())
      {
        outcome.kind = Outcome::Kind::interrupted;
        break;
      }
      if (!march.advance())
      {
        if (!march.finished())
          outcome.kind = Outcome::Kind::diverged;
        outcome.message =
            describe(problem, march.last, march.now, march.report, options, march.stepping.steps);
        break;
      }
      march.accept();
      outcome.message = options.refused ? options.refused() : "";
      if (!outcome.message.empty())
      {
        outcome.kind = Outcome::Kind::diverged;
        break;
      }
    }
    if (options.until_folding && march.finished() && outcome.message.empty() && options.folded())
      outcome.message = "the mesh has folded; the march ends";
    outcome.unstable_since = march.unstable_since;
    outcome.last = std::move(march.last);
    outcome.stepping = std::move(march.stepping);
    return outcome;
  }
} // namespace fe
