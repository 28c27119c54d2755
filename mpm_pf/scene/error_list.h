// All that is wrong with a scene, collected so that all of it is reported in one pass.
#pragma once

#include <string>
#include <vector>

#include "scene/value.h"

namespace scene
{
  class ErrorList
  {
  public:
    /// One error about `at`: what was read and why it is wrong; what is allowed; what to do.
    /// Empty parts are left out.
    void add(const Value &at, const std::string &cause, const std::string &allowed = "",
             const std::string &remedy = "");
    /// An error that already carries its place (a syntax error of toml11).
    void add(const SourceLocation &, const std::string &text);

    std::size_t count() const { return list.size(); }
    /// Was there an error about this very value, or one inside it?
    bool about(const Value &) const;
    /// All of them, file by file in order of lines, under a line that counts them.
    std::string text() const;
    /// Throws BadScene if there is any.
    void throw_if_any() const;

  private:
    struct Error
    {
      SourceLocation place;
      std::string text;
    };
    std::vector<Error> list;
  };

  /// The nearest of `known` to what was written, as `did you mean "..."?`, or nothing if none is
  /// near (edit distance with transpositions at most a third of the length).
  std::string did_you_mean(const std::string &written, const std::vector<std::string> &known);

  /// a, b, c
  std::string comma_separated(const std::vector<std::string> &);
} // namespace scene
