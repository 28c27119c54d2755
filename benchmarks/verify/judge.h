// The verdict on one check: what came out, against what, within which limit, how uncertain.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expect.h"
#include "measure.h"
#include "quantity.h"

namespace verify
{
  enum class Status
  {
    pass,
    fail,
    missing,      // data absent, short or not finite: counts as a failure
    no_reference, // exit code 4
  };
  std::string text(Status);

  /// Distance from this project's own last accepted value, apart from the verdict.
  struct Drift
  {
    std::optional<double> accepted;
    double tolerance = 0.;
    bool drifted = false;
    bool unknown = false; // it has a value and nothing that this could have drifted from
  };

  struct Verdict
  {
    Check check;
    Status status = Status::missing;
    std::string why; // what is missing, or in what way it failed
    std::optional<double> value;
    std::optional<double> taken, reference; // where both are numbers
    std::optional<double> uncertainty;      // combined, in the unit of the value
    std::string uncertainty_text;
    std::vector<double> h, errors; // of an order of convergence
    // what the report draws
    std::optional<Curve> taken_curve, reference_curve;
    Outline taken_outline, reference_outline;
    Drift drift;
  };

  /// Never throws: where the data are absent, or the check makes no sense of them, the status is
  /// missing and `why` says so.
  Verdict judge(const Check &, const Case &, Records &);

  /// One line: the take, the reference (for tables and the report).
  std::string describe(const Take &);
  std::string describe(const Against &);
} // namespace verify
