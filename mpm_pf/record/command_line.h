// The command line that both solvers share, so that a campaign can treat them alike.
//
//   PROGRAM SCENE [--set key=value]... [--output DIR] [--threads N] [--plan] [--resume] [--force]
//   [--explain KEY]
//
// Exit codes are the same everywhere: see ExitCode.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace record
{
  enum ExitCode : int
  {
    all_right = 0,
    comparison_failed = 1,
    bad_input = 2,
    numerical_trouble = 3,
    reference_missing = 4,
    drift_only = 5,
    not_written = 6, // a full disk and the like: neither the scene nor its numbers are to blame
    interrupted = 130
  };

  struct CommandLine
  {
    std::string scene;
    std::vector<std::string> overrides; // "section.key=value"
    std::string output;                 // directory of the record; default: results/<scene stem>
    std::string record;                 // name of the record without ".h5"; default: the program's
    int threads = 1;
    bool plan = false, resume = false, force = false;
    std::optional<std::string> explain; // a key, a section, or "" for everything
    std::string joined;                 // argv as one line, for provenance and for "repeat with"

    std::string record_path() const { return output + "/" + record + ".h5"; }
  };

  /// Parse argv of `program`. A wrong option, --help or --version ends in `exit_code` with the text
  /// to print instead of a command line.
  struct Parsed
  {
    std::optional<CommandLine> command;
    int exit_code = all_right;
    std::string text;
  };
  Parsed parse_command_line(int argc, const char *const *argv, const std::string &program,
                            const std::string &description);

  /// argv[0] + `arguments` quoted for a shell, so that a printed command can be pasted.
  std::string shell_quoted(const std::vector<std::string> &arguments);
} // namespace record
