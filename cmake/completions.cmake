# Writes the completion scripts each time that the program is linked.

if(CMAKE_CROSSCOMPILING)
  return()
endif()

include(GNUInstallDirs)
# Each shell looks for a script of its own name.
set(completions "${PROJECT_BINARY_DIR}/completions")
add_custom_command(
  TARGET wend_bench_cli
  POST_BUILD
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${completions}"
  COMMAND wend_bench_cli completion bash > "${completions}/wend"
  COMMAND wend_bench_cli completion zsh > "${completions}/_wend"
  COMMAND wend_bench_cli completion fish > "${completions}/wend.fish"
  VERBATIM)
set(share "${CMAKE_INSTALL_DATADIR}")
install(FILES "${completions}/wend" DESTINATION "${share}/bash-completion/completions"
        COMPONENT program)
install(FILES "${completions}/_wend" DESTINATION "${share}/zsh/vendor-completions"
        COMPONENT program)
install(FILES "${completions}/wend.fish" DESTINATION "${share}/fish/vendor_completions.d"
        COMPONENT program)
