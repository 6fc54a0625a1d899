#!/usr/bin/env bash
# Presses every key of polhode_viewer in a window on a display of its own, and looks at the recordings that it leaves.
#   every_key.sh VIEWER
set -euo pipefail
viewer=$1
directory=$(mktemp -d)
cleanup() {
  [ -z "${viewer_process:-}" ] || kill "$viewer_process" 2>/dev/null || true
  kill "$display_process" 2>/dev/null || true
  rm -rf "$directory"
}
trap cleanup EXIT

Xvfb -displayfd 3 -screen 0 1280x1024x24 3>"$directory/display" 2>"$directory/xvfb" &
display_process=$!
for _ in $(seq 100); do
  [ ! -s "$directory/display" ] || break
  sleep 0.1
done
DISPLAY=:$(cat "$directory/display")
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1

open_viewer() { # RECORDING [OPTION...]
  "$viewer" --contender exact --width 900 --height 700 --record "$@" &
  viewer_process=$!
  window=$(timeout 30 xdotool search --sync --onlyvisible --name polhode_viewer | head -n 1)
  xdotool windowfocus --sync "$window"
  sleep 1
}

press() { # KEY...
  for key in "$@"; do
    xdotool key "$key"
    sleep 0.1
  done
}

close_viewer() {
  press Escape
  wait "$viewer_process" # its exit code is ours
  viewer_process=
}

expect_steps() { # RECORDING LEAST MOST
  local steps=$(($(wc -l <"$1") - 2)) # without header and start
  if [ "$steps" -lt "$2" ] || [ "$steps" -gt "$3" ]; then
    echo "$(basename "$1"): $steps steps, expected $2 to $3" >&2
    exit 1
  fi
}

open_viewer "$directory/stepped"
press Left Right Right Right Right Right Left Left h H F1 F1 t T p P f F Home plus minus equal
xdotool mousemove 600 300 mousedown 1 mousemove_relative 50 20 mouseup 1 click 4 click 5
close_viewer
expect_steps "$directory/stepped" 3 3

open_viewer "$directory/played" --scenario tumble
press space
sleep 2
press space
close_viewer
expect_steps "$directory/played" 20 2000

open_viewer "$directory/reset" --scenario tumble --at 1
press space space r Right
close_viewer
expect_steps "$directory/reset" 1 1
echo "every key does what it should"
