// What must hold between keys. The list itself, in words, is in rules.cc; the checks stand in
// rules_*.cc by subject.
#pragma once

#include <string>
#include <vector>

#include "scene/build.h"

namespace scene
{
  /// What a rule looks at, and whom it tells.
  struct Inspection
  {
    const Draft &draft;
    Complaints &complaints;
    bool
        geometry_known; // domain and bodies were read without complaint, none is a record's outline

    const Scene &scene() const { return draft.scene; }
    /// Is the section written, even if something in it is wrong?
    bool present(const std::string &section) const;
    bool written(const std::string &section, const std::string &key) const;
    /// The key's value if it is written, else its section, else the whole file.
    const Value &at(const std::string &section, const std::string &key = "") const;
    /// A complaint about `at`, unless it already has one.
    void complain(const Value &at, const std::string &cause, const std::string &allowed,
                  const std::string &remedy) const;
  };

  struct Rule
  {
    std::string statement; // for the manual
    void (*check)(const Inspection &);
  };

  /// All rules, in the order of the manual.
  const std::vector<Rule> &rules();

  /// Applies every rule; each one broken becomes one complaint, with the reason and the remedy.
  void check_rules(const Draft &, Complaints &);

} // namespace scene
