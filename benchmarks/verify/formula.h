// Expressions of expect.toml: of constants, or of the columns of a probe, row by row (muParser).
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace verify
{
  /// Named numbers in order of appearance.
  using Constants = std::vector<std::pair<std::string, double>>;
  /// Named columns of equal length.
  using ColumnData = std::map<std::string, std::vector<double>>;

  /// One number from an expression of the constants. Throws BadInput naming the expression and what
  /// is wrong; as in scenes, an assignment and a list of values ("0,02") are no expressions.
  double evaluate(const std::string &text, const Constants &);

  /// The names in an expression that are no constants. Throws BadInput if it is no expression.
  std::set<std::string> unknown_names(const std::string &text, const Constants &);

  /// One number per row from an expression of constants and columns. Throws MissingData naming the
  /// columns that there are if the expression asks for another, BadInput if it is no expression.
  std::vector<double> evaluate(const std::string &text, const Constants &, const ColumnData &);
} // namespace verify
