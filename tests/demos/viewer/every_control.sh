#!/usr/bin/env bash
# Uses every control of polhode_viewer's panel with a mouse, and checks the files that it writes.
#   every_control.sh VIEWER
set -euo pipefail
# shellcheck source=tests/demos/viewer/in_a_window.sh
source "$(dirname "$0")/in_a_window.sh"

click() { # CONTROL..., by its position in the panel, in pixels
  for control in "$@"; do
    # shellcheck disable=SC2086 # two numbers
    xdotool mousemove ${place[$control]} mousedown 1
    sleep 0.1
    xdotool mouseup 1
    sleep 0.1
  done
}

enter() { # CONTROL TEXT
  click "$1"
  xdotool keydown ctrl keydown a # for a frame or two
  sleep 0.2
  xdotool keyup a keyup ctrl type --delay 50 "$2"
  press Tab
}

expect_in() { # FILE PATTERN
  wait_for "$1"
  if ! grep -Eq "$2" "$1"; then
    echo "$(basename "$1") does not have $2 but begins" >&2
    head -c 1000 "$1" >&2
    exit 1
  fi
}

declare -A place=([scenarios]="165 41" [fast_spinner]="60 149" [run]="40 106" [start_over]="118 106"
  [step_back]="192 106" [step]="255 106" [slower]="37 133" [faster]="97 133" [teaching]="20 159" [follow]="20 185"
  [exact]="40 236" [matrix]="40 262" [bullet]="40 366" [dt]="100 677" [inertia]="55 723" [omega]="55 769"
  [apply]="82 795" [undo]="185 795" [csv_file]="100 846" [write_csv]="246 846" [png_file]="100 872" [write_png]="247 872"
  [recording_file]="100 898" [record]="236 898")

cd "$directory"
# Hardly wider than the panel, so that frames are drawn fast and none misses a click.
open_viewer --contender exact --width 340 --height 980 --record closed.txt
click step step step step_back teaching follow slower faster faster
click matrix bullet matrix step step write_csv write_png record
expect_in polhode_run.txt '"contenders":\["exact","bullet"\].*"dt":0.03'
expect_steps polhode_run.txt 2 2
expect_in polhode.csv '^exact,2,'
expect_in polhode.csv '^bullet,2,'
[ "$(head -c 8 polhode.png | od -An -tx1)" = " 89 50 4e 47 0d 0a 1a 0a" ]

enter dt 0.5
click undo apply
enter dt 0.01
enter inertia 30
enter omega 0.25
click apply step
enter recording_file changed.txt
click record
expect_in changed.txt '"dt":0.01,'
expect_steps changed.txt 1 1

enter dt 0
enter csv_file none/such.csv
enter png_file none/such.png
click apply write_csv write_png start_over run
sleep 2
click run
enter recording_file played.txt
click record
expect_in played.txt '"dt":0.01,'
expect_steps played.txt 20 2000

click scenarios fast_spinner; press Right
close_viewer
expect_in closed.txt '"name":"fast_spinner"'
expect_steps closed.txt 1 1
echo "every control does what it should"
