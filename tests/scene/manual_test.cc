// The tables speak for themselves: every key has its sentence, every default its reason.
#include <gtest/gtest.h>

#include "scene/error_list.h"
#include "scene/expression.h"
#include "scene/formula_words.h"
#include "scene/keys.h"
#include "scene/quantities.h"
#include "scene/reader.h"
#include "scene/rules.h"

TEST(KeyTables, GiveEveryKeyASentenceAndEveryDefaultAReason)
{
  for (const scene::Section &section : scene::sections())
  {
    EXPECT_FALSE(section.sentence.empty()) << section.name;
    for (const scene::Key &key : section.keys)
    {
      EXPECT_FALSE(key.sentence.empty()) << section.name << "." << key.name;
      EXPECT_TRUE(key.required || !key.reason.empty()) << section.name << "." << key.name;
      EXPECT_TRUE(section.find(key.name) == &key) << key.name << " is declared twice";
    }
  }
}

TEST(KeyTables, KeepDefaultsInsideTheirRanges)
{
  for (const scene::Section &section : scene::sections())
    for (const scene::Key &key : section.keys)
    {
      if (key.kind == "a number" && !key.default_text.empty())
      {
        EXPECT_TRUE(key.allowed.range.holds(std::stod(key.default_text)))
            << section.name << "." << key.name << " = " << key.default_text;
      }
    }
}

TEST(Explain, PrintsUnitRangeDefaultAndReason)
{
  const std::string text = scene::explain("growth.step_fraction");
  EXPECT_NE(text.find("default: 0.8"), std::string::npos) << text;
  EXPECT_NE(text.find("at most 0.95"), std::string::npos) << text;
  const std::string modulus = scene::explain("solid.young_modulus");
  EXPECT_NE(modulus.find("Pa (in W0-tau0-sigmaY: sigma_Y)"), std::string::npos) << modulus;
  EXPECT_NE(modulus.find("must be given"), std::string::npos) << modulus;
}

TEST(Explain, TakesSectionsBareKeysAndEverything)
{
  EXPECT_NE(scene::explain("mpm").find("mpm.points_per_cell"), std::string::npos);
  const std::string both = scene::explain("cells"); // domain and fe have one
  EXPECT_NE(both.find("domain.cells"), std::string::npos);
  EXPECT_NE(both.find("fe.cells"), std::string::npos);
  EXPECT_GT(scene::explain("").size(), scene::explain("mpm").size());
}

TEST(Explain, KnowsTheFunctionsOfExpressionsAndTheQuantitiesOfProbes)
{
  EXPECT_NE(scene::explain("ramp").find("ramp(t, T)\n"), std::string::npos);
  const std::string stress = scene::explain("stress_xy");
  EXPECT_NE(stress.find("unit:    Pa (in W0-tau0-sigmaY: sigma_Y)"), std::string::npos) << stress;
  const std::string all = scene::explain(""), page = scene::manual();
  for (const char *word : {"ramp(t, T)", "sin(a)", "von_mises", "crystal_angle"})
  {
    EXPECT_NE(all.find(std::string("\n") + word + "\n"), std::string::npos) << word;
    EXPECT_NE(page.find(std::string("| `") + word + "` | "), std::string::npos) << word;
  }
}

TEST(Explain, SaysThatAnAccuracyMayChooseTheCells)
{
  const std::string cells = scene::explain("domain.cells"), size = scene::explain("domain.size");
  EXPECT_NE(cells.find("must be given unless accuracy chooses it"), std::string::npos) << cells;
  EXPECT_EQ(size.find("unless"), std::string::npos) << size;
}

TEST(ExpressionWords, AreUnderstoodAsTheyAreWritten)
{
  for (const scene::ExpressionWord &word : scene::expression_words())
  {
    // The names that stand for any number get one.
    std::string text = word.form;
    for (const auto &[any, number] : {std::pair{"(a", "(0.5"}, {", b", ", 0.25"}, {", T", ", 2"}})
      if (const auto at = text.find(any); at != std::string::npos)
        text.replace(at, std::string(any).size(), number);
    scene::Expression expression;
    expression.text = text;
    EXPECT_NO_THROW(scene::Function{expression}) << word.form;
    EXPECT_NE(text.find(word.name), std::string::npos) << word.form;
  }
}

TEST(Quantities, HaveASentenceEach)
{
  std::vector<std::string> known(scene::solid_quantities.begin(), scene::solid_quantities.end());
  known.insert(known.end(), scene::melt_quantities.begin(), scene::melt_quantities.end());
  std::vector<std::string> told;
  for (const scene::Quantity &quantity : scene::probe_quantities())
    told.push_back(quantity.name);
  EXPECT_EQ(told, known);
}

TEST(Explain, NamesTheNearestKey)
{
  try
  {
    scene::explain("mpm.mahc");
    FAIL();
  }
  catch (const scene::BadScene &error)
  {
    EXPECT_NE(std::string(error.what()).find("did you mean \"mpm.mach\"?"), std::string::npos)
        << error.what();
  }
}

TEST(Explain, NamesTheKeysThatMentionAWord)
{
  const auto error_of = [](const std::string &word) -> std::string
  {
    try
    {
      return scene::explain(word);
    }
    catch (const scene::BadScene &error)
    {
      return error.what();
    }
  };
  EXPECT_NE(error_of("Gravity").find("body_force"), std::string::npos);
  EXPECT_NE(error_of("E").find("under solid.young_modulus"), std::string::npos) << error_of("E");
  EXPECT_NE(error_of("eps").find("growth.anisotropy"), std::string::npos);
  EXPECT_EQ(error_of("ravit").find("mentioned"), std::string::npos) << "part of a word";
  EXPECT_EQ(error_of("e").find("young_modulus"), std::string::npos) << "a symbol has its case";
}

TEST(Manual, HasARowForEveryKeyAndALineForEveryRule)
{
  const std::string text = scene::manual();
  for (const scene::Section &section : scene::sections())
    for (const scene::Key &key : section.keys)
      EXPECT_NE(text.find("| `" + key.name + "` | "), std::string::npos) << key.name;
  for (const scene::Rule &rule : scene::rules())
    EXPECT_NE(text.find("- " + rule.statement), std::string::npos) << rule.statement;
}

TEST(DidYouMean, FindsTyposAndSwapsButNotStrangers)
{
  const std::vector<std::string> known{"young_modulus", "poisson_ratio", "density"};
  EXPECT_EQ(scene::did_you_mean("youngs_modulus", known), "did you mean \"young_modulus\"?");
  EXPECT_EQ(scene::did_you_mean("dnesity", known), "did you mean \"density\"?");
  EXPECT_EQ(scene::did_you_mean("viscosity", {"width", "cells"}), "");
  EXPECT_EQ(scene::did_you_mean("x", {"density"}), "");
}
