#include "newton.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/value.h"

namespace fe
{
  namespace
  {
    constexpr int most_iterations = 18;

    struct Balance
    {
      double free = 0., scale = 0.; // norms
      double rounding = 0.;         // of the internal forces themselves
      int worst = 0;
    };

    Balance balance_of(const Problem &problem, const State &old, const State &state)
    {
      Balance balance;
      double held = 0., load = 0., largest = -1.;
      for (std::size_t k = 0; k < state.internal.size(); ++k)
      {
        const double force = state.internal[k] - state.external[k];
        load += state.external[k] * state.external[k];
        if (problem.supports.is_held[k])
          held += state.internal[k] * state.internal[k];
        else
        {
          balance.free += force * force;
          if (std::abs(force) > largest)
          {
            largest = std::abs(force);
            balance.worst = static_cast<int>(k);
          }
        }
      }
      balance.free = std::sqrt(balance.free);
      balance.scale = std::max({std::sqrt(held), std::sqrt(load), old.force_scale});
      // F = 1 + du/dX is rounded to 1e-16 however small du is, each of its numbers and so det F,
      // which the stiffer volume answers. A body without load has these forces and no others.
      const double length = (problem.mesh.position.front() - problem.mesh.position.back()).norm();
      const double stiffest = problem.material.lame + 2. * problem.material.shear_modulus;
      balance.rounding = 3e-15 * stiffest * length;
      return balance;
    }

    std::vector<double> correction(const Problem &problem, LinearSystem &system, const State &now,
                                   const Tangent &tangent)
    {
      std::vector<double> right_side = tangent.correction;
      for (std::size_t k = 0; k < right_side.size(); ++k)
        if (!problem.supports.is_held[k])
          right_side[k] -= now.internal[k] - now.external[k];
      return system.solve(right_side);
    }

    // now.u = base + fraction * step; false if an element folds.
    bool move(const Problem &problem, const State &old, State &now, const std::vector<double> &base,
              const std::vector<double> &step, const double fraction)
    {
      for (std::size_t k = 0; k < base.size(); ++k)
        now.u[k] = base[k] + fraction * step[k];
      return assemble(problem, old, now, nullptr);
    }

    // Leaves `now` at the best fraction tried. False if every one folds.
    bool search(const Problem &problem, const State &old, State &now,
                const std::vector<double> &step, const double norm)
    {
      const std::vector<double> base = now.u;
      double best = HUGE_VAL, best_fraction = 0., fraction = 1.;
      for (int halving = 0; halving < 5; ++halving, fraction *= 0.5)
      {
        if (!move(problem, old, now, base, step, fraction))
          continue;
        const double tried = balance_of(problem, old, now).free;
        if (tried < (1. - 1e-2 * fraction) * norm)
          return true;
        if (tried < best)
        {
          best = tried;
          best_fraction = fraction;
        }
      }
      return best < HUGE_VAL && move(problem, old, now, base, step, best_fraction);
    }

    // Sum of the sizes of the loads on the pin's piece in its direction.
    double load_on_piece(const Problem &problem, const State &state, const int pin)
    {
      const std::vector<int> &piece = problem.supports.piece;
      double sum = 0.;
      for (int n = 0; n < problem.mesh.nodes; ++n)
        if (piece[n] == piece[pin / 2])
          sum += std::abs(state.external[2 * n + pin % 2]);
      return sum;
    }

    // A pin that carries a force holds up what nothing else does. What Newton's method leaves over
    // adds up in it, and so does what tractions that balance on the drawing are out of balance on
    // edges that stretch: a thousandth of them, say.
    bool pins_are_free(const Problem &problem, const State &state, const Balance &balance,
                       NewtonReport &report)
    {
      const double left = std::max(problem.tolerance * balance.scale, balance.rounding);
      constexpr double out_of_balance = 1e-2;
      const double unsolved = 2. * std::sqrt(static_cast<double>(problem.mesh.nodes)) * left;
      for (const int pin : problem.supports.pins)
      {
        const double limit =
            std::max(out_of_balance * load_on_piece(problem, state, pin), unsolved);
        const double force = state.external[pin] - state.internal[pin];
        if (std::abs(force) <= limit)
          continue;
        report.remedy = "a support that takes up the force";
        report.worst_unknown = pin;
        report.failure = std::string("nothing holds the body in ") + (pin % 2 ? "y" : "x") +
                         ", yet a net force of " + scene::number_text(force) + " acts on it";
        return false;
      }
      return true;
    }

    // First correction: moves the held unknowns to their places.
    bool predict(const Problem &problem, LinearSystem &system, const State &old, State &now)
    {
      const std::vector<double> target = impose(problem.supports, problem.mesh, now.u, now.time);
      if (problem.supports.all_held())
      {
        now.u = target;
        return assemble(problem, old, now, nullptr);
      }
      Tangent tangent;
      tangent.system = &system;
      tangent.jump.resize(target.size());
      for (std::size_t k = 0; k < target.size(); ++k)
        tangent.jump[k] = target[k] - now.u[k];
      if (!assemble(problem, old, now, &tangent))
        return false;
      const std::vector<double> step = correction(problem, system, now, tangent);
      for (std::size_t k = 0; k < target.size(); ++k)
        now.u[k] = problem.supports.is_held[k] ? target[k] : now.u[k] + step[k];
      return assemble(problem, old, now, nullptr);
    }
  } // namespace

  NewtonReport find_equilibrium(const Problem &problem, LinearSystem &system, const State &old,
                                State &now)
  {
    NewtonReport report;
    try
    {
      if (!predict(problem, system, old, now))
      {
        report.failure = "an element folds in the first correction";
        return report;
      }
      Tangent tangent;
      tangent.system = &system;
      for (report.iterations = 1; report.iterations <= most_iterations; ++report.iterations)
      {
        const Balance balance = balance_of(problem, old, now);
        report.residuals.push_back(balance.free / std::max(balance.scale, balance.rounding));
        report.worst_unknown = balance.worst;
        if (!std::isfinite(balance.free))
          break;
        if (balance.free <= std::max(problem.tolerance * balance.scale, balance.rounding))
        {
          report.converged = pins_are_free(problem, now, balance, report);
          now.force_scale = balance.scale;
          report.determinant_sign = system.determinant_sign();
          return report;
        }
        if (!assemble(problem, old, now, &tangent) ||
            !search(problem, old, now, correction(problem, system, now, tangent), balance.free))
        {
          report.failure = "an element folds";
          return report;
        }
      }
      report.failure = "no equilibrium within " + std::to_string(most_iterations) +
                       " iterations (residual " + scene::number_text(report.residuals.back()) +
                       " of the largest force)";
    }
    catch (const OutOfMemory &error)
    {
      report.failure = error.what();
      report.remedy = "fewer [fe] cells, more memory, or more processes (mpirun)";
    }
    catch (const std::runtime_error &error)
    {
      report.failure = error.what();
    }
    return report;
  }
} // namespace fe
