#include "scene/presets.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scene/body_sizes.h"
#include "scene/build.h"
#include "scene/geometry.h"
#include "scene/inputs.h"
#include "scene/quasi_static.h"

namespace scene
{
  namespace
  {
    constexpr double most_cells = 100000., most_elements = 10000.; // as the keys allow

    Value number(const double x)
    {
      Value value;
      value.kind = Value::Kind::number;
      value.number = x;
      return value;
    }

    Value whole(const int n)
    {
      Value value;
      value.kind = Value::Kind::integer;
      value.integer = n;
      value.number = n;
      return value;
    }

    Value text(const std::string &word)
    {
      Value value;
      value.kind = Value::Kind::text;
      value.text = word;
      return value;
    }

    Value pair(const int a, const int b)
    {
      Value value;
      value.kind = Value::Kind::array;
      value.items = {whole(a), whole(b)};
      return value;
    }

    /// What one level asks for, free of any scene's scale.
    struct Level
    {
      double spacing_of_growth; // dx/W0 where a crystal grows
      double spacing_of_marker; // dx/W where a passive phi is only carried
      double cells_of_elastic;  // across the thinnest body of a solid alone
      double cells_along;       // and along the longest, for a body that is thin nowhere
      double cells_of_plastic;  // the same where it yields: shear bands want more
      int points_of_elastic;    // in each direction of a cell: strains that stay want more points
      int points_of_plastic;    // than those that flow away
      double mach;              // of a solid that is driven, not thrown
      double crossings;         // of a scaled wave while supports or walls go their way
      double noise_step;        // D dt/dx^2 where noise alone moves the heat; it adds twice that
                                // to the variance
      int load_steps;           // of the finite elements
      double elements_across_thinnest;
      const char *precision = "float";       // of growth
      const char *advection = "cip_hermite"; // scheme
      double advection_step = 0.4;           // cells that the motion may cross per step and axis
      int degree = 2;                        // of the finite elements
    };

    const Level &level_of(const Accuracy accuracy)
    {
      static const Level draft{0.8, 0.67, 2., 12., 10., 2, 2, 5e-3, 10., 0.1, 50, 2.5};
      static const Level standard{0.6, 0.5, 4., 24., 20., 3, 2, 2e-3, 20., 0.05, 50, 5.};
      static const Level fine{0.4, 0.25, 8., 48., 40., 4, 2, 1e-3, 40., 0.025, 100, 10.};
      return accuracy == Accuracy::draft ? draft : accuracy == Accuracy::fine ? fine : standard;
    }

    /// A key of the preset: its value, and what the scene holds instead once it is read.
    struct Choice
    {
      std::string section, key;
      Value value;
      std::string in_scene;
    };

    std::string absent_or(const std::optional<double> &value)
    {
      return value ? number_text(*value) : "absent";
    }

    double wanted_spacing(const Scene &s, const Level &level)
    {
      if (s.phase_field)
        return s.phase_field->width *
               (s.growth ? level.spacing_of_growth : level.spacing_of_marker);
      if (!s.solid || s.bodies.empty())
        return 0.;
      const BodySizes sizes = sizes_to_resolve(s);
      return s.solid->yield_stress ? sizes.thinnest / level.cells_of_plastic
                                   : std::min(sizes.thinnest / level.cells_of_elastic,
                                              sizes.longest / level.cells_along);
    }

    std::array<int, 2> cells_of_domain(const Scene &s, const Level &level)
    {
      const double spacing = wanted_spacing(s, level);
      return spacing > 0. && s.domain.size.minCoeff() > 0.
                 ? square_cells(s.domain.size, spacing, ends_of_held_segments(s))
                 : std::array<int, 2>{0, 0};
    }

    void choose_solid(std::vector<Choice> &choices, const Scene &s, const Level &level)
    {
      const Mpm mpm = s.mpm.value_or(Mpm{});
      const auto as_text = [](const std::array<int, 2> &two)
      { return inline_text(pair(two[0], two[1])); };
      const bool stays_elastic = !s.solid->yield_stress && !s.growth;
      const int points = stays_elastic ? level.points_of_elastic : level.points_of_plastic;
      choices.push_back(
          {"mpm", "points_per_cell", pair(points, points), as_text(mpm.points_per_cell)});
      if (const auto mach = scaled_mach(s, level.mach, level.crossings))
        choices.push_back({"mpm", "mach", number(*mach), absent_or(mpm.mach)});
      if (s.growth || s.bodies.empty())
        return;
      const Fe fe = s.fe.value_or(Fe{});
      const Box box = bounding_box(s.bodies);
      const Point side = box.upper - box.lower;
      const double size = sizes_to_resolve(s).thinnest / level.elements_across_thinnest;
      const auto along = [&](const int axis)
      { return static_cast<int>(std::clamp(std::round(side[axis] / size), 1., most_elements)); };
      choices.push_back({"fe", "cells", pair(along(0), along(1)), as_text(fe.cells)});
      choices.push_back({"fe", "degree", whole(level.degree), std::to_string(fe.degree)});
      choices.push_back(
          {"fe", "load_steps", whole(level.load_steps), std::to_string(fe.load_steps)});
    }

    std::vector<Choice> choices_of(const Scene &s, const Level &level)
    {
      std::vector<Choice> choices;
      if (const auto cells = cells_of_domain(s, level); cells[0] > 0)
        choices.push_back({"domain", "cells", pair(cells[0], cells[1]),
                           inline_text(pair(s.domain.cells[0], s.domain.cells[1]))});
      if (s.solid)
        choose_solid(choices, s, level);
      if (s.growth)
        choices.push_back(
            {"growth", "precision", text(level.precision), word(s.growth->precision)});
      const double spacing = s.domain.cells[0] > 0 ? s.domain.spacing()[0] : 0.;
      if (s.noise && s.heat && !s.growth && spacing > 0.)
        choices.push_back({"clock", "step",
                           number(level.noise_step * spacing * spacing / s.heat->diffusivity),
                           absent_or(s.clock.step)});
      if (s.imposed || (s.solid && s.phase_field))
      {
        const Advection advection = s.advection.value_or(Advection{});
        choices.push_back({"advection", "scheme", text(level.advection), word(advection.scheme)});
        choices.push_back({"advection", "step_fraction", number(level.advection_step),
                           number_text(advection.step_fraction)});
      }
      return choices;
    }

    /// Writes one choice, unless the scene has its own word.
    void write(const Choice &choice, Value &root, const Value &at)
    {
      const auto placed = [&at](Value value)
      {
        value.place = at.place;
        value.origin = at.origin;
        return value;
      };
      if (!root.find(choice.section))
        root.set(choice.section, placed(Value{}));
      if (Value *table = root.find(choice.section); !table->find(choice.key))
        table->set(choice.key, placed(choice.value));
    }

    std::optional<Accuracy> accuracy_named(const std::string &name)
    {
      for (const auto &[text, value] : words(Accuracy{}))
        if (name == text)
          return value;
      return {};
    }
  } // namespace

  std::array<int, 2> square_cells(const Point &size, const double spacing,
                                  const std::array<std::vector<double>, 2> &marks)
  {
    if (size.maxCoeff() > most_cells * spacing)
      return {0, 0};
    const auto whole = [](const double x)
    { return std::abs(x - std::round(x)) <= 1e-9 * (1. + std::abs(x)); };
    std::array<int, 2> coarsest{0, 0};
    const int first = static_cast<int>(std::ceil(size[1] / spacing * (1. - 1e-9)));
    for (int ny = std::max(1, first); ny <= std::max(2, 3 * first / 2); ++ny)
    {
      const double nx = size[0] * ny / size[1];
      if (!whole(nx) || nx < 0.5)
        continue;
      const std::array<int, 2> cells{static_cast<int>(std::lround(nx)), ny};
      if (coarsest[0] == 0)
        coarsest = cells;
      bool on_lines = true;
      for (int axis = 0; axis < 2; ++axis)
        for (const double mark : marks[static_cast<std::size_t>(axis)])
          on_lines = on_lines && whole(mark / size[axis] * cells[static_cast<std::size_t>(axis)]);
      if (on_lines)
        return cells;
    }
    return coarsest;
  }

  void apply_preset(Value &root, ErrorList &errors)
  {
    const Value *written = root.find("accuracy");
    const auto accuracy = written ? accuracy_named(written->text) : std::nullopt;
    if (!accuracy)
      return; // absent, or a word that the reader of the key refuses
    const Value at = *written;
    // What the scene is about is read once on trial; its mistakes are reported when it is read in
    // earnest.
    ErrorList silent;
    Draft trial{{}, root, {}, {}, {}, {}, {}, {}};
    build(trial, silent);
    const Value *domain = root.find("domain");
    const Point size = trial.scene.domain.size;
    const double spacing = wanted_spacing(trial.scene, level_of(*accuracy));
    if (domain && !domain->find("cells") && spacing > 0. && size.maxCoeff() > most_cells * spacing)
      errors.add(at,
                 "the interface or the bodies are so thin that cells of " + number_text(spacing) +
                     " are wanted in a domain of " + number_text(size[0]) + " x " +
                     number_text(size[1]),
                 number_text(most_cells) + " cells each way",
                 "check phase_field.width and the bodies' sizes, or give [domain] cells");
    else if (domain && !domain->find("cells") &&
             cells_of_domain(trial.scene, level_of(*accuracy))[0] == 0)
      errors.add(at,
                 "nothing in this scene says how fine its mesh should be, or no square cells "
                 "of that size divide the domain's width and height",
                 "", "give [domain] cells");
    for (const Choice &choice : choices_of(trial.scene, level_of(*accuracy)))
      write(choice, root, at);
  }

  std::string describe_preset(const Scene &scene)
  {
    const auto accuracy = accuracy_named(scene.accuracy);
    if (!accuracy)
      return "";
    std::string out = "  accuracy = " + scene.accuracy + ":\n";
    for (const Choice &choice : choices_of(scene, level_of(*accuracy)))
    {
      const std::string value =
          choice.value.kind == Value::Kind::text ? choice.value.text : inline_text(choice.value);
      out += "    " + choice.section + "." + choice.key + " = " + choice.in_scene;
      out +=
          choice.in_scene == value ? "\n" : " (the scene's own; the preset says " + value + ")\n";
    }
    return out;
  }
} // namespace scene
