# interrupt.sh PROGRAM SIGNAL... : starts a design, sends it the first signal after its first line on
# stderr that is of the search and any others while it is still there, and ends with its exit code.
# While it still reads, which a busy machine lets it say, there is no design to leave and it just ends.
program=$1
shift
set -m # jobs of a script without job control ignore SIGINT
exec 3>&1
exec 4< <(LD_PRELOAD="$PRELOAD" exec "$program" design knot.obj -o out 2>&1 >&3)
process=$!
while read -r line <&4 && [[ $line == *reading* ]]; do :; done
kill "-$1" "$process"
shift
for signal in "$@"; do
  sleep 1
  kill "-$signal" "$process"
done
cat <&4 >/dev/null
wait "$process"
