// What must hold between keys. The list itself, in words, is in rules.cc; the checks stand in
// rules_*.cc by subject.
#pragma once

#include <string>
#include <vector>

#include "scene/build.h"

namespace scene
{
  /// What a rule checks, and where its errors go.
  struct Inspection
  {
    const Draft &draft;
    ErrorList &errors;
    bool geometry_known; // domain and bodies were read without error, none is a record's outline

    const Scene &scene() const { return draft.scene; }
    /// Is the section written, even if something in it is wrong?
    bool present(const std::string &section) const;
    bool written(const std::string &section, const std::string &key) const;
    /// The key's value if it is written, else its section, else the whole file.
    const Value &at(const std::string &section, const std::string &key = "") const;
    /// An error about `at`, unless it already has one.
    void add_error(const Value &at, const std::string &cause, const std::string &allowed,
                   const std::string &remedy) const;
  };

  struct Rule
  {
    std::string statement; // for the manual
    void (*check)(const Inspection &);
  };

  /// All rules, in the order of the manual.
  const std::vector<Rule> &rules();

  /// Applies every rule; each one broken becomes one error, with the reason and the remedy.
  void check_rules(const Draft &, ErrorList &);

} // namespace scene
