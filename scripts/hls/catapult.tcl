# Catapult: synthesizes one entry point.
#   cd build && TOP=displace [CLOCK=5] catapult -shell -file ../scripts/hls/catapult.tcl
# Never run here: the tool was not at hand. Written from its documentation.
set root [file normalize [file join [file dirname [info script]] .. ..]]
proc setting {name default} {
  if {[info exists ::env($name)]} { return $::env($name) }
  return $default
}
if {![info exists ::env(TOP)]} {
  puts stderr "catapult.tcl: TOP names the entry point, one of hls/top/*.cpp without its suffix"
  exit 2
}
set top $::env(TOP)

options set Input/CppStandard c++14
options set Input/CompilerFlags "-DRELIEVO_SYNTHESIS -DRELIEVO_AC_FIXED"
options set Input/SearchPath $root
project new -name relievo_catapult_$top
solution file add [file join $root hls top $top.cpp] -type C++
go analyze
solution design set relievo_$top -top
go compile
solution library add nangate-45nm_beh
solution library add ccs_sample_mem
go libraries
directive set -CLOCKS [list clk [list -CLOCK_PERIOD [setting CLOCK 5]]]
go assembly
# The interval that the entry point names in its pragma; none where it names none (the engine).
set source [open [file join $root hls top $top.cpp]]
set text [read $source]
close $source
if {[regexp {PIPELINE II=(\d+)} $text -> interval]} {
  directive set /relievo_$top/core/main -PIPELINE_INIT_INTERVAL $interval
}
go architect
go extract
project save
