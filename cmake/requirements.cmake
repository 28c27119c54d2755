# What the build needs and CMake does not ask for by itself: said here in a sentence, not by the compiler after ten minutes.

if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  message(FATAL_ERROR "mpm_pf is written for Linux (it reads /proc and starts process groups), not for ${CMAKE_SYSTEM_NAME}: "
    "build it in a Debian 12 container or virtual machine.")
endif()

include(CheckCXXSymbolExists)
check_cxx_symbol_exists(__GLIBC__ "features.h" MPM_PF_GLIBC)
if(NOT MPM_PF_GLIBC)
  message(WARNING "The C library is not glibc: nobody has built mpm_pf with another one (malloc.h, prctl and the order of sums in libm differ).")
endif()

set(MPM_PF_KNOWN_COMPILER OFF) # the one that every commit is built with
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
    message(FATAL_ERROR "GCC ${CMAKE_CXX_COMPILER_VERSION} is too old: the vectors of mpm_pf/solid/wide.h need GCC 12 or newer; "
      "name one with -DCMAKE_CXX_COMPILER=g++-12.")
  elseif(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    set(MPM_PF_KNOWN_COMPILER ON)
  endif()
elseif(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(WARNING "mpm_pf is built with GCC 12 and uses its vector types and builtins, which Clang knows too; "
    "nobody has tried ${CMAKE_CXX_COMPILER_ID}.")
endif()

# require_header(NAME HEADER PACKAGE): NAME_INCLUDE_DIR holds HEADER of a library; stops the configuration where it is missing.
function(require_header name header package)
  find_path(${name}_INCLUDE_DIR ${header})
  if(NOT ${name}_INCLUDE_DIR)
    message(FATAL_ERROR "${header} of ${name} is missing: install ${package} (its name in Debian), "
      "or say where it is with -D${name}_INCLUDE_DIR=FOLDER.")
  endif()
endfunction()

# require_library(NAME LIBRARY PACKAGE): the same of the library itself, NAME_LIBRARY.
function(require_library name library package)
  find_library(${name}_LIBRARY ${library})
  if(NOT ${name}_LIBRARY)
    message(FATAL_ERROR "The library ${library} is missing: install ${package} (its name in Debian), "
      "or say where it is with -D${name}_LIBRARY=FILE.")
  endif()
endfunction()
