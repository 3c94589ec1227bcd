# Precompiled headers: what most sources include from outside is parsed once per configuration.
#
# A source never relies on them: it includes what it uses, and CI builds everything once without them
# (the preset "clang" sets WEND_PRECOMPILE to OFF).

option(WEND_PRECOMPILE "Precompile the headers of dependencies" ${PROJECT_IS_TOP_LEVEL})

set(wend_precompiled_standard
    <algorithm>
    <array>
    <bit>
    <cassert>
    <cmath>
    <cstddef>
    <cstdint>
    <functional>
    <limits>
    <memory>
    <numeric>
    <optional>
    <set>
    <span>
    <string>
    <string_view>
    <tl/expected.hpp>
    <utility>
    <vector>)
set(wend_precompiled_text ${wend_precompiled_standard} <filesystem> <map> <fmt/format.h>
                          <nlohmann/json.hpp>)
set(wend_precompiled_test ${wend_precompiled_text} <gmock/gmock.h> <gtest/gtest.h>
                          <rapidcheck/gtest.h>)

# wend_precompile(<target> <standard|text|test>): the first target of a kind compiles the headers, the
# others use what it made. All targets of a kind are compiled with the same options.
function(wend_precompile target kind)
  if(NOT WEND_PRECOMPILE)
    return()
  endif()
  get_property(owner GLOBAL PROPERTY wend_precompiled_${kind}_owner)
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${wend_precompiled_${kind}})
    set_property(GLOBAL PROPERTY wend_precompiled_${kind}_owner ${target})
  endif()
endfunction()
