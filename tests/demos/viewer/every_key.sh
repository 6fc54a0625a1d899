#!/usr/bin/env bash
# Presses every key of polhode_viewer in a window, and checks the recordings that it writes.
#   every_key.sh VIEWER
set -euo pipefail
# shellcheck source=tests/demos/viewer/in_a_window.sh
source "$(dirname "$0")/in_a_window.sh"

open_recorded() { # RECORDING [OPTION...]
  open_viewer --contender exact --width 480 --height 360 --record "$@"
}

open_recorded "$directory/stepped"
press Left Right Right Right Right Right Left Left h H F1 F1 t T p P f F Home plus minus equal
xdotool mousemove 400 120 mousedown 1 mousemove_relative 50 20 mouseup 1 click 4 click 5
close_viewer
expect_steps "$directory/stepped" 3 3

open_recorded "$directory/played" --scenario tumble
press space
sleep 2
press space
close_viewer
expect_steps "$directory/played" 20 2000

open_recorded "$directory/reset" --scenario tumble --at 1
press space space r Right
close_viewer
expect_steps "$directory/reset" 1 1
echo "every key does what it should"
