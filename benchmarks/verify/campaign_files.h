// What a campaign leaves behind: campaign.json, verdict.json and curves.json of each case,
// junit.xml.
#pragma once

#include "campaign.h"
#include "json_text.h"
#include "record/lock.h"

namespace verify
{
  /// NaN and infinity are not JSON: null, with a status beside it.
  Json number_or_null(const std::optional<double> &);

  /// Unit of a check's value: an order and a relative norm have none ("-"), whatever they are of.
  std::string value_unit(const Check &);
  /// "0.02" of a norm that cannot be negative, else "0 .. 5".
  std::string limit_text(const Check &);

  Json to_json(const Verdict &, const std::string &repeat);
  /// One run with its cost, what its record says of itself, and the command that repeats it.
  Json run_to_json(const Run &, const Job &, const Outcome &);
  /// Curves and outlines of one verdict, thinned to what a picture can show.
  Json curves_to_json(const Verdict &);

  /// Held while a command runs cases into that folder: two at once would judge each other's
  /// records. Throws BadInput naming the process that holds it.
  record::Lock lock_output(const std::string &folder);

  /// Whole or not at all (record/atomic_write.h), in a folder that is made if need be.
  void write_text(const std::string &path, const std::string &text);
  /// All of the above under the campaign's output folder.
  void write_campaign(const Campaign &, const Paths &);
  std::string junit(const Campaign &, const Paths &);
} // namespace verify
