#include "expect.h"

namespace verify
{
  namespace
  {
    void collect_runs(const Take &take, std::set<std::string> &names)
    {
      if (take.kind != Take::Kind::value)
        names.insert(take.run);
      for (const auto &inner : take.with)
        collect_runs(inner, names);
    }
  } // namespace

  std::set<std::string> runs_of(const Take &take)
  {
    std::set<std::string> names;
    collect_runs(take, names);
    return names;
  }

  std::set<std::string> runs_taken_by(const Check &check)
  {
    return check.order_over.empty()
               ? runs_of(check.take)
               : std::set<std::string>(check.order_over.begin(), check.order_over.end());
  }

  std::set<std::string> runs_of(const Check &check)
  {
    std::set<std::string> names = runs_taken_by(check);
    if (check.against.kind == Against::Kind::run)
      collect_runs(check.against.take, names);
    names.insert(check.uncertain_take.begin(), check.uncertain_take.end());
    names.insert(check.uncertain_against.begin(), check.uncertain_against.end());
    return names;
  }
} // namespace verify
