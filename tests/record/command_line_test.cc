#include "record/command_line.h"

#include <gtest/gtest.h>

namespace
{
  record::Parsed parse(std::vector<const char *> arguments)
  {
    arguments.insert(arguments.begin(), "mpm_pf");
    return record::parse_command_line(static_cast<int>(arguments.size()), arguments.data(),
                                      "mpm_pf", "a solver");
  }
} // namespace

TEST(CommandLine, TellsTheVersion)
{
  const record::Parsed parsed = parse({"--version"});
  EXPECT_FALSE(parsed.command);
  EXPECT_EQ(parsed.exit_code, record::all_right);
  EXPECT_EQ(parsed.text.rfind("mpm_pf ", 0), 0u) << parsed.text;
  EXPECT_NE(parsed.text.find("commit "), std::string::npos) << parsed.text;
}

TEST(CommandLine, RefusesARecordWithoutANameOfItsOwn)
{
  for (const char *name : {"", "a/b"})
  {
    const record::Parsed parsed = parse({"in.toml", "--record", name});
    EXPECT_FALSE(parsed.command) << '"' << name << '"';
    EXPECT_EQ(parsed.exit_code, record::bad_input);
  }
  ASSERT_TRUE(parse({"in.toml", "--record", "run"}).command);
}

TEST(CommandLine, TakesOneOverrideAfterEachSet)
{
  const record::Parsed parsed = parse({"--set", "a.b=1", "--set", "a.c=[2, 3]", "in.toml"});
  ASSERT_TRUE(parsed.command);
  EXPECT_EQ(parsed.command->overrides, (std::vector<std::string>{"a.b=1", "a.c=[2, 3]"}));
  EXPECT_EQ(parsed.command->scene, "in.toml");
  EXPECT_EQ(parse({"--help"}).text.find("TEXT ..."), std::string::npos) << "as if it took several";
}

TEST(CommandLine, RefusesASettingThatNamesNoKey)
{
  for (const char *setting : {"", "=1", "accuracy"})
  {
    const record::Parsed parsed = parse({"in.toml", "--set", setting});
    EXPECT_FALSE(parsed.command) << '"' << setting << '"';
    EXPECT_EQ(parsed.exit_code, record::bad_input);
    EXPECT_NE(parsed.text.find("section.key=value"), std::string::npos) << parsed.text;
  }
  EXPECT_TRUE(parse({"in.toml", "--set", "domain.cells="}).command); // takes the key away
}
