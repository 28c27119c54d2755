// explain() and manual(): the tables of keys.h as text.
#include <algorithm>
#include <cctype>

#include "scene/expression.h"
#include "scene/formula_words.h"
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
      if (!key.required)
        return key.default_text.empty() ? "absent" : key.default_text;
      return "none, must be given" +
             (key.chosen_by.empty() ? "" : " unless " + key.chosen_by + " chooses it");
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
                " one of: " + comma_separated(choice.keys) + "\n";
      for (const Key &key : section.keys)
        text += "\n" + entry(section, key);
      return text;
    }

    std::string unit_of(const Quantity &quantity)
    {
      const std::string si = column_unit(dimension_of(quantity.name), Units::si);
      const std::string own = column_unit(dimension_of(quantity.name), Units::w0_tau0_sigma_y);
      return si == own ? si : si + " (in W0-tau0-sigmaY: " + own + ")";
    }

    std::string entry(const ExpressionWord &word)
    {
      return word.form + "\n  " + word.sentence + "\n";
    }

    std::string entry(const Quantity &quantity)
    {
      return quantity.name + "\n  " + quantity.sentence + "\n  kind:    a quantity for probe.of\n" +
             "  unit:    " + unit_of(quantity) + "\n";
    }

    /// Words and quantities of that name; all of them, under headings, for "".
    std::string entries_of_formulas(const std::string &wanted)
    {
      std::string words, quantities;
      for (const ExpressionWord &word : expression_words())
        if (wanted.empty() || word.name == wanted)
          words += entry(word);
      for (const Quantity &quantity : probe_quantities())
        if (wanted.empty() || quantity.name == wanted)
          quantities += entry(quantity);
      return wanted.empty() ? "\nWords of an expression\n\n" + words +
                                  "\nQuantities of a probe\n\n" + quantities
                            : words + quantities;
    }

    /// Does the sentence have this whole word? Symbols (E, nu, D) with their case, longer ones
    /// however they are written.
    bool mentions(const std::string &sentence, const std::string &word)
    {
      const bool symbol = word.size() <= 2;
      const auto same = [symbol](const char a, const char b)
      {
        const auto lower = [](const char c) { return std::tolower(static_cast<unsigned char>(c)); };
        return symbol ? a == b : lower(a) == lower(b);
      };
      const auto inside_word = [&sentence](const std::size_t at)
      {
        return at < sentence.size() &&
               (std::isalnum(static_cast<unsigned char>(sentence[at])) || sentence[at] == '_');
      };
      for (auto from = sentence.begin(); from != sentence.end(); ++from)
      {
        from = std::search(from, sentence.end(), word.begin(), word.end(), same);
        if (from == sentence.end())
          return false;
        const std::size_t at = from - sentence.begin();
        if (!(at > 0 && inside_word(at - 1)) && !inside_word(at + word.size()))
          return true;
      }
      return false;
    }

    /// Sections and keys whose sentence mentions it: what is called otherwise here.
    std::vector<std::string> names_that_mention(const std::string &word)
    {
      std::vector<std::string> names;
      for (const Section &section : sections())
      {
        if (!section.name.empty() && mentions(section.sentence, word))
          names.push_back(section.name);
        for (const Key &key : section.keys)
          if (mentions(key.sentence, word))
            names.push_back(full_name(section, key));
      }
      return names;
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
        known.push_back(key.name);
      }
    }
    if (wanted.empty())
      return all + entries_of_formulas("");
    // A bare key, "mach", stands for every section that has one.
    std::string matches;
    for (const Section &section : sections())
      if (const Key *key = section.find(wanted))
        matches += (matches.empty() ? "" : "\n") + entry(section, *key);
    matches += entries_of_formulas(wanted);
    if (!matches.empty())
      return matches;
    for (const ExpressionWord &word : expression_words())
      known.push_back(word.name);
    for (const Quantity &quantity : probe_quantities())
      known.push_back(quantity.name);
    const std::string hint = did_you_mean(wanted, known);
    const std::vector<std::string> related = names_that_mention(wanted);
    throw BadScene("there is no key, section, function or quantity \"" + wanted + "\"" +
                   (hint.empty() ? "" : "; " + hint) +
                   (related.empty() ? "" : "; mentioned under " + comma_separated(related)) +
                   "\n  remedy: --explain all lists everything");
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
                " one of: " + comma_separated(choice.keys) + ".\n";
      text += "\n| key | kind | unit | range | default | meaning | why this default |\n"
              "|---|---|---|---|---|---|---|\n";
      for (const Key &key : section.keys)
        text += "| `" + key.name + "` | " + cell(key.kind) + " | " + units_of(key) + " | " +
                key.allowed.range.text() + " | " + cell(default_of(key)) + " | " +
                cell(key.sentence) + " | " + cell(key.reason) + " |\n";
    }
    text += "\n## Words of an expression\n\n| word | meaning |\n|---|---|\n";
    for (const ExpressionWord &word : expression_words())
      text += "| `" + cell(word.form) + "` | " + cell(word.sentence) + " |\n";
    text += "\n## Quantities of a probe\n\n| quantity | unit | meaning |\n|---|---|---|\n";
    for (const Quantity &quantity : probe_quantities())
      text += "| `" + quantity.name + "` | " + unit_of(quantity) + " | " + cell(quantity.sentence) +
              " |\n";
    text += "\n## Rules between keys\n\n";
    for (const Rule &rule : rules())
      text += "- " + rule.statement + "\n";
    return text;
  }
} // namespace scene
