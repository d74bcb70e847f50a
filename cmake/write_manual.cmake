# SPDX-License-Identifier: MIT
# cmake -D PROGRAM=shigusa -D FOLDER=folder -P write_manual.cmake: writes the man pages and shell completions
# printed by the program below the folder: man1/, bash/shigusa, zsh/_shigusa, fish/shigusa.fish.
function(print_into file)
  cmake_path(GET file PARENT_PATH above)
  file(MAKE_DIRECTORY ${above})
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# otherwise the page of a removed command would stay
file(REMOVE_RECURSE ${FOLDER}/man1)
execute_process(COMMAND ${PROGRAM} manual --as man --out ${FOLDER}/man1 COMMAND_ERROR_IS_FATAL ANY)
print_into(${FOLDER}/bash/shigusa completion bash)
print_into(${FOLDER}/zsh/_shigusa completion zsh)
print_into(${FOLDER}/fish/shigusa.fish completion fish)
file(TOUCH ${FOLDER}/written)
