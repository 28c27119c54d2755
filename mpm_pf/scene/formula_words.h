// What expressions and probes are made of, word by word, for the manual: functions and variables of
// expression.h, quantities of quantities.h.
#pragma once

#include <string>
#include <vector>

namespace scene
{
  /// `form`: how it is written, where a and b stand for any number and T for a time.
  struct ExpressionWord
  {
    std::string name, form, sentence;
  };

  /// All that the manual speaks of, functions last.
  const std::vector<ExpressionWord> &expression_words();

  struct Quantity
  {
    std::string name, sentence;
  };

  /// One entry for each of solid_quantities and melt_quantities, in their order.
  const std::vector<Quantity> &probe_quantities();
} // namespace scene
