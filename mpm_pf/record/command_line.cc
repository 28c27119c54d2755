#include "record/command_line.h"

#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>

#include "record/provenance.h"

namespace record
{
  std::string shell_quoted(const std::vector<std::string> &arguments)
  {
    std::string line;
    for (const auto &argument : arguments)
    {
      const bool plain =
          !argument.empty() &&
          argument.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                     "0123456789_-+=./:,@%") == std::string::npos;
      line += line.empty() ? "" : " ";
      if (plain)
        line += argument;
      else
      {
        line += '\'';
        for (const char c : argument)
          line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
      }
    }
    return line;
  }

  namespace
  {
    void add_set(CLI::App &app, CommandLine &command)
    {
      app.add_option("--set", command.overrides, "override a key: section.key=value")
          ->allow_extra_args(false)
          ->check(CLI::Validator(
              [](const std::string &setting) -> std::string
              {
                const std::size_t equals = setting.find('=');
                const bool right = equals != std::string::npos && equals > 0;
                return right ? "" : "section.key=value, not \"" + setting + "\"";
              },
              "KEY=VALUE"))
          ->option_text("KEY=VALUE (again for more)");
    }

    void add_name_and_version(CLI::App &app, CommandLine &command, const std::string &program)
    {
      app.add_option("--record", command.record, "name of the record (default: " + program + ")")
          ->check(CLI::Validator(
              [](const std::string &name) -> std::string
              {
                const bool right = !name.empty() && name.find('/') == std::string::npos;
                return right ? ""
                             : "a name without '/', not \"" + name + "\"; folders go to --output";
              },
              "NAME"));
      const Provenance made = collect_provenance(program, "", 1);
      app.set_version_flag("--version", program + " " + made.at("version") + ", commit " +
                                            made.at("commit") +
                                            (made.at("dirty") == "yes" ? " with changes" : ""));
    }
  } // namespace

  Parsed parse_command_line(const int argc, const char *const *argv, const std::string &program,
                            const std::string &description)
  {
    CommandLine command;
    command.record = program;
    CLI::App app(description, program);
    std::string explain;
    app.add_option("scene", command.scene, "scene file (TOML)");
    add_set(app, command);
    app.add_option("--output", command.output,
                   "directory of the record (default: results/<scene>)");
    add_name_and_version(app, command, program);
    app.add_option("--threads", command.threads, "threads (default: 1)")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--plan", command.plan, "say what would be done, at what cost, and stop");
    app.add_flag("--resume", command.resume, "go on from the last checkpoint");
    app.add_flag("--force", command.force, "overwrite a record; run past a refused step limit");
    const auto *explained =
        app.add_option("--explain", explain,
                       "manual entry of a key, a section, a function or a quantity, or 'all'")
            ->expected(0, 1);
    Parsed parsed;
    try
    {
      app.parse(argc, argv);
    }
    catch (const CLI::CallForHelp &)
    {
      parsed.text = app.help();
      return parsed;
    }
    catch (const CLI::CallForVersion &version)
    {
      parsed.text = std::string(version.what()) + "\n";
      return parsed;
    }
    catch (const CLI::ParseError &error)
    {
      parsed.exit_code = bad_input; // CLI11's own codes start at 100
      parsed.text = program + ": " + error.what() + "\n" + app.help();
      return parsed;
    }
    if (explained->count() > 0)
      command.explain = explain == "all" ? "" : explain;
    else if (command.scene.empty())
    {
      parsed.exit_code = bad_input;
      parsed.text = program + ": no scene given\n" + app.help();
      return parsed;
    }
    if (command.output.empty())
      command.output = "results/" + std::filesystem::path(command.scene).stem().string();
    command.joined = shell_quoted(std::vector<std::string>(argv, argv + argc));
    parsed.command = command;
    return parsed;
  }
} // namespace record
