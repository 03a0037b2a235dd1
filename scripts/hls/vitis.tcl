# Vitis HLS: synthesizes one entry point. C simulation is the project's own (tests/top, scripts/portability.sh).
#   cd build && TOP=displace [PART=xcku5p-ffva676-3-e] [CLOCK=5] vitis_hls -f ../scripts/hls/vitis.tcl
# Never run here: the tool was not at hand. Written from its documentation.
set root [file normalize [file join [file dirname [info script]] .. ..]]
proc setting {name default} {
  if {[info exists ::env($name)]} { return $::env($name) }
  return $default
}
if {![info exists ::env(TOP)]} {
  puts stderr "vitis.tcl: TOP names the entry point, one of hls/top/*.cpp without its suffix"
  exit 2
}
set top $::env(TOP)

open_project -reset relievo_vitis_$top
set_top relievo_$top
# __SYNTHESIS__ is the tool's own macro: hls/core/synthesis.hpp takes the rest from it.
add_files [file join $root hls top $top.cpp] -cflags "-std=c++14 -I$root"
open_solution -reset solution -flow_target vivado
set_part [setting PART xcku5p-ffva676-3-e]
create_clock -period [setting CLOCK 5]
csynth_design
export_design -format ip_catalog
exit
