#include "scene/keys.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace scene
{
  bool Range::holds(const double value) const
  {
    return (with_lower ? value >= lower : value > lower) &&
           (with_upper ? value <= upper : value < upper);
  }

  std::string Range::text() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::string text;
    if (lower > -infinity)
      text = (with_lower ? "at least " : "greater than ") + number_text(lower);
    if (upper < infinity)
      text += (text.empty() ? "" : ", ") + std::string(with_upper ? "at most " : "less than ") +
              number_text(upper);
    return text;
  }

  const Key *Section::find(const std::string_view key) const
  {
    const auto at =
        std::find_if(keys.begin(), keys.end(), [&](const Key &k) { return k.name == key; });
    return at == keys.end() ? nullptr : &*at;
  }

  std::vector<std::string> Section::key_names() const
  {
    std::vector<std::string> names;
    for (const Key &key : keys)
      names.push_back(key.name);
    return names;
  }

  const std::vector<Section> &sections()
  {
    static const std::vector<Section> all = []
    {
      std::vector<Section> result;
      for (auto part : {domain_sections, solid_sections, probe_sections, solver_sections,
                        melt_sections, motion_sections})
        for (Section &section : part())
          result.push_back(std::move(section));
      return result;
    }();
    return all;
  }

  const Section *find_section(const std::string_view name)
  {
    const auto &all = sections();
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const Section &s) { return s.name == name; });
    return at == all.end() ? nullptr : &*at;
  }

  namespace
  {
    void check_alternatives(const Section &section, const Value &table, ErrorList &errors)
    {
      for (const Alternatives &choice : section.alternatives)
      {
        std::vector<const Value *> present;
        std::vector<std::string> names;
        for (const std::string &key : choice.keys)
          if (const Value *value = table.find(key))
          {
            present.push_back(value);
            names.push_back(key);
          }
        if (present.size() > 1)
          errors.add(*present[1], comma_separated(names) + " exclude each other",
                     "one of " + comma_separated(choice.keys), "keep the one that is meant");
        if (present.empty() && choice.required)
          errors.add(table, "nothing says which of " + comma_separated(choice.keys) + " is meant",
                     "one of " + comma_separated(choice.keys), "add one");
      }
    }
  } // namespace

  void read_section(const Section &section, const Value &table, void *target, ErrorList &errors)
  {
    for (const auto &[name, value] : table.entries)
      if (const Key *key = section.find(name))
        key->read(value, target, errors);
      else if (!section.name.empty())
        errors.add(value, "there is no such key", comma_separated(section.key_names()),
                   did_you_mean(name, section.key_names()));
    for (const Key &key : section.keys)
      if (key.required && !table.find(key.name))
        errors.add(table, "\"" + key.name + "\" is missing (" + key.sentence + ")",
                   key.kind + (key.allowed.range.text().empty() ? "" : ", ") +
                       key.allowed.range.text(),
                   "add " + key.name + " = ..." +
                       (key.chosen_by.empty()
                            ? ""
                            : ", or " + key.chosen_by + " = ... at the top of the file"));
    check_alternatives(section, table, errors);
  }
} // namespace scene
