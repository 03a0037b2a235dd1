# rtl_<unit>: tests/<tree>/<unit>_rtl.cpp with the Verilated model of rtl/<tree>/<unit>.sv, one program a unit. A new file needs no line here.
# Variants of a module with other parameters: <unit>_rtl.cpp may begin with lines
#   // verilate: PREFIX NAME=VALUE ...
# one a variant; without any there is one model, V<unit>.
find_package(verilator HINTS /usr/share/verilator REQUIRED)
set(relievo_rtl ${CMAKE_SOURCE_DIR}/rtl)
set(relievo_rtl_packages
    ${relievo_rtl}/waivers.vlt ${relievo_rtl}/core/formats_pkg.sv ${relievo_rtl}/core/core_pkg.sv ${relievo_rtl}/surface/surface_pkg.sv ${relievo_rtl}/surface/memory_pkg.sv
    ${relievo_rtl}/edge/edge_pkg.sv)

# relievo_verilate(target prefix module.sv [NAME=VALUE...]): a static library with the Verilated model.
function(relievo_verilate target prefix source)
  get_filename_component(module ${source} NAME_WE)
  set(parameters)
  foreach(parameter ${ARGN})
    list(APPEND parameters -G${parameter})
  endforeach()
  add_library(${target} STATIC)
  verilate(${target} PREFIX ${prefix} TOP_MODULE ${module} SOURCES ${relievo_rtl_packages} ${source}
           VERILATOR_ARGS -Wall --x-initial unique --x-assign unique -O3 -y ${relievo_rtl}/core -y ${relievo_rtl}/surface -y ${relievo_rtl}/edge
                          ${parameters})
  target_compile_options(${target} PRIVATE -w)
  # Verilator's headers are not ours to warn about.
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  set_target_properties(${target} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${folders}")
endfunction()

file(GLOB rtl_tests CONFIGURE_DEPENDS core/*_rtl.cpp surface/*_rtl.cpp edge/*_rtl.cpp)
foreach(test ${rtl_tests})
  get_filename_component(name ${test} NAME_WE)
  get_filename_component(folder ${test} DIRECTORY)
  get_filename_component(tree ${folder} NAME)
  string(REGEX REPLACE "_rtl$" "" unit ${name})
  file(STRINGS ${test} variants REGEX "^// verilate: ")
  if(NOT variants)
    set(variants "// verilate: V${unit}")
  endif()
  set(models)
  foreach(variant ${variants})
    string(REPLACE "// verilate: " "" variant ${variant})
    separate_arguments(variant)
    list(POP_FRONT variant prefix)
    relievo_verilate(model_${prefix} ${prefix} ${relievo_rtl}/${tree}/${unit}.sv ${variant})
    list(APPEND models model_${prefix})
  endforeach()
  add_executable(rtl_${unit} ${test} support/main.cpp)
  target_link_libraries(rtl_${unit} PRIVATE ${models} relievo_test_options)
  set_target_properties(rtl_${unit} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/rtl)
  gtest_discover_tests(rtl_${unit} TEST_PREFIX rtl. PROPERTIES LABELS "unit;rtl" DISCOVERY_TIMEOUT 60)
endforeach()
