// Every key of the scene language, declared once: name, kind, unit, range, default, one sentence
// and the reason for the default. The reader, its range checks, the did-you-mean, explain() and the
// manual page all come from these tables; adding a key is one line in one of the keys_*.cc files
// (and its field).
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "scene/error_list.h"
#include "scene/units.h"
#include "scene/value.h"

namespace scene
{
  /// What numbers a key takes; expressions are checked only where they are constant.
  struct Range
  {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool with_lower = true, with_upper = true; // are the limits themselves allowed?

    bool holds(double value) const;
    std::string text() const; // "greater than 0", "" if everything is allowed
  };

  struct Allowed
  {
    Dimension dimension = Dimension::none;
    Range range;
  };
  inline Allowed any(const Dimension d = Dimension::none)
  {
    return {d, {}};
  }
  inline Allowed positive(const Dimension d = Dimension::none)
  {
    return {d, {0., std::numeric_limits<double>::infinity(), false, true}};
  }
  inline Allowed not_negative(const Dimension d = Dimension::none)
  {
    return {d, {0., std::numeric_limits<double>::infinity(), true, true}};
  }
  inline Allowed at_least(const double lower, const Dimension d = Dimension::none)
  {
    return {d, {lower, std::numeric_limits<double>::infinity(), true, true}};
  }
  inline Allowed between(const double lower, const double upper,
                         const Dimension d = Dimension::none)
  {
    return {d, {lower, upper, true, true}};
  }
  /// Excluding both limits.
  inline Allowed inside(const double lower, const double upper, const Dimension d = Dimension::none)
  {
    return {d, {lower, upper, false, false}};
  }
  /// Excluding 0, including `upper`.
  inline Allowed up_to(const double upper, const Dimension d = Dimension::none)
  {
    return {d, {0., upper, false, true}};
  }

  struct Key
  {
    std::string name, kind; // kind: "a number", "two whole numbers", ...
    Allowed allowed;
    bool required = false;
    std::string default_text; // the default, as text; empty: absent
    std::string chosen_by;    // key at the top of the file that may choose a required one instead
    std::string sentence, reason;
    /// Reads a value into the field this key names in `target`; what is wrong becomes an error.
    std::function<void(const Value &, void *target, ErrorList &)> read;
  };

  /// Keys that exclude each other; `required`: one of them must be there.
  struct Alternatives
  {
    std::vector<std::string> keys;
    bool required = false;
  };

  struct Section
  {
    std::string name; // "" for the keys at the top of the file
    std::string sentence;
    bool repeated = false; // [[name]]
    bool required = false;
    std::vector<Key> keys;
    std::vector<Alternatives> alternatives;

    const Key *find(std::string_view key) const;
    std::vector<std::string> key_names() const;
  };

  /// All sections, in the order of the manual.
  const std::vector<Section> &sections();
  /// Null if there is none of that name.
  const Section *find_section(std::string_view name);

  /// Reads every key of `table` into `target` (the struct that the section's keys belong to);
  /// unknown, missing, excluded, ill-typed and out-of-range keys become errors.
  void read_section(const Section &, const Value &table, void *target, ErrorList &);

  // Where the tables are.
  std::vector<Section> domain_sections(); // keys_domain.cc: top, units, domain, clock
  std::vector<Section> solid_sections();  // keys_solid.cc: body, solid, support, traction ...
  std::vector<Section> probe_sections();  // keys_probes.cc: probe
  std::vector<Section> solver_sections(); // keys_solvers.cc: mpm, fe
  std::vector<Section> melt_sections();   // keys_melt.cc: phase_field, growth, heat ...
  std::vector<Section> motion_sections(); // keys_motion.cc: wall, imposed, advection, extension
} // namespace scene
