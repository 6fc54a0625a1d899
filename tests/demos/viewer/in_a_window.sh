# Shared parts of the tests of polhode_viewer in a window, on their own display. Source it with the viewer's path as $1.
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

wait_for() { # FILE
  for _ in $(seq 100); do
    [ ! -s "$1" ] || return 0
    sleep 0.1
  done
  echo "there is no $(basename "$1") after ten seconds" >&2
  exit 1
}

wait_for "$directory/display"
DISPLAY=:$(cat "$directory/display")
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1

open_viewer() { # OPTION...
  "$viewer" "$@" &
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
  wait "$viewer_process" # returns its exit code
  viewer_process=
}

expect_steps() { # RECORDING LEAST MOST
  local steps=$(($(wc -l <"$1") - 2)) # without the header and the start
  if [ "$steps" -lt "$2" ] || [ "$steps" -gt "$3" ]; then
    echo "$(basename "$1"): $steps steps, expected $2 to $3" >&2
    exit 1
  fi
}
