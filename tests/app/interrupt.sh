# Starts a design, interrupts it after its first line on stderr and ends with its exit code.
set -m # jobs of a script without job control ignore SIGINT
exec 3>&1
exec 4< <(exec "$1" design knot.obj -o out 2>&1 >&3)
program=$!
read -r first <&4
kill -INT "$program"
cat <&4 >/dev/null
wait "$program"
