# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE=DIR -DOUTPUT=FILE -P JounceCommit.cmake: writes the commit of DIR into the header FILE, if it has changed.
# Without git, or if DIR is only a folder of another repository, there is no commit.
function(git out)
  set(ENV{GIT_OPTIONAL_LOCKS} 0)
  execute_process(COMMAND git -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE text RESULT_VARIABLE status
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(text "")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

git(top rev-parse --show-toplevel)
file(REAL_PATH ${SOURCE} source)
set(commit "")
set(date "")
set(changed false)
if(top STREQUAL source)
  git(commit log -1 --format=%H)
  string(SUBSTRING "${commit}" 0 12 commit)
  git(date log -1 --format=%cs)
  git(changes status --porcelain --untracked-files=no)
  if(changes)
    set(changed true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n#define JOUNCE_COMMIT \"${commit}\"\n#define JOUNCE_COMMIT_DATE \"${date}\"\n#define JOUNCE_COMMIT_CHANGED ${changed}\n")
