# Writes commit.h (OUTPUT) with the commit of SOURCE and whether its tracked files differ from it.
# Runs at every build; touches the header only when it would change, so that nothing else rebuilds.
# Without git, or outside a repository, the commit is "unknown" and the build goes on.
set(commit "unknown")
set(dirty "unknown")
find_program(GIT git)
if(GIT)
  # "safe.directory" lets a checkout that belongs to another user (a container's root) be asked.
  set(ask ${GIT} -c "safe.directory=${SOURCE}" -C "${SOURCE}")
  execute_process(COMMAND ${ask} rev-parse HEAD OUTPUT_VARIABLE answer RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(commit "${answer}")
    execute_process(COMMAND ${ask} --no-optional-locks status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes RESULT_VARIABLE failed ERROR_QUIET)
    if(NOT failed)
      set(dirty "no")
      if(changes)
        set(dirty "yes")
      endif()
    endif()
  endif()
endif()

set(text "#define MPM_PF_COMMIT \"${commit}\"\n#define MPM_PF_DIRTY \"${dirty}\"\n")
set(before "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT text STREQUAL before)
  file(WRITE "${OUTPUT}" "${text}")
endif()
