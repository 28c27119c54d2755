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
                         const NewtonReport &report, const Course &course, const int step)
    {
      const Discretisation &d = problem.mesh;
      const bool folds = !(tried.smallest_jacobian > 0.);
      const Point &X = folds ? d.position[d.nodes_of(tried.worst_cell)[0]]
                             : d.position[report.worst_unknown / 2];
      std::ostringstream text;
      text << "no equilibrium beyond t = " << last.time << " (" << 100. * last.time / course.end
           << " % of the load) after " << step << " steps: " << report.trouble << ", near X = ("
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
      const Course &course;
      double nominal;
      State last, now;
      Pace pace;
      NewtonReport report;

      double target_time(double wanted) const;
      bool attempt(double time, bool carried);
      bool advance();
      void accept();
      bool finished() const { return last.time > course.end - 1e-9 * nominal; }
      bool goes_on_past_the_end() const
      {
        return course.until_folding && !course.folded() && last.time < longest_course * course.end;
      }
    };

    // Not past the next sampling time or the end, nor just short of it.
    double March::target_time(const double wanted) const
    {
      const double t = last.time, tolerance = 1e-9 * nominal;
      double stop = course.until_folding && finished() ? HUGE_VAL : course.end;
      for (const double sample : course.sampling_times)
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
          now.u[k] += pace.velocity[k] * (time - last.time);
      report = find_equilibrium(problem, system, last, now);
      pace.iterations += report.iterations;
      pace.retries += report.converged ? 0 : 1;
      return report.converged;
    }

    bool March::advance()
    {
      while (pace.increment > smallest_fraction * nominal && report.remedy.empty())
      {
        const double time = target_time(pace.increment);
        if (!pace.velocity.empty() && attempt(time, true))
          return true;
        if (report.remedy.empty() && attempt(time, false))
          return true;
        pace.increment = 0.5 * std::min(pace.increment, time - last.time);
        pace.easy = 0;
      }
      return false;
    }

    void March::accept()
    {
      const double dt = now.time - last.time;
      pace.velocity.resize(now.u.size());
      for (std::size_t k = 0; k < now.u.size(); ++k)
        pace.velocity[k] = (now.u[k] - last.u[k]) / dt;
      const double external = pace.energies.external + work(problem, last, now);
      pace.energies = stored_energies(problem, now);
      pace.energies.external = external;
      ++pace.steps;
      pace.easy = report.iterations <= easy_iterations ? pace.easy + 1 : 0;
      if (pace.easy >= 2)
        pace.increment = std::min(nominal, 1.5 * pace.increment);
      course.observe({now, last, pace, report});
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

  Outcome follow(const Problem &problem, LinearSystem &system, State initial, const Course &course,
                 Pace pace)
  {
    const double nominal = course.end / course.load_steps;
    March march{problem, system, course, nominal, std::move(initial), {}, std::move(pace), {}};
    march.now = march.last;
    if (march.pace.steps == 0)
    {
      march.pace.energies = stored_energies(problem, march.last);
      march.pace.increment = nominal;
      course.observe({march.last, march.last, march.pace, {}});
    }
    Outcome outcome;
    while (!march.finished() || march.goes_on_past_the_end())
    {
      if (course.interrupted())
      {
        outcome.kind = Outcome::Kind::interrupted;
        break;
      }
      if (!march.advance())
      {
        if (!march.finished())
          outcome.kind = Outcome::Kind::diverged;
        outcome.message =
            describe(problem, march.last, march.now, march.report, course, march.pace.steps);
        break;
      }
      march.accept();
      outcome.message = course.refused ? course.refused() : "";
      if (!outcome.message.empty())
      {
        outcome.kind = Outcome::Kind::diverged;
        break;
      }
    }
    if (course.until_folding && march.finished() && outcome.message.empty() && course.folded())
      outcome.message = "the mesh has folded; the march ends";
    outcome.last = std::move(march.last);
    outcome.pace = std::move(march.pace);
    return outcome;
  }
} // namespace fe
