# wend_load_drawing_late(<target>): the program loads cairo and chafa when it draws for the first time, instead of
# linking them and the 20 libraries that they need each time it starts. Where that is not possible, it links them.
function(wend_load_drawing_late target)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND CMAKE_READELF)
    set(folder "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
    set(stubs "${CMAKE_CURRENT_BINARY_DIR}/${target}_stubs.cpp")
    add_custom_command(
      OUTPUT "${stubs}"
      COMMAND "${folder}/write_stubs" "${stubs}" "${CMAKE_NM}" "${CMAKE_READELF}" "$<TARGET_FILE:wend_render>"
              cairo_ "${pkgcfg_lib_wend_cairo_cairo}" "\\(chafa\\|g\\)_" "${pkgcfg_lib_wend_chafa_chafa}"
      DEPENDS wend_render "${folder}/write_stubs" "${folder}/stub.s"
      COMMENT "Writing the stubs of cairo and chafa"
      VERBATIM)
    target_sources(${target} PRIVATE "${stubs}" "${folder}/load_function.cpp")
    set_source_files_properties("${stubs}" "${folder}/load_function.cpp" PROPERTIES SKIP_PRECOMPILE_HEADERS ON
                                                                                    SKIP_UNITY_BUILD_INCLUSION ON)
    target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
  else()
    target_link_libraries(${target} PRIVATE PkgConfig::wend_cairo PkgConfig::wend_chafa)
  endif()
endfunction()
