// explain() and manual(): the tables of keys.h as text.
#include "scene/expression.h"
#include "scene/keys.h"
#include "scene/reader.h"
#include "scene/rules.h"

namespace scene
{
  namespace
  {
    std::string header_of(const Section &section)
    {
      if (section.name.empty())
        return "top of the file";
      return section.repeated ? "[[" + section.name + "]]" : "[" + section.name + "]";
    }

    std::string units_of(const Key &key)
    {
      const std::string si = unit_text(key.allowed.dimension, Units::si);
      const std::string own = unit_text(key.allowed.dimension, Units::w0_tau0_sigma_y);
      return si == own ? si : si + " (in W0-tau0-sigmaY: " + own + ")";
    }

    std::string default_of(const Key &key)
    {
      return key.required ? "none, must be given" : key.standard.empty() ? "absent" : key.standard;
    }

    std::string full_name(const Section &section, const Key &key)
    {
      return section.name.empty() ? key.name : section.name + "." + key.name;
    }

    std::string entry(const Section &section, const Key &key)
    {
      const std::string units = units_of(key), range = key.allowed.range.text();
      return full_name(section, key) + "\n  " + key.sentence + "\n  kind:    " + key.kind +
             (units.empty() ? "" : "\n  unit:    " + units) +
             (range.empty() ? "" : "\n  range:   " + range) + "\n  default: " + default_of(key) +
             (key.reason.empty() ? "" : "\n  why:     " + key.reason) + "\n";
    }

    std::string entries(const Section &section)
    {
      std::string text = header_of(section) + "\n  " + section.sentence + "\n";
      for (const Alternatives &choice : section.alternatives)
        text += std::string("  ") + (choice.required ? "exactly" : "at most") +
                " one of: " + listed(choice.keys) + "\n";
      for (const Key &key : section.keys)
        text += "\n" + entry(section, key);
      return text;
    }

    std::string cell(std::string text)
    {
      for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '\\');
      return text;
    }
  } // namespace

  std::string explain(const std::string &wanted)
  {
    std::string all;
    std::vector<std::string> known;
    for (const Section &section : sections())
    {
      all += (all.empty() ? "" : "\n") + entries(section);
      if (!section.name.empty() && section.name == wanted)
        return entries(section);
      known.push_back(section.name);
      for (const Key &key : section.keys)
      {
        known.push_back(full_name(section, key));
        if (known.back() == wanted)
          return entry(section, key);
      }
    }
    if (wanted.empty())
      return all;
    // A bare key, "mach", stands for every section that has one.
    std::string matches;
    for (const Section &section : sections())
      if (const Key *key = section.find(wanted))
        matches += (matches.empty() ? "" : "\n") + entry(section, *key);
    if (!matches.empty())
      return matches;
    const std::string hint = did_you_mean(wanted, known);
    throw BadScene("there is no key or section \"" + wanted + "\"" +
                   (hint.empty() ? "" : "; " + hint) +
                   "\n  remedy: --explain \"\" lists everything");
  }

  std::string manual()
  {
    std::string text =
        "# The scene language\n\nA scene is a TOML file. A section that is present switches its "
        "module on. Numbers are in SI or, with `[units] system = \"W0-tau0-sigmaY\"`, in lengths "
        "W0, times tau0, stresses sigma_Y. An expression is made of " +
        std::string(allowed_in_expressions) +
        "; smooth(t, T) rises from 0 to 1 over T, ramp(t, T) is its integral.\n";
    for (const Section &section : sections())
    {
      text += "\n## " + header_of(section) + "\n\n" + section.sentence + "\n";
      for (const Alternatives &choice : section.alternatives)
        text += std::string("\n") + (choice.required ? "Exactly" : "At most") +
                " one of: " + listed(choice.keys) + ".\n";
      text += "\n| key | kind | unit | range | default | meaning | why this default |\n"
              "|---|---|---|---|---|---|---|\n";
      for (const Key &key : section.keys)
        text += "| `" + key.name + "` | " + cell(key.kind) + " | " + units_of(key) + " | " +
                key.allowed.range.text() + " | " + cell(default_of(key)) + " | " +
                cell(key.sentence) + " | " + cell(key.reason) + " |\n";
    }
    text += "\n## Rules between keys\n\n";
    for (const Rule &rule : rules())
      text += "- " + rule.statement + "\n";
    return text;
  }
} // namespace scene
